// Evaluate: one job, from a mission and a configuration to a result.
#pragma once

#include "experiment/experiment.hpp"
#include "experiment/result.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::experiment {

// Reuses the planners' memory between jobs; not thread-safe.
class Evaluator {
  public:
    // Never throws for a failure of a mission: that is a result as well. A job that is stopped has timed out.
    Result evaluate(const Map& map, const ExperimentMission& mission, const Configuration& configuration,
                    const StopToken& stop);

  private:
    Result plan(const Map& map, const ExperimentMission& mission, const Configuration& configuration,
                const StopToken& stop);

    Planner planner_;
};

}  // namespace waybreaker::experiment
