// Many missions at once give what each gives alone, whatever the number of threads.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "random_map.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

RC_GTEST_PROP(Batch, GivesWhatEachMissionGivesAlone, ()) {
    const PlainMap plain_map = *random_map(24, 24);
    const Map map(plain_map.grid());
    std::vector<Mission> missions;
    for (int i = *number(0, 12); i > 0; --i) {
        missions.push_back(ground_and_air(any_free_cell(plain_map), any_free_cell(plain_map)));
        missions.back().rules.removals = *number(0, 3);
    }
    const std::vector<Expected<Plan>> results = plan_all(map, missions, {}, {}, unsigned(*number(1, 4)));
    RC_ASSERT(results.size() == missions.size());
    for (std::size_t i = 0; i < missions.size(); ++i) {
        const Plan alone = Planner().plan(map, missions[i]);
        RC_ASSERT(results[i].has_value());
        const Plan& plan = *results[i];
        RC_ASSERT(plan.status == alone.status);
        RC_ASSERT(plan.after.makespan == alone.after.makespan);
        RC_ASSERT(plan.bound == alone.bound);
        RC_ASSERT(plan.agents.size() == alone.agents.size());
        for (std::size_t a = 0; a < alone.agents.size(); ++a) RC_ASSERT(plan.agents[a].path == alone.agents[a].path);
    }
}

TEST(Batch, ABadMissionCostsTheOthersNothing) {
    const Map map{Grid(4, 4)};
    const std::vector<Mission> missions{ground_and_air({0, 0}, {9, 3}), ground_and_air({0, 0}, {3, 3})};
    const std::vector<Expected<Plan>> results = plan_all(map, missions);
    ASSERT_EQ(results.size(), 2U);
    ASSERT_FALSE(results[0]);
    EXPECT_EQ(results[0].error().code, ErrorCode::off_map);
    EXPECT_NE(results[0].error().detail.find("9,3 is off the map"), std::string::npos) << results[0].error().detail;
    ASSERT_TRUE(results[1]);
    EXPECT_EQ(results[1]->status, PlanStatus::solved);
}

}  // namespace
}  // namespace waybreaker
