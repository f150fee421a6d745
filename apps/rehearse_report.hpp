// What `waybreaker rehearse` reports of one plan, or of two on the same draws.
#pragma once

#include <string>
#include <vector>

#include "waybreaker/rehearse.hpp"

namespace waybreaker::apps {

struct RehearsedPlan {
    std::string name;  // of its file
    Rehearsal rehearsal;
    Objective objective = Objective::makespan;
    bool may_leave = false;  // vehicles that cannot be reached in time
};

struct RehearsalReport {
    std::vector<RehearsedPlan> plans = {};  // one or two
    RehearsalOptions options = {};
    std::string time_unit = {};  // "s", or nothing where it is not known
    bool timing = true;          // say how long revisions took
};

// For a person.
std::string rehearsal_table(const RehearsalReport& report, bool bold);
// "waybreaker-rehearsal/1"; the second plan's figures are `compared`.
std::string rehearsal_json(const RehearsalReport& report);
// A line for each run of each plan.
std::string rehearsal_csv(const RehearsalReport& report);
// A histogram of the makespans of the runs that arrived.
std::string rehearsal_svg(const RehearsalReport& report);

}  // namespace waybreaker::apps
