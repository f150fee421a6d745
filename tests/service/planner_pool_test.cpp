// Planners give their memory back.
#include "service/planner_pool.hpp"

#include <gtest/gtest.h>

#include "http/problem.hpp"
#include "live_server.hpp"
#include "mapfile/map_reader.hpp"

namespace waybreaker::service {
namespace {

using Use = MemoryBudget::Use;
using namespace std::chrono_literals;

constexpr int map_side = 700;

SharedMap thicket_map() {
    return std::make_shared<const StoredMap>(StoredMap{.file = mapfile::parse_map(thicket(map_side), "thicket")});
}

class PlannerPoolTest : public testing::Test {
  protected:
    static Plan plan(PlannerPool& pool, const SharedMap& map) {
        Method method;
        method.planner = Algorithm::theta;
        Mission mission = ground_and_air({0, 0}, {map_side - 1, map_side - 1});
        mission.rules.removals = 0;
        return pool.borrow(map).plan(map->file.map, mission, method, {.expansions = 1000});
    }
    MemoryBudget budget_{std::size_t{1} << 30};
    PlannerPool pool_{budget_};
};

TEST_F(PlannerPoolTest, KeepsItsMemoryForThePlansOfAMap) {
    const SharedMap map = thicket_map();
    plan(pool_, map);
    const std::size_t kept = budget_.used(Use::planner);
    EXPECT_GT(kept, std::size_t{16} * map_side * map_side);
    for (int i = 0; i < 20; ++i) plan(pool_, map);
    EXPECT_EQ(budget_.used(Use::planner), kept);  // nothing of the plans is left in it
}

TEST_F(PlannerPoolTest, GivesItBackWhenTheMapGoes) {
    SharedMap map = thicket_map();
    plan(pool_, map);
    pool_.release_rested(1h);
    EXPECT_GT(budget_.used(Use::planner), 0U);
    map.reset();
    pool_.release_rested(1h);
    EXPECT_EQ(budget_.used(Use::planner), 0U);
}

TEST_F(PlannerPoolTest, GivesItBackAfterARest) {
    const SharedMap map = thicket_map();
    plan(pool_, map);
    pool_.release_rested(0s);
    EXPECT_EQ(budget_.used(Use::planner), 0U);
}

TEST_F(PlannerPoolTest, GivesItBackWhenOthersNeedIt) {
    const SharedMap map = thicket_map();
    plan(pool_, map);
    MemoryBudget::Share all(budget_, Use::map);
    EXPECT_TRUE(all.grow(budget_.most()));
    EXPECT_EQ(budget_.used(Use::planner), 0U);
}

TEST_F(PlannerPoolTest, SaysWhetherAskingAgainCanHelp) {
    const SharedMap map = thicket_map();
    const auto status = [&map](PlannerPool& pool) -> int {
        try {
            plan(pool, map);
        } catch (const http::Problem& problem) {
            return problem.status();
        }
        return http::ok;
    };
    {
        MemoryBudget::Share others(budget_, Use::map);
        EXPECT_TRUE(others.grow(budget_.most() - 4'000'000));
        EXPECT_EQ(status(pool_), http::unavailable);
    }
    EXPECT_EQ(status(pool_), http::ok);
    MemoryBudget little(4'000'000);
    PlannerPool small(little);
    EXPECT_EQ(status(small), http::too_large);
    EXPECT_EQ(little.used(), 0U);  // one that ended in the middle is not used again
}

}  // namespace
}  // namespace waybreaker::service
