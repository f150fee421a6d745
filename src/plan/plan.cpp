#include "waybreaker/plan.hpp"

namespace waybreaker {

std::optional<double> value(const Outcome& outcome, Objective objective) {
    switch (objective) {
        case Objective::makespan:
            return outcome.makespan;
        case Objective::flowtime:
            return outcome.flowtime;
        case Objective::ground_makespan:
            break;
    }
    return outcome.ground_makespan;
}

}  // namespace waybreaker
