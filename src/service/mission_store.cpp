#include "service/mission_store.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <filesystem>

#include "core/one_line.hpp"
#include "http/problem.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::service {
namespace {

// In the header of every such file: "WBlv", and the version of the tables.
constexpr int application_id = 0x57426c76;
constexpr int store_format = 1;

constexpr auto tables = R"(
CREATE TABLE maps (id TEXT PRIMARY KEY, connectivity INTEGER NOT NULL, bytes BLOB NOT NULL) STRICT;
CREATE TABLE missions (id TEXT PRIMARY KEY, map TEXT NOT NULL, archive TEXT NOT NULL REFERENCES maps,
    digest TEXT NOT NULL, request TEXT NOT NULL) STRICT;
CREATE TABLE reports (mission TEXT NOT NULL REFERENCES missions ON DELETE CASCADE, sequence INTEGER NOT NULL,
    revision INTEGER NOT NULL, now REAL NOT NULL, status TEXT NOT NULL, state TEXT NOT NULL, plan TEXT,
    event TEXT NOT NULL, PRIMARY KEY (mission, sequence)) STRICT;
CREATE UNIQUE INDEX revisions ON reports (mission, revision) WHERE plan IS NOT NULL;
CREATE INDEX missions_of_map ON missions (archive);
)";

[[noreturn]] void refuse(const std::string& path, const SQLite::Exception& error) {
    switch (error.getErrorCode()) {
        case SQLITE_NOTADB:
            throw InputError(path, 0, "is no store of missions: give another file to --store");
        case SQLITE_CORRUPT:
            throw InputError(path, 0, "is damaged: restore it, or move it away and start anew");
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            throw InputError(path, 0, "is in use by another server: end that one, or give another file to --store");
        default:
            throw InputError(fmt::format("cannot use {} as a store: {}", path, error.what()));
    }
}

int pragma(SQLite::Database& sql, const char* name) {
    return sql.execAndGet(fmt::format("PRAGMA {}", name)).getInt();
}

SQLite::Database opened(const std::string& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) throw InputError(path + " is a folder; give --store a file");
    try {
        return {path.empty() ? ":memory:" : path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE};
    } catch (const SQLite::Exception& failure) {
        refuse(path, failure);
    }
}

// Whether it is empty. Throws InputError for what is no store.
bool require_ours(SQLite::Database& sql, const std::string& path) {
    const int id = pragma(sql, "application_id");
    if (id == 0 && sql.execAndGet("SELECT count(*) FROM sqlite_schema").getInt() == 0) return true;
    if (id != application_id) {
        throw InputError(path, 0,
                         "is a database of something else, no store of missions: give another file to --store");
    }
    if (pragma(sql, "user_version") != store_format) {
        throw InputError(path, 0,
                         "was written by another version of waybreaker, in a format unknown to this one: serve it with "
                         "that version, or give another file to --store");
    }
    const std::string check = sql.execAndGet("PRAGMA quick_check(1)").getString();
    if (check == "ok") return false;
    throw InputError(path, 0, "is damaged (" + one_line(check) + "): restore it, or move it away and start anew");
}

ReportRecord report_of(SQLite::Statement& row) {
    return {.sequence = std::uint64_t(row.getColumn(0).getInt64()),
            .revision = row.getColumn(1).getInt(),
            .now = row.getColumn(2).getDouble(),
            .status = row.getColumn(3).getString(),
            .state = row.getColumn(4).getString(),
            .plan = row.getColumn(5).getString(),
            .event = row.getColumn(6).getString()};
}

}  // namespace

MissionStore::MissionStore(const std::string& path) : path_(path), sql_(opened(path)) {
    try {
        // Run no code from a file of unknown origin; lock out other servers.
        sql_.exec("PRAGMA trusted_schema = OFF; PRAGMA locking_mode = EXCLUSIVE; BEGIN EXCLUSIVE; COMMIT");
        const bool is_new = require_ours(sql_, path_);
        if (is_new) sql_.exec("PRAGMA auto_vacuum = FULL");
        // A commit is on the disk when it returns; write-ahead, it costs one flush.
        sql_.exec("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON");
        if (is_new) begin();
        list_archive();
    } catch (const SQLite::Exception& error) {
        refuse(path_, error);
    }
}

void MissionStore::begin() {
    SQLite::Transaction transaction(sql_);
    sql_.exec(tables);
    sql_.exec(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", application_id, store_format));
    transaction.commit();
}

void MissionStore::list_archive() {
    std::map<std::string, bool> archived;
    SQLite::Statement query(sql_, "SELECT archive, max(map = archive) FROM missions GROUP BY archive");
    while (query.executeStep()) archived[query.getColumn(0).getString()] = query.getColumn(1).getInt() != 0;
    const std::scoped_lock lock(archive_mutex_);
    archived_ = std::move(archived);
}

// Runs `act` alone.
template <class Act>
auto MissionStore::guarded(Act act) {
    const std::scoped_lock lock(mutex_);
    try {
        return act();
    } catch (const SQLite::Exception& error) {
        const std::string why =
            error.getErrorCode() == SQLITE_FULL ? "the disk is full" : std::string(error.getErrorStr());
        throw http::Problem(http::unavailable,
                            "the server cannot use its store: " + why + "; what was acknowledged before is safe",
                            "store-unusable");
    }
}

std::vector<std::pair<MissionRecord, ReportRecord>> MissionStore::missions() {
    return guarded([&] {
        std::vector<std::pair<MissionRecord, ReportRecord>> all;
        SQLite::Statement query(sql_,
                                "SELECT sequence, revision, now, status, '', '', '', id, map, archive, digest FROM "
                                "missions JOIN reports ON mission = id WHERE sequence = (SELECT max(sequence) FROM "
                                "reports WHERE mission = id) ORDER BY id");
        while (query.executeStep()) {
            const MissionRecord mission{.id = query.getColumn(7).getString(),
                                        .map = query.getColumn(8).getString(),
                                        .archive = query.getColumn(9).getString(),
                                        .digest = query.getColumn(10).getString(),
                                        .request = {}};
            all.emplace_back(mission, report_of(query));
        }
        return all;
    });
}

MissionRecord MissionStore::mission(const std::string& id) {
    return guarded([&] {
        SQLite::Statement query(sql_, "SELECT map, archive, digest, request FROM missions WHERE id = ?");
        query.bind(1, id);
        if (!query.executeStep()) return MissionRecord{};
        return MissionRecord{.id = id,
                             .map = query.getColumn(0).getString(),
                             .archive = query.getColumn(1).getString(),
                             .digest = query.getColumn(2).getString(),
                             .request = query.getColumn(3).getString()};
    });
}

void MissionStore::insert(const std::string& mission, const ReportRecord& report) {
    SQLite::Statement statement(sql_, "INSERT INTO reports VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
    int at = 0;
    statement.bind(++at, mission);
    statement.bind(++at, std::int64_t(report.sequence));
    statement.bind(++at, report.revision);
    statement.bind(++at, report.now);
    statement.bind(++at, report.status);
    statement.bind(++at, report.state);
    report.plan.empty() ? statement.bind(++at) : statement.bind(++at, report.plan);
    statement.bind(++at, report.event);
    statement.exec();
}

void MissionStore::add(const MissionRecord& mission, const ArchivedMap& map, const ReportRecord& first) {
    guarded([&] {
        SQLite::Transaction transaction(sql_);
        SQLite::Statement known(sql_, "SELECT bytes = ? FROM maps WHERE id = ?");
        known.bindNoCopy(1, map.bytes.data(), int(map.bytes.size()));
        known.bind(2, map.id);
        if (!known.executeStep()) {
            SQLite::Statement archive(sql_, "INSERT INTO maps VALUES (?, ?, ?)");
            archive.bind(1, map.id);
            archive.bind(2, map.connectivity == Connectivity::eight ? 8 : 4);
            archive.bindNoCopy(3, map.bytes.data(), int(map.bytes.size()));
            archive.exec();
        } else if (known.getColumn(0).getInt() == 0) {
            throw http::Problem(http::unprocessable, "a live mission is on another map of the id " + map.id);
        }
        SQLite::Statement statement(sql_, "INSERT INTO missions VALUES (?, ?, ?, ?, ?)");
        int at = 0;
        for (const std::string* text :
             {&mission.id, &mission.map, &mission.archive, &mission.digest, &mission.request}) {
            statement.bind(++at, *text);
        }
        statement.exec();
        insert(mission.id, first);
        transaction.commit();
        list_archive();
    });
}

void MissionStore::add(const std::string& mission, const ReportRecord& report) {
    guarded([&] {
        SQLite::Transaction transaction(sql_);
        insert(mission, report);
        transaction.commit();
    });
}

void MissionStore::remove(const std::string& mission) {
    guarded([&] {
        SQLite::Transaction transaction(sql_);
        SQLite::Statement statement(sql_, "DELETE FROM missions WHERE id = ?");
        statement.bind(1, mission);
        statement.exec();
        sql_.exec("DELETE FROM maps WHERE id NOT IN (SELECT archive FROM missions)");
        transaction.commit();
        list_archive();
    });
}

std::vector<ReportRecord> MissionStore::select(const char* plan, const char* where, const std::string& mission,
                                               std::int64_t number) {
    return guarded([&] {
        std::vector<ReportRecord> found;
        SQLite::Statement query(sql_, fmt::format("SELECT sequence, revision, now, status, state, {}, event FROM "
                                                  "reports WHERE mission = ? AND {} ORDER BY sequence",
                                                  plan, where));
        query.bind(1, mission);
        query.bind(2, number);
        while (query.executeStep()) found.push_back(report_of(query));
        return found;
    });
}

constexpr auto its_plan = "ifnull(plan, '')";

std::optional<ReportRecord> MissionStore::report(const std::string& mission, std::uint64_t sequence) {
    std::vector<ReportRecord> found = select(its_plan, "sequence = ?", mission, std::int64_t(sequence));
    return found.empty() ? std::nullopt : std::optional(std::move(found.front()));
}

std::optional<ReportRecord> MissionStore::planned(const std::string& mission, int revision) {
    std::vector<ReportRecord> found = select(its_plan, "revision = ? AND plan IS NOT NULL", mission, revision);
    return found.empty() ? std::nullopt : std::optional(std::move(found.front()));
}

std::vector<ReportRecord> MissionStore::reports_after(const std::string& mission, std::uint64_t sequence) {
    return select("''", "sequence > ?", mission, std::int64_t(sequence));
}

bool MissionStore::holds(const std::string& id) const {
    const std::scoped_lock lock(archive_mutex_);
    return archived_.contains(id);
}

std::vector<std::string> MissionStore::sent() const {
    const std::scoped_lock lock(archive_mutex_);
    std::vector<std::string> all;
    for (const auto& [id, is_sent] : archived_) {
        if (is_sent) all.push_back(id);
    }
    return all;
}

std::optional<ArchivedMap> MissionStore::read(const std::string& id) {
    return guarded([&]() -> std::optional<ArchivedMap> {
        SQLite::Statement query(sql_, "SELECT connectivity, bytes FROM maps WHERE id = ?");
        query.bind(1, id);
        if (!query.executeStep()) return std::nullopt;
        const SQLite::Column bytes = query.getColumn(1);
        return ArchivedMap{.id = id,
                           .connectivity = query.getColumn(0).getInt() == 8 ? Connectivity::eight : Connectivity::four,
                           .bytes = {static_cast<const char*>(bytes.getBlob()), std::size_t(bytes.getBytes())}};
    });
}

}  // namespace waybreaker::service
