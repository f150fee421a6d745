// Whether a plan file is valid for a map file, and the report of that check.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/map_file.hpp"
#include "io/plan_file.hpp"
#include "waybreaker/check.hpp"

namespace waybreaker::io {

struct JudgeOptions {
    double tolerance = 1e-6;
    bool ignore_digest = false;  // another map file will do, if only the plan holds on it
    // What the mission gave obstacles to weigh, in place of the map: weights[id]; entry 0 is not used.
    std::optional<std::vector<double>> weights = {};
};

// The map that the plan is judged on if its obstacles weigh something else than the map says: their area if the budget
// is one of square metres (of a map without metres, those that the plan says a cell has), else what `options` say, else
// their number of cells, where the plan says that of all it removes.
std::optional<Map> reweighed(const PlanFile& plan, const MapFile& file, const JudgeOptions& options);

// Throws InputError, with the name of the plan's file, unless it was made for that map.
void require_map_of(const PlanFile& plan, const MapFile& map, const std::string& name);

// The same unless obstacles of the map are made of cells as the plan says.
void require_connectivity(const PlanFile& plan, Connectivity connectivity, const std::string& name);

// What is wrong with the plan, that it was made for another map included. `map`: as it is known to the plan
// (known_map).
std::vector<Violation> judge(const PlanFile& plan, const MapFile& map, const JudgeOptions& options = {});

// The same of a plan that revises another, from a state: also whether it goes on from there (check_continuity).
std::vector<Violation> judge_after(const PlanFile& plan, const MapFile& map, const PlanFile& before, const State& state,
                                   const JudgeOptions& options = {});

// The document "waybreaker-check/1", as `waybreaker check --json` writes it.
std::string check_json(const std::vector<Violation>& violations);

}  // namespace waybreaker::io
