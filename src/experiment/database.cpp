#include "experiment/database.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <cstring>
#include <filesystem>

#include "waybreaker/error.hpp"

namespace waybreaker::experiment {
namespace {

int pragma(SQLite::Database& sql, const char* name) {
    return sql.execAndGet(fmt::format("PRAGMA {}", name)).getInt();
}

}  // namespace

Database::Database(const std::string& path, Access access) : path_(path), sql_(open(path, access)) {
    guarded([&] {
        // Run no code from a file of unknown origin; lock out other processes while writing.
        sql_.exec("PRAGMA trusted_schema = OFF");
        if (access != Access::read) sql_.exec("PRAGMA locking_mode = EXCLUSIVE; BEGIN EXCLUSIVE; COMMIT");
        require_ours(access);
    });
}

SQLite::Database Database::open(const std::string& path, Access access) {
    std::error_code error;
    const bool exists = std::filesystem::exists(path, error);
    if (!exists && access != Access::create) throw InputError("cannot read " + path + ": No such file or directory");
    if (std::filesystem::is_directory(path, error)) throw InputError(path + " is a folder; give a file name");
    try {
        return {path, access == Access::read ? SQLite::OPEN_READONLY : SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE};
    } catch (const SQLite::Exception& failure) {
        complain(path, failure);
    }
}

void Database::require_ours(Access access) {
    const int id = pragma(sql_, "application_id");
    is_new_ = id == 0 && sql_.execAndGet("SELECT count(*) FROM sqlite_schema").getInt() == 0;
    if (is_new_) {
        if (access == Access::create) return;
        throw InputError(path_, 0, "is empty: no experiment has stored its results here");
    }
    if (id != application_id) {
        throw InputError(path_, 0, "is a database of something else, not results of an experiment: give another file");
    }
    if (pragma(sql_, "user_version") != results_format) {
        throw InputError(path_, 0, "was written by another version of waybreaker, in a format unknown to this one");
    }
    const std::string check = sql_.execAndGet("PRAGMA quick_check(1)").getString();
    if (check != "ok") {
        throw InputError(path_, 0, "is damaged (" + check + "): restore it, or move it away and run again");
    }
}

void Database::complain(const std::string& path, const SQLite::Exception& error) {
    const int code = error.getErrorCode();
    switch (code) {
        case SQLITE_NOTADB:
            throw InputError(path, 0, "is not a file of results: give another name");
        case SQLITE_CORRUPT:
            throw InputError(path, 0, "is damaged: restore it, or move it away and run again");
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            throw InputError(path, 0, "is in use by another run: wait for its end, or give another file");
        case SQLITE_FULL:
            throw InputError("cannot write " + path +
                             ": the disk is full; what was stored is safe, run again when there is room");
        case SQLITE_IOERR:
            throw InputError(fmt::format("cannot write {}: {}; what was stored is safe", path, error.getErrorStr()));
        default:
            throw InputError(fmt::format("cannot use {}: {}", path, error.what()));
    }
}

}  // namespace waybreaker::experiment
