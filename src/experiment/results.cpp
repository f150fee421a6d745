#include "experiment/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "experiment/spec.hpp"
#include "io/csv_field.hpp"
#include "io/mission_json.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::experiment {
namespace {

// Throws InputError for a word that is none, as a results file from elsewhere may hold.
template <class Enum>
Enum value_of(std::string_view word) {
    if (const auto value = from_string<Enum>(word)) return *value;
    throw InputError("the results hold a word that is unknown: '" + std::string(word) + "'");
}

std::optional<double> number(const SQLite::Column& column) {
    return column.isNull() ? std::nullopt : std::optional(column.getDouble());
}

Stage stage(SQLite::Statement& row, int at) {
    return {.ground = number(row.getColumn(at)),
            .expanded = std::uint64_t(row.getColumn(at + 4).getInt64()),
            .generated = std::uint64_t(row.getColumn(at + 5).getInt64()),
            .seconds = row.getColumn(at + 6).getDouble(),
            .air = row.getColumn(at + 1).getDouble(),
            .makespan = number(row.getColumn(at + 2)),
            .flowtime = number(row.getColumn(at + 3))};
}

// Without the obstacles, which only people read.
Result result(SQLite::Statement& row, int at) {
    return {.status = value_of<ResultStatus>(row.getColumn(at).getText()),
            .message = row.getColumn(at + 1).getString(),
            .before = stage(row, at + 2),
            .after = stage(row, at + 9),
            .bound = number(row.getColumn(at + 16)),
            .gap = number(row.getColumn(at + 17)),
            .removed = {},
            .seconds = row.getColumn(at + 19).getDouble()};
}

// A cell of CSV.
std::string cell(const SQLite::Column& column) {
    if (column.isNull()) return "";
    if (column.isFloat()) return fmt::format("{}", column.getDouble());
    return io::csv_field(column.getString());
}

bool is_measured(std::string_view column) {
    return column.ends_with("seconds");
}

}  // namespace

Results::Results(const std::string& path) : database_(path, Access::read) {
    database_.guarded([&] { read(); });
}

std::string Results::property(const char* key) {
    SQLite::Statement query(database_.sql(), "SELECT value FROM experiment WHERE key = ?");
    query.bind(1, key);
    if (!query.executeStep()) throw InputError(path(), 0, fmt::format("does not say its {}", key));
    return query.getColumn(0).getString();
}

Mission Results::mission(const std::string& document) const {
    Mission mission = io::parse_mission(document, path()).mission;
    if (std::ranges::count(mission.agents, AgentKind::ground, &Agent::kind) > 0) return mission;
    throw InputError(path(), 0, "is damaged: a mission of no ground agent");
}

std::size_t Results::number(const char* key) {
    const std::string text = property(key);
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value == 0) {
        throw InputError(path(), 0, fmt::format("has '{}' for its {}", text, key));
    }
    return value;
}

void Results::read() {
    SQLite::Database& sql = database_.sql();
    experiment_.name = property("name");
    experiment_.spec = property("spec");
    experiment_.places = parse_spec(experiment_.spec, path() + ", its spec").places;
    experiment_.digest = property("digest");
    version_ = property("version");
    shard_ = {std::uint32_t(number("shard")), std::uint32_t(number("shards"))};
    if (shard_.index > shard_.count) throw InputError(path(), 0, "has a shard beyond the last");
    for (SQLite::Statement set(sql, "SELECT name FROM sets ORDER BY id"); set.executeStep();) {
        experiment_.sets.push_back(set.getColumn(0).getString());
    }
    for (SQLite::Statement map(sql, "SELECT name, digest, width, height FROM maps ORDER BY id"); map.executeStep();) {
        experiment_.maps.push_back({map.getColumn(0).getString(), "", map.getColumn(1).getString(),
                                    map.getColumn(2).getInt(), map.getColumn(3).getInt()});
    }
    for (SQLite::Statement one(sql, "SELECT method, planner, weight, removals FROM configurations ORDER BY id");
         one.executeStep();) {
        experiment_.configurations.push_back({value_of<Method>(one.getColumn(0).getText()),
                                              value_of<Algorithm>(one.getColumn(1).getText()),
                                              one.getColumn(2).getDouble(), one.getColumn(3).getInt()});
    }
    for (SQLite::Statement one(sql, "SELECT \"set\", map, octile, document FROM missions ORDER BY id");
         one.executeStep();) {
        const auto index = [&](int column, std::size_t limit) {
            const std::int64_t value = one.getColumn(column).getInt64();
            if (value < 0 || value >= std::int64_t(limit))
                throw InputError(path(), 0, "is damaged: a mission of nothing");
            return std::uint32_t(value);
        };
        experiment_.missions.push_back({index(0, experiment_.sets.size()), index(1, experiment_.maps.size()),
                                        mission(one.getColumn(3).getString()),
                                        ::waybreaker::experiment::number(one.getColumn(2))});
    }
}

std::size_t Results::missing() {
    return database_.guarded([&] {
        const std::int64_t stored = database_.sql().execAndGet("SELECT count(*) FROM results").getInt64();
        return experiment_.job_count() - std::size_t(stored);
    });
}

std::vector<std::pair<std::string, std::size_t>> Results::statuses() {
    return database_.guarded([&] {
        std::vector<std::pair<std::string, std::size_t>> counts;
        for (SQLite::Statement one(database_.sql(),
                                   "SELECT status, count(*) FROM results GROUP BY status ORDER BY status");
             one.executeStep();) {
            counts.emplace_back(one.getColumn(0).getString(), std::size_t(one.getColumn(1).getInt64()));
        }
        return counts;
    });
}

void Results::for_each_mission(const Visit& visit) {
    database_.guarded([&] {
        SQLite::Statement row(database_.sql(),
                              "SELECT missions.id, results.* FROM missions LEFT JOIN results ON mission = missions.id "
                              "ORDER BY missions.id, configuration");
        std::vector<std::optional<Result>> results(experiment_.configurations.size());
        bool more = row.executeStep();
        for (const ExperimentMission& mission : experiment_.missions) {
            results.assign(results.size(), std::nullopt);
            const std::int64_t id = more ? row.getColumn(0).getInt64() : -1;
            for (; more && row.getColumn(0).getInt64() == id; more = row.executeStep()) {
                const SQLite::Column configuration = row.getColumn(2);
                if (configuration.isNull()) continue;
                const auto index = std::size_t(configuration.getInt64());
                if (index >= results.size()) throw InputError(path(), 0, "is damaged: a result of no configuration");
                results[index] = result(row, 3);
            }
            visit(mission, results);
        }
    });
}

std::string Results::csv(bool timing) {
    return database_.guarded([&] {
        SQLite::Statement row(database_.sql(), "SELECT * FROM rows");
        std::vector<int> columns;
        std::string text;
        for (int i = 0; i < row.getColumnCount(); ++i) {
            if (!timing && is_measured(row.getColumnName(i))) continue;
            text += fmt::format("{}{}", columns.empty() ? "" : ",", row.getColumnName(i));
            columns.push_back(i);
        }
        text += '\n';
        while (row.executeStep()) {
            for (const int i : columns) {
                if (i != columns.front()) text += ',';
                text += cell(row.getColumn(i));
            }
            text += '\n';
        }
        return text;
    });
}

}  // namespace waybreaker::experiment
