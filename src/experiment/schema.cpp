// The tables of a results file. The view `rows` is what people want to read: one line a result, with all it depends on.
#include <fmt/format.h>

#include "experiment/database.hpp"

namespace waybreaker::experiment {

void make_tables(SQLite::Database& sql) {
    sql.exec(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", application_id, results_format));
    sql.exec(R"(
CREATE TABLE experiment (key TEXT PRIMARY KEY, value TEXT NOT NULL) STRICT, WITHOUT ROWID;
CREATE TABLE sets (id INTEGER PRIMARY KEY, name TEXT NOT NULL) STRICT;
CREATE TABLE maps (id INTEGER PRIMARY KEY, name TEXT NOT NULL, digest TEXT NOT NULL,
    width INTEGER NOT NULL, height INTEGER NOT NULL) STRICT;
CREATE TABLE missions (id INTEGER PRIMARY KEY, "set" INTEGER NOT NULL REFERENCES sets, map INTEGER NOT NULL REFERENCES maps,
    start_x INTEGER NOT NULL, start_y INTEGER NOT NULL, goal_x INTEGER NOT NULL, goal_y INTEGER NOT NULL,
    octile REAL, vehicles INTEGER NOT NULL, aircraft INTEGER NOT NULL, objective TEXT NOT NULL,
    document TEXT NOT NULL) STRICT;
CREATE TABLE configurations (id INTEGER PRIMARY KEY, method TEXT NOT NULL, planner TEXT NOT NULL, weight REAL NOT NULL,
    removals INTEGER NOT NULL) STRICT;
CREATE TABLE results (
    mission INTEGER NOT NULL REFERENCES missions, configuration INTEGER NOT NULL REFERENCES configurations,
    status TEXT NOT NULL CHECK (status IN ('solved', 'no plan', 'timed out', 'failed', 'crashed')), message TEXT NOT NULL,
    before_ground REAL, before_air REAL NOT NULL, before_makespan REAL, before_flowtime REAL,
    before_expanded INTEGER NOT NULL, before_generated INTEGER NOT NULL, before_seconds REAL NOT NULL,
    after_ground REAL, after_air REAL NOT NULL, after_makespan REAL, after_flowtime REAL,
    after_expanded INTEGER NOT NULL, after_generated INTEGER NOT NULL, after_seconds REAL NOT NULL,
    bound REAL, gap REAL, removed TEXT NOT NULL, seconds REAL NOT NULL,
    PRIMARY KEY (mission, configuration)) STRICT, WITHOUT ROWID;
CREATE VIEW rows AS SELECT
    results.mission, sets.name AS "set", maps.name AS map, maps.digest AS map_digest,
    start_x, start_y, goal_x, goal_y, octile, vehicles, aircraft, objective, method, planner, weight, removals, status, message,
    before_ground, before_air, before_makespan, before_flowtime, before_expanded, before_generated, before_seconds,
    after_ground, after_air, after_makespan, after_flowtime, after_expanded, after_generated, after_seconds,
    bound, gap, removed, seconds, (SELECT value FROM experiment WHERE key = 'version') AS version
    FROM results JOIN missions ON missions.id = results.mission JOIN sets ON sets.id = missions."set"
    JOIN maps ON maps.id = missions.map JOIN configurations ON configurations.id = results.configuration
    ORDER BY results.mission, results.configuration;
)");
}

}  // namespace waybreaker::experiment
