// The plan file, "waybreaker-plan/1" (contract, section 4).
#pragma once

#include <span>
#include <string>

#include "io/map_file.hpp"
#include "io/mission_document.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::io {

// What a plan file says of its making beside the plan itself.
struct PlanContext {
    const MapFile& map;
    const MissionDocument& asked;
    Connectivity connectivity = Connectivity::four;
    bool timing_fields = true;         // false: no "seconds" anywhere, so that equal input gives equal bytes
    ImageReading image = {};           // how the map was read
    std::span<const Plan> front = {};  // the plans for 0, 1, 2, ... removals, if asked for
    std::string supersedes = {};       // of a revision: the digest of the file of the plan before, if there is one
};

// How many removals the last plan of a front may make, by the mission's rules: what the document of the front states.
int removals_of(std::span<const Plan> front, const Rules& rules);

// The whole document, indented, with a final newline. Same input, same bytes, `seconds` aside.
std::string plan_json(const Plan& plan, const PlanContext& context);

}  // namespace waybreaker::io
