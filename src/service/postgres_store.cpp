#include "service/postgres_store.hpp"

#include <fmt/format.h>

#include <charconv>
#include <mutex>
#include <pqxx/pqxx>
#include <string_view>
#include <utility>

#include "core/one_line.hpp"
#include "http/log_line.hpp"
#include "http/problem.hpp"
#include "service/postgres_url.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::service {
namespace {

constexpr int schema_version = 1;
constexpr double margin = 5;  // seconds beyond the time of a plan, to read its map and store it

constexpr auto schema_tables = R"(
CREATE TABLE waybreaker.format (version integer NOT NULL);
CREATE TABLE waybreaker.maps (id text PRIMARY KEY, connectivity integer NOT NULL, bytes bytea NOT NULL,
    sent timestamptz);
CREATE TABLE waybreaker.missions (id text PRIMARY KEY, map text NOT NULL,
    archive text NOT NULL REFERENCES waybreaker.maps, digest text NOT NULL, request text NOT NULL);
CREATE TABLE waybreaker.reports (mission text NOT NULL REFERENCES waybreaker.missions ON DELETE CASCADE,
    sequence bigint NOT NULL, revision integer NOT NULL, now double precision NOT NULL, status text NOT NULL,
    state text NOT NULL, plan text, event text NOT NULL, PRIMARY KEY (mission, sequence));
CREATE UNIQUE INDEX revisions ON waybreaker.reports (mission, revision) WHERE plan IS NOT NULL;
CREATE INDEX missions_of_map ON waybreaker.missions (archive);
)";

// Held by who makes the tables, or changes which maps and missions there are: one server at a time, for a moment.
void lock_all(pqxx::work& work) {
    work.exec1("SELECT pg_advisory_xact_lock(hashtextextended('waybreaker', 0))");
}

// The first line of it: the others repeat it, or guess.
std::string reason_of(const pqxx::failure& error) {
    const std::string_view text = error.what();
    return one_line(text.substr(0, text.find('\n')));
}

double number_of(const pqxx::field& field) {
    double number = 0;
    std::from_chars(field.c_str(), field.c_str() + field.size(), number);
    return number;
}

MissionSummary summary_of(const pqxx::row& row) {
    return {.mission = {.id = row[0].c_str(),
                        .map = row[1].c_str(),
                        .archive = row[2].c_str(),
                        .digest = row[3].c_str(),
                        .request = row[4].c_str()},
            .sequence = row[5].as<std::uint64_t>(),
            .revision = row[6].as<int>(),
            .now = number_of(row[7]),
            .status = row[8].c_str()};
}

ReportRecord report_of(const pqxx::row& row) {
    return {.sequence = row[0].as<std::uint64_t>(),
            .revision = row[1].as<int>(),
            .now = number_of(row[2]),
            .status = row[3].c_str(),
            .state = row[4].c_str(),
            .plan = row[5].c_str(),
            .event = row[6].c_str()};
}

// Missions with their last reports; with their requests, or something else.
constexpr auto select_missions =
    "SELECT id, map, archive, digest, {}, sequence, revision, now, status FROM waybreaker.missions CROSS JOIN LATERAL "
    "(SELECT * FROM waybreaker.reports WHERE mission = id ORDER BY sequence DESC LIMIT 1) AS last ";
constexpr auto missions_on_it = "EXISTS (SELECT FROM waybreaker.missions WHERE archive = maps.id)";

std::size_t count_missions(pqxx::work& work) {
    return work.exec1("SELECT count(*) FROM waybreaker.missions")[0].as<std::size_t>();
}

void insert(pqxx::work& work, const std::string& mission, const ReportRecord& report) {
    work.exec_params0("INSERT INTO waybreaker.reports VALUES ($1, $2, $3, $4, $5, $6, $7, $8)", mission,
                      report.sequence, report.revision, fmt::format("{}", report.now), report.status, report.state,
                      report.plan.empty() ? nullptr : report.plan.c_str(), report.event);
}

// A transaction, on a connection that nobody else uses meanwhile.
struct Session {
    std::unique_ptr<pqxx::connection> connection;
    std::unique_ptr<pqxx::work> work;
};

class Connections {
  public:
    explicit Connections(std::string parameters) : parameters_(std::move(parameters)) {}

    // On a connection that rests, or a new one. Throws pqxx::failure.
    Session begin() {
        while (true) {
            std::unique_ptr<pqxx::connection> connection = resting();
            const bool is_new = connection == nullptr;
            if (is_new) connection = std::make_unique<pqxx::connection>(parameters_);
            try {
                auto work = std::make_unique<pqxx::work>(*connection);
                return {std::move(connection), std::move(work)};
            } catch (const std::exception&) {
                if (is_new) throw;  // the others may have been cut
            }
        }
    }
    void end(Session session) {
        session.work.reset();
        const std::scoped_lock lock(mutex_);
        if (session.connection->is_open()) resting_.push_back(std::move(session.connection));
    }

  private:
    std::unique_ptr<pqxx::connection> resting() {
        const std::scoped_lock lock(mutex_);
        if (resting_.empty()) return nullptr;
        std::unique_ptr<pqxx::connection> connection = std::move(resting_.back());
        resting_.pop_back();
        return connection;
    }

    std::string parameters_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<pqxx::connection>> resting_;
};

// Runs `act`; what goes wrong with the database is a Problem, and is logged.
template <class Act>
auto guarded(const Log& log, Act act) {
    try {
        return act();
    } catch (const pqxx::failure& error) {
        const auto* const sql = dynamic_cast<const pqxx::sql_error*>(&error);
        if (sql != nullptr && sql->sqlstate() == "55P03") {  // lock_not_available
            throw http::Problem(http::unavailable, "another server is at work on this mission; ask again");
        }
        log(http::log_line("store-unusable", reason_of(error)));
        throw http::Problem(http::unavailable,
                            "the server cannot use its store; what was acknowledged before is safe; ask again",
                            "store-unusable");
    }
}

class PostgresTurn : public Turn {
  public:
    PostgresTurn(Connections& connections, const Log& log, std::string mission, double lease)
        : connections_(connections), log_(log), mission_(std::move(mission)), session_(connections_.begin()) {
        pqxx::work& work = *session_.work;
        work.exec0(fmt::format("SET LOCAL idle_in_transaction_session_timeout = '{:.0f}ms'", 1000 * lease));
        // Whoever has the turn may take a whole lease, and PostgreSQL some time to end it.
        work.exec0(fmt::format("SET LOCAL lock_timeout = '{:.0f}ms'", 1000 * (lease + margin)));
        work.exec_params1("SELECT pg_advisory_xact_lock(hashtextextended('waybreaker ' || $1::text, 0))", mission_);
    }
    ~PostgresTurn() override { connections_.end(std::move(session_)); }

    bool add(const ReportRecord& report) override {
        return guarded(log_, [&] {
            try {
                insert(*session_.work, mission_, report);
            } catch (const pqxx::foreign_key_violation&) {
                return false;
            }
            session_.work->commit();
            return true;
        });
    }

  private:
    Connections& connections_;
    const Log& log_;
    std::string mission_;
    Session session_;  // holds the lock
};

class PostgresStore : public MissionStore {
  private:
    // Runs `act` in a transaction, and commits it.
    template <class Act>
    auto commit(Act act) {
        Session session = connections_.begin();
        auto result = act(*session.work);
        session.work->commit();
        connections_.end(std::move(session));
        return result;
    }
    template <class Act>
    auto transact(Act act) {
        return guarded(log_, [&] { return commit(act); });
    }

  public:
    PostgresStore(const PostgresUrl& url, const ServiceLimits& limits, Log log)
        : connections_(url.parameters), kept_maps_(limits.maps), lease_(limits.seconds + margin), log_(std::move(log)) {
        try {
            commit([&](pqxx::work& work) { return begin(work, url.name); });
        } catch (const pqxx::broken_connection& error) {
            throw InputError(
                fmt::format("cannot connect to {}: {}; is it running, and are host, database, user and "
                            "password right? (the password can also come from PGPASSWORD or ~/.pgpass)",
                            url.name, reason_of(error)));
        } catch (const pqxx::failure& error) {
            throw InputError(fmt::format("cannot use {} as a store: {}", url.name, reason_of(error)));
        }
    }

    bool is_shared() const override { return true; }

    std::size_t count() override {
        return transact([](pqxx::work& work) { return count_missions(work); });
    }

    std::vector<MissionSummary> missions() override {
        return transact([](pqxx::work& work) {
            std::vector<MissionSummary> all;
            const std::string query = fmt::format(select_missions, "''") + "ORDER BY id COLLATE \"C\"";
            for (const auto& row : work.exec(query)) all.push_back(summary_of(row));
            return all;
        });
    }

    std::optional<MissionSummary> mission(const std::string& id) override {
        return transact([&](pqxx::work& work) -> std::optional<MissionSummary> {
            const pqxx::result found = work.exec_params(fmt::format(select_missions, "request") + "WHERE id = $1", id);
            if (found.empty()) return std::nullopt;
            return summary_of(found.front());
        });
    }

    bool add(const MissionRecord& mission, const ArchivedMap& map, const ReportRecord& first,
             std::size_t most) override {
        return transact([&](pqxx::work& work) {
            lock_all(work);
            if (count_missions(work) >= most) return false;
            const pqxx::binarystring bytes(map.bytes);
            const pqxx::result known =
                work.exec_params("SELECT bytes = $2 FROM waybreaker.maps WHERE id = $1", map.id, bytes);
            if (known.empty()) {
                work.exec_params0("INSERT INTO waybreaker.maps VALUES ($1, $2, $3)", map.id,
                                  map.connectivity == Connectivity::eight ? 8 : 4, bytes);
            } else if (!known.front()[0].as<bool>()) {
                throw http::Problem(http::unprocessable, "there is another map of the id " + map.id);
            }
            work.exec_params0("INSERT INTO waybreaker.missions VALUES ($1, $2, $3, $4, $5)", mission.id, mission.map,
                              mission.archive, mission.digest, mission.request);
            insert(work, mission.id, first);
            return true;
        });
    }

    bool remove(const std::string& mission) override {
        return transact([&](pqxx::work& work) {
            lock_all(work);
            const pqxx::result removed =
                work.exec_params("DELETE FROM waybreaker.missions WHERE id = $1 RETURNING archive", mission);
            if (removed.empty()) return false;
            work.exec_params0(
                fmt::format("DELETE FROM waybreaker.maps WHERE id = $1 AND sent IS NULL AND NOT {}", missions_on_it),
                removed.front()[0].as<std::string>());
            return true;
        });
    }

    std::unique_ptr<Turn> turn(const std::string& mission) override {
        return guarded(log_, [&] { return std::make_unique<PostgresTurn>(connections_, log_, mission, lease_); });
    }

    std::optional<ReportRecord> report(const std::string& mission, std::uint64_t sequence) override {
        std::vector<ReportRecord> found = select("plan", "sequence = $2", mission, sequence);
        return found.empty() ? std::nullopt : std::optional(std::move(found.front()));
    }

    std::optional<ReportRecord> planned(const std::string& mission, int revision) override {
        std::vector<ReportRecord> found =
            select("plan", "revision = $2 AND plan IS NOT NULL", mission, std::uint64_t(revision));
        return found.empty() ? std::nullopt : std::optional(std::move(found.front()));
    }

    std::vector<ReportRecord> reports_after(const std::string& mission, std::uint64_t sequence) override {
        return select("''", "sequence > $2", mission, sequence);
    }

    bool holds(const std::string& id) override {
        return transact([&](pqxx::work& work) {
            return !work.exec_params("SELECT FROM waybreaker.maps WHERE id = $1", id).empty();
        });
    }

    std::vector<std::string> sent() override {
        return transact([](pqxx::work& work) {
            std::vector<std::string> all;
            for (const auto& row :
                 work.exec("SELECT id FROM waybreaker.maps WHERE sent IS NOT NULL OR EXISTS (SELECT FROM "
                           "waybreaker.missions WHERE archive = maps.id AND map = maps.id) ORDER BY id")) {
                all.emplace_back(row[0].c_str());
            }
            return all;
        });
    }

    std::optional<ArchivedMap> read(const std::string& id) override {
        return transact([&](pqxx::work& work) -> std::optional<ArchivedMap> {
            const pqxx::result found =
                work.exec_params("SELECT connectivity, bytes FROM waybreaker.maps WHERE id = $1", id);
            if (found.empty()) return std::nullopt;
            return ArchivedMap{
                .id = id,
                .connectivity = found.front()[0].as<int>() == 8 ? Connectivity::eight : Connectivity::four,
                .bytes = pqxx::binarystring(found.front()[1]).str()};
        });
    }

    void keep(const std::string& id, Connectivity connectivity, const std::string& bytes) override {
        transact([&](pqxx::work& work) {
            lock_all(work);
            const pqxx::result kept = work.exec_params(
                "INSERT INTO waybreaker.maps AS known VALUES ($1, $2, $3, clock_timestamp()) ON CONFLICT (id) DO "
                "UPDATE "
                "SET sent = excluded.sent WHERE known.bytes = excluded.bytes",
                id, connectivity == Connectivity::eight ? 8 : 4, pqxx::binarystring(bytes));
            if (kept.affected_rows() == 0) {
                throw http::Problem(http::unprocessable, "another map has the id " + id + " here; delete it first");
            }
            work.exec_params0(
                fmt::format("DELETE FROM waybreaker.maps WHERE sent IS NOT NULL AND NOT {} AND id NOT IN "
                            "(SELECT id FROM waybreaker.maps WHERE sent IS NOT NULL ORDER BY sent DESC, id "
                            "LIMIT $1)",
                            missions_on_it),
                kept_maps_);
            return true;
        });
    }

    bool forget(const std::string& id) override {
        return transact([&](pqxx::work& work) {
            lock_all(work);
            work.exec_params0(fmt::format("DELETE FROM waybreaker.maps WHERE id = $1 AND NOT {}", missions_on_it), id);
            return work.exec_params("SELECT FROM waybreaker.maps WHERE id = $1", id).empty();
        });
    }

  private:
    static bool begin(pqxx::work& work, const std::string& name) {
        if (work.exec1("SHOW server_encoding")[0].as<std::string>() != "UTF8") {
            throw InputError(name + " has another encoding than UTF-8: create one with ENCODING 'UTF8'");
        }
        lock_all(work);
        if (work.exec1("SELECT to_regclass('waybreaker.format')")[0].is_null()) {
            if (work.exec1("SELECT to_regnamespace('waybreaker')")[0].is_null()) work.exec0("CREATE SCHEMA waybreaker");
            work.exec0(schema_tables);
            work.exec_params0("INSERT INTO waybreaker.format VALUES ($1)", schema_version);
        }
        const int version = work.exec1("SELECT version FROM waybreaker.format")[0].as<int>();
        if (version == schema_version) return true;
        throw InputError(
            fmt::format("{} was begun by another version of waybreaker, in format {} while this one knows format {}: "
                        "serve it with that "
                        "version, or give another database to --store",
                        name, version, schema_version));
    }

    std::vector<ReportRecord> select(const char* plan, const char* where, const std::string& mission,
                                     std::uint64_t number) {
        return transact([&](pqxx::work& work) {
            std::vector<ReportRecord> found;
            for (const auto& row :
                 work.exec_params(fmt::format("SELECT sequence, revision, now, status, state, {}, event FROM "
                                              "waybreaker.reports WHERE mission = $1 AND {} ORDER BY sequence",
                                              plan, where),
                                  mission, number)) {
                found.push_back(report_of(row));
            }
            return found;
        });
    }

    Connections connections_;
    std::size_t kept_maps_;
    double lease_;  // seconds
    Log log_;
};

}  // namespace

std::unique_ptr<MissionStore> open_postgres_store(const std::string& url, const ServiceLimits& limits, const Log& log) {
    return std::make_unique<PostgresStore>(parse_postgres_url(url), limits, log);
}

}  // namespace waybreaker::service
