#include "search/surroundings.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "random_map.hpp"
#include "slow_sight.hpp"

namespace waybreaker {
namespace {

RC_GTEST_PROP(Surroundings, AreTheNineCellsAround, ()) {
    const PlainMap plain = *random_map(140, 5);
    const Map map(plain.grid());
    const OpenedMap opened(map);
    for (const Cell c : plain.cells()) {
        const Neighbourhood blocked = blocked_around(opened, c);
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                RC_ASSERT(((blocked & step_bit(dx, dy)) != 0) == plain.blocked({c.x + dx, c.y + dy}));
            }
        }
    }
}

// A step is legal iff the agent sees the neighbour's centre, for each of the 512 patterns.
TEST(Surroundings, StepsAreLegalWhereThereIsSight) {
    for (unsigned pattern = 0; pattern < 512; ++pattern) {
        if ((pattern & step_bit(0, 0)) != 0) continue;  // no agent stands in a wall
        PlainMap plain{3, 3, {}};
        for (unsigned bit = 0; bit < 9; ++bit) plain.obstacles.push_back((pattern >> bit) & 1U);
        for (const Corners corners : {Corners::none, Corners::cut, Corners::squeeze}) {
            for (const Step& step : steps) {
                if (step.cost == 0) continue;
                const bool sees = slow::sees(plain, {1, 1}, {1 + step.dx, 1 + step.dy}, {.corners = corners});
                const Neighbourhood bit = step_bit(step.dx, step.dy);
                EXPECT_EQ((legal_steps(corners, true)[pattern] & bit) != 0, sees) << pattern;
                EXPECT_EQ((legal_steps(corners, false)[pattern] & bit) != 0, sees && step.cost == 1) << pattern;
                EXPECT_NEAR(step.cost, std::hypot(step.dx, step.dy), 1e-12);
            }
        }
    }
}

}  // namespace
}  // namespace waybreaker
