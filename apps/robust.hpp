// `--robust` of `waybreaker plan`: of plans that are about as good as the best, the one that rehearses best.
#pragma once

#include <optional>
#include <string>

#include "commands.hpp"
#include "io/map_file.hpp"
#include "io/mission_json.hpp"
#include "waybreaker/plan.hpp"
#include "waybreaker/rehearse.hpp"

namespace waybreaker::apps {

struct RobustOptions {
    std::optional<double> share;  // by which a plan may be worse; empty: not asked for
    RehearsalOptions rehearsal{.fail = 0.1, .runs = 200};
};
void add_robust_options(CLI::App& command, RobustOptions& options);

struct RobustPlan {
    Plan plan;
    std::string report;  // a line for a person
};
// REQUIRES: a share is given, and timing enforced.
RobustPlan robust_plan(const io::MapFile& map, const io::MissionDocument& asked, const RobustOptions& options);

}  // namespace waybreaker::apps
