#include "experiment/store.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "experiment/document.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::experiment {
namespace {

void bind(SQLite::Statement& statement, int& at, const std::optional<double>& value) {
    if (value) {
        statement.bind(++at, *value);
    } else {
        statement.bind(++at);
    }
}

void bind(SQLite::Statement& statement, int& at, const Stage& stage) {
    bind(statement, at, stage.ground);
    statement.bind(++at, stage.air);
    bind(statement, at, stage.makespan);
    bind(statement, at, stage.flowtime);
    statement.bind(++at, std::int64_t(stage.expanded));
    statement.bind(++at, std::int64_t(stage.generated));
    statement.bind(++at, stage.seconds);
}

std::string list_of(std::span<const ObstacleId> obstacles) {
    std::string list;
    for (const ObstacleId id : obstacles) list += fmt::format("{}{}", list.empty() ? "" : " ", id.value);
    return list;
}

void insert(SQLite::Statement& statement, const Row& row, std::size_t configurations) {
    const Result& result = row.result;
    int at = 0;
    statement.bind(++at, std::int64_t(row.job / configurations));
    statement.bind(++at, std::int64_t(row.job % configurations));
    statement.bind(++at, std::string(to_string(result.status)));
    statement.bind(++at, result.message);
    bind(statement, at, result.before);
    bind(statement, at, result.after);
    bind(statement, at, result.bound);
    bind(statement, at, result.gap);
    statement.bind(++at, list_of(result.removed));
    statement.bind(++at, result.seconds);
    statement.exec();
    statement.reset();
}

constexpr const char* insert_result =
    "INSERT INTO results VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)";

template <class... Values>
void insert_line(SQLite::Statement& statement, const Values&... values) {
    int at = 0;
    (statement.bind(++at, values), ...);
    statement.exec();
    statement.reset();
}

void insert_mission(SQLite::Statement& statement, std::size_t number, const ExperimentMission& one) {
    int at = 0;
    for (const std::int64_t value : {std::int64_t(number), std::int64_t(one.set), std::int64_t(one.map)}) {
        statement.bind(++at, value);
    }
    for (const Cell c : {one.start(), one.goal()}) {
        statement.bind(++at, c.x);
        statement.bind(++at, c.y);
    }
    bind(statement, at, one.octile);
    for (const AgentKind kind : {AgentKind::ground, AgentKind::air})
        statement.bind(++at, std::int64_t(one.count(kind)));
    statement.bind(++at, std::string(to_string(one.mission.rules.objective)));
    statement.bind(++at, document_of(one.mission));
    statement.exec();
    statement.reset();
}

}  // namespace

Store::Store(const std::string& path, const Experiment& experiment, Shard shard, const std::string& version)
    : experiment_(experiment), shard_(shard), database_(path, Access::create) {
    database_.guarded([&] {
        if (database_.is_new()) return begin(version);
        require_same(version);
        keep_spec();
    });
}

void Store::begin(const std::string& version) {
    SQLite::Database& sql = database_.sql();
    SQLite::Transaction transaction(sql);
    make_tables(sql);
    SQLite::Statement property(sql, "INSERT INTO experiment VALUES (?, ?)");
    insert_line(property, "name", experiment_.name);
    insert_line(property, "spec", experiment_.spec);
    insert_line(property, "digest", experiment_.digest);
    insert_line(property, "version", version);
    insert_line(property, "shard", std::to_string(shard_.index));
    insert_line(property, "shards", std::to_string(shard_.count));
    insert_line(property, "missions", std::to_string(experiment_.missions.size()));

    SQLite::Statement set(sql, "INSERT INTO sets VALUES (?, ?)");
    for (std::size_t i = 0; i < experiment_.sets.size(); ++i) insert_line(set, std::int64_t(i), experiment_.sets[i]);
    SQLite::Statement map(sql, "INSERT INTO maps VALUES (?, ?, ?, ?, ?)");
    for (std::size_t i = 0; i < experiment_.maps.size(); ++i) {
        const ExperimentMap& one = experiment_.maps[i];
        insert_line(map, std::int64_t(i), one.name, one.digest, one.width, one.height);
    }
    SQLite::Statement configuration(sql, "INSERT INTO configurations VALUES (?, ?, ?, ?, ?)");
    for (std::size_t i = 0; i < experiment_.configurations.size(); ++i) {
        const Configuration& one = experiment_.configurations[i];
        insert_line(configuration, std::int64_t(i), std::string(to_string(one.method)),
                    std::string(to_string(one.planner)), one.weight, one.removals);
    }
    SQLite::Statement mission(sql, "INSERT INTO missions VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    for (std::size_t i = 0; i < experiment_.missions.size(); ++i) {
        const ExperimentMission& one = experiment_.missions[i];
        if (!shard_.holds(i)) continue;
        insert_mission(mission, i, one);
    }
    transaction.commit();
}

void Store::require_same(const std::string& version) {
    if (property("digest") != experiment_.digest) {
        throw InputError(path(), 0,
                         "holds the results of another experiment, or its spec, missions or maps have changed: give "
                         "another file");
    }
    const std::string begun = property("version");
    if (begun != version) {
        throw InputError(
            path(), 0,
            fmt::format("was begun by waybreaker {}, this is {}: end it with that one, or begin another file", begun,
                        version));
    }
    const std::string held = property("shard") + "/" + property("shards");
    const std::string wanted = fmt::format("{}/{}", shard_.index, shard_.count);
    if (held != wanted) {
        throw InputError(path(), 0, fmt::format("holds shard {}, not {}: give each shard its own file", held, wanted));
    }
}

// The report's part of the spec (name, places) may have changed.
void Store::keep_spec() {
    SQLite::Statement update(database_.sql(), "UPDATE experiment SET value = ? WHERE key = ? AND value != ?1");
    const auto keep = [&update](const char* key, const std::string& value) {
        update.bind(1, value);
        update.bind(2, key);
        update.exec();
        update.reset();
    };
    keep("name", experiment_.name);
    keep("spec", experiment_.spec);
}

std::string Store::property(const char* key) {
    SQLite::Statement query(database_.sql(), "SELECT value FROM experiment WHERE key = ?");
    query.bind(1, key);
    return query.executeStep() ? query.getColumn(0).getString() : "";
}

std::size_t Store::job_count() const {
    const std::size_t missions = experiment_.missions.size();
    const std::size_t own = (missions + shard_.count - shard_.index) / shard_.count;
    return own * experiment_.configurations.size();
}

std::vector<std::uint64_t> Store::open_jobs() {
    return database_.guarded([&] {
        const std::size_t configurations = experiment_.configurations.size();
        std::vector<std::uint64_t> done;
        SQLite::Statement query(database_.sql(),
                                "SELECT mission, configuration FROM results ORDER BY mission, configuration");
        while (query.executeStep()) {
            done.push_back(std::uint64_t(query.getColumn(0).getInt64()) * configurations +
                           std::uint64_t(query.getColumn(1).getInt64()));
        }
        std::vector<std::uint64_t> all;
        for (std::size_t i = shard_.index - 1; i < experiment_.missions.size(); i += shard_.count) {
            for (std::size_t j = 0; j < configurations; ++j) all.push_back(i * configurations + j);
        }
        std::vector<std::uint64_t> open;
        std::ranges::set_difference(all, done, std::back_inserter(open));
        return open;
    });
}

void Store::add(std::span<const Row> rows) {
    if (rows.empty()) return;
    database_.guarded([&] {
        SQLite::Transaction transaction(database_.sql());
        SQLite::Statement statement(database_.sql(), insert_result);
        for (const Row& row : rows) insert(statement, row, experiment_.configurations.size());
        transaction.commit();
    });
}

}  // namespace waybreaker::experiment
