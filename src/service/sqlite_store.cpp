#include "service/sqlite_store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <filesystem>
#include <map>
#include <mutex>
#include <utility>

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

MissionSummary summary_of(SQLite::Statement& row) {
    return {.mission = {.id = row.getColumn(0).getString(),
                        .map = row.getColumn(1).getString(),
                        .archive = row.getColumn(2).getString(),
                        .digest = row.getColumn(3).getString(),
                        .request = row.getColumn(4).getString()},
            .sequence = std::uint64_t(row.getColumn(5).getInt64()),
            .revision = row.getColumn(6).getInt(),
            .now = row.getColumn(7).getDouble(),
            .status = row.getColumn(8).getString()};
}

// The last report of each mission.
constexpr auto last_reports =
    "missions JOIN reports ON mission = id WHERE sequence = (SELECT max(sequence) FROM reports WHERE mission = id)";
constexpr auto its_plan = "ifnull(plan, '')";

class SqliteStore : public MissionStore {
  public:
    explicit SqliteStore(const std::string& path);

    bool in_memory() const override { return path_.empty(); }

    std::size_t count() override;
    std::vector<MissionSummary> missions() override;
    std::optional<MissionSummary> mission(const std::string& id) override;
    bool add(const MissionRecord& mission, const ArchivedMap& map, const ReportRecord& first,
             std::size_t most) override;
    bool remove(const std::string& mission) override;
    std::unique_ptr<Turn> turn(const std::string& mission) override;
    bool add(const std::string& mission, const ReportRecord& report);

    std::optional<ReportRecord> report(const std::string& mission, std::uint64_t sequence) override;
    std::optional<ReportRecord> planned(const std::string& mission, int revision) override;
    std::vector<ReportRecord> reports_after(const std::string& mission, std::uint64_t sequence) override;

    bool holds(const std::string& id) override;
    std::vector<std::string> sent() override;
    std::optional<ArchivedMap> read(const std::string& id) override;
    bool forget(const std::string& id) override { return !holds(id); }  // it has no others

  private:
    template <class Act>
    auto guarded(Act act);
    void begin();
    void list_archive();
    bool knows(const std::string& mission);
    std::vector<ReportRecord> select(const char* plan, const char* where, const std::string& mission,
                                     std::int64_t number);
    void insert(const std::string& mission, const ReportRecord& report);

    std::string path_;
    std::mutex mutex_;
    SQLite::Database sql_;
    std::mutex archive_mutex_;              // so that asking for ids waits for no disk
    std::map<std::string, bool> archived_;  // whether it was sent
    std::mutex turns_mutex_;
    std::map<std::string, std::weak_ptr<std::mutex>> turns_;
};

class SqliteTurn : public Turn {
  public:
    SqliteTurn(SqliteStore& store, std::string mission, std::shared_ptr<std::mutex> mutex)
        : store_(store), mission_(std::move(mission)), mutex_(std::move(mutex)), lock_(*mutex_) {}
    bool add(const ReportRecord& report) override { return store_.add(mission_, report); }

  private:
    SqliteStore& store_;
    std::string mission_;
    std::shared_ptr<std::mutex> mutex_;
    std::unique_lock<std::mutex> lock_;
};

SqliteStore::SqliteStore(const std::string& path) : path_(path), sql_(opened(path)) {
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

void SqliteStore::begin() {
    SQLite::Transaction transaction(sql_);
    sql_.exec(tables);
    sql_.exec(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", application_id, store_format));
    transaction.commit();
}

void SqliteStore::list_archive() {
    std::map<std::string, bool> archived;
    SQLite::Statement query(sql_, "SELECT archive, max(map = archive) FROM missions GROUP BY archive");
    while (query.executeStep()) archived[query.getColumn(0).getString()] = query.getColumn(1).getInt() != 0;
    const std::scoped_lock lock(archive_mutex_);
    archived_ = std::move(archived);
}

// Runs `act` alone.
template <class Act>
auto SqliteStore::guarded(Act act) {
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

std::size_t SqliteStore::count() {
    return guarded([&] { return std::size_t(sql_.execAndGet("SELECT count(*) FROM missions").getInt64()); });
}

std::vector<MissionSummary> SqliteStore::missions() {
    return guarded([&] {
        std::vector<MissionSummary> all;
        SQLite::Statement query(sql_, fmt::format("SELECT id, map, archive, digest, '', sequence, revision, now, "
                                                  "status FROM {} ORDER BY id",
                                                  last_reports));
        while (query.executeStep()) all.push_back(summary_of(query));
        return all;
    });
}

std::optional<MissionSummary> SqliteStore::mission(const std::string& id) {
    return guarded([&]() -> std::optional<MissionSummary> {
        SQLite::Statement query(sql_, fmt::format("SELECT id, map, archive, digest, request, sequence, revision, now, "
                                                  "status FROM {} AND id = ?",
                                                  last_reports));
        query.bind(1, id);
        if (!query.executeStep()) return std::nullopt;
        return summary_of(query);
    });
}

bool SqliteStore::knows(const std::string& mission) {
    SQLite::Statement query(sql_, "SELECT 1 FROM missions WHERE id = ?");
    query.bind(1, mission);
    return query.executeStep();
}

void SqliteStore::insert(const std::string& mission, const ReportRecord& report) {
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

bool SqliteStore::add(const MissionRecord& mission, const ArchivedMap& map, const ReportRecord& first,
                      std::size_t most) {
    return guarded([&] {
        SQLite::Transaction transaction(sql_);
        if (std::size_t(sql_.execAndGet("SELECT count(*) FROM missions").getInt64()) >= most) return false;
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
        return true;
    });
}

std::unique_ptr<Turn> SqliteStore::turn(const std::string& mission) {
    std::shared_ptr<std::mutex> mutex;
    {
        const std::scoped_lock lock(turns_mutex_);
        std::erase_if(turns_, [](const auto& entry) { return entry.second.expired(); });
        mutex = turns_[mission].lock();
        if (!mutex) turns_[mission] = mutex = std::make_shared<std::mutex>();
    }
    return std::make_unique<SqliteTurn>(*this, mission, std::move(mutex));
}

bool SqliteStore::add(const std::string& mission, const ReportRecord& report) {
    return guarded([&] {
        SQLite::Transaction transaction(sql_);
        if (!knows(mission)) return false;
        insert(mission, report);
        transaction.commit();
        return true;
    });
}

bool SqliteStore::remove(const std::string& mission) {
    return guarded([&] {
        SQLite::Transaction transaction(sql_);
        if (!knows(mission)) return false;
        SQLite::Statement statement(sql_, "DELETE FROM missions WHERE id = ?");
        statement.bind(1, mission);
        statement.exec();
        sql_.exec("DELETE FROM maps WHERE id NOT IN (SELECT archive FROM missions)");
        transaction.commit();
        list_archive();
        return true;
    });
}

std::vector<ReportRecord> SqliteStore::select(const char* plan, const char* where, const std::string& mission,
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

std::optional<ReportRecord> SqliteStore::report(const std::string& mission, std::uint64_t sequence) {
    std::vector<ReportRecord> found = select(its_plan, "sequence = ?", mission, std::int64_t(sequence));
    return found.empty() ? std::nullopt : std::optional(std::move(found.front()));
}

std::optional<ReportRecord> SqliteStore::planned(const std::string& mission, int revision) {
    std::vector<ReportRecord> found = select(its_plan, "revision = ? AND plan IS NOT NULL", mission, revision);
    return found.empty() ? std::nullopt : std::optional(std::move(found.front()));
}

std::vector<ReportRecord> SqliteStore::reports_after(const std::string& mission, std::uint64_t sequence) {
    return select("''", "sequence > ?", mission, std::int64_t(sequence));
}

bool SqliteStore::holds(const std::string& id) {
    const std::scoped_lock lock(archive_mutex_);
    return archived_.contains(id);
}

std::vector<std::string> SqliteStore::sent() {
    const std::scoped_lock lock(archive_mutex_);
    std::vector<std::string> all;
    for (const auto& [id, is_sent] : archived_) {
        if (is_sent) all.push_back(id);
    }
    return all;
}

std::optional<ArchivedMap> SqliteStore::read(const std::string& id) {
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

}  // namespace

std::unique_ptr<MissionStore> open_sqlite_store(const std::string& path) {
    return std::make_unique<SqliteStore>(path);
}

}  // namespace waybreaker::service
