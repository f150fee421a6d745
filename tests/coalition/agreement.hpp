// Agreement: plans of drawn missions beside the best of all the plans that there are.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "checked_plan.hpp"
#include "coalition/range_world.hpp"

namespace waybreaker {

class Agreement {
  public:
    // Whether both have a plan: it is valid, not below the best, and its bound not above it.
    bool holds(const RangeWorld& world, const Plan& plan, double best) {
        const auto& [map, mission] = world;
        const double reached = objective_of(mission, plan);
        EXPECT_EQ(plan_faults(map, mission, plan), "");
        EXPECT_EQ(plan.status == PlanStatus::solved, std::isfinite(best));
        EXPECT_LE(plan.bound.value_or(0), best + 1e-6);
        EXPECT_GE(reached, best - 1e-6);
        if (std::isinf(best) || std::isinf(reached)) return false;
        ++solved_;
        as_good_ += reached <= best + 1e-6 ? 1 : 0;
        return true;
    }
    // At the end: how many of a hundred plans are the best.
    void expect_as_good(int least) const { EXPECT_GE(100 * as_good_, least * solved_) << solved_; }

  private:
    int solved_ = 0;
    int as_good_ = 0;
};

}  // namespace waybreaker
