// What the end of a search means for a plan.
#pragma once

#include "waybreaker/advanced/search.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

inline PlanStatus plan_status(SearchStatus search) {
    switch (search) {
        case SearchStatus::found:
            return PlanStatus::solved;
        case SearchStatus::not_found:
            return PlanStatus::not_found;
        case SearchStatus::limit_reached:
            return PlanStatus::limit_reached;
        case SearchStatus::stopped:
            return PlanStatus::stopped;
        case SearchStatus::no_path:
            break;
    }
    return PlanStatus::no_plan;
}

}  // namespace waybreaker
