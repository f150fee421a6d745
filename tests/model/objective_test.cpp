// What each objective makes small, and by what it breaks ties.
#include "model/objective.hpp"

#include <gtest/gtest.h>

namespace waybreaker {
namespace {

Finish three_agents() {
    Finish finish;
    finish.add(AgentKind::ground, 7);
    finish.add(AgentKind::air, 12);
    finish.add(AgentKind::ground, 4);
    return finish;
}

void expect_rank(Objective objective, double first, double second) {
    const Rank found = rank(objective, three_agents());
    EXPECT_EQ(found.first, first);
    EXPECT_EQ(found.second, second);
}

TEST(Objective, MakespanIsTheLastArrivalOfAnyAgent) {
    expect_rank(Objective::makespan, 12, 23);
}
TEST(Objective, FlowtimeIsTheSumOfAllArrivals) {
    expect_rank(Objective::flowtime, 23, 12);
}
TEST(Objective, GroundMakespanLeavesTheAircraftOut) {
    expect_rank(Objective::ground_makespan, 7, 23);
}

TEST(Objective, TwoAgentsFinishAsIfAddedOneByOne) {
    Finish added;
    added.add(AgentKind::air, 2);
    added.add(AgentKind::ground, 3);
    const Finish two = finish_of_two(3, 2);
    EXPECT_EQ(two.ground, added.ground);
    EXPECT_EQ(two.air, added.air);
    EXPECT_EQ(two.flowtime, added.flowtime);
}

}  // namespace
}  // namespace waybreaker
