#include "experiment/missions.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "ascii_map.hpp"
#include "input_error.hpp"
#include "waybreaker/advanced/search.hpp"

namespace waybreaker::experiment {
namespace {

// A wall with a door far from the middle, and a closed yard.
Map walled() {
    Grid grid(60, 40);
    for (int y = 0; y < 36; ++y) grid.set_blocked({30, y}, true);
    for (int i = 50; i < 57; ++i) {
        for (const Cell c : {Cell{i, 3}, Cell{i, 9}, Cell{50, i - 47}, Cell{56, i - 47}}) grid.set_blocked(c, true);
    }
    return Map(std::move(grid));
}

const MissionRules rules{.pairs = 300, .min_distance = 20, .min_detour = 0.1, .seed = 5};

TEST(DrawMissions, KeepWhatTheRulesSay) {
    const Map map = walled();
    const DrawnMissions missions = draw_missions(map, rules);
    EXPECT_EQ(missions.drawn, 300U);
    EXPECT_GT(missions.without_way, 0U) << "of the yard";
    EXPECT_GT(missions.kept.size(), 50U);
    EXPECT_LT(missions.kept.size() + missions.without_way, missions.drawn) << "most straight ones are dropped";
    const OpenedMap closed(map);
    Searcher searcher;
    for (const Scenario& mission : missions.kept) {
        EXPECT_GT(distance(mission.start, mission.goal), rules.min_distance);
        const double theta = searcher.find(closed, mission.start, mission.goal).length;
        EXPECT_GT(theta, 1.1 * distance(mission.start, mission.goal));
        const double dijkstra =
            searcher.find(closed, mission.start, mission.goal, {.planner = Algorithm::dijkstra}).length;
        EXPECT_NEAR(mission.optimal_length, dijkstra, 1e-9);
        EXPECT_EQ(mission.bucket, int(mission.optimal_length / 4));
        EXPECT_EQ(mission.width, 60);
        EXPECT_EQ(mission.height, 40);
    }
}

TEST(DrawMissions, DropsAreExactlyWhatTheDetourExcludes) {
    MissionRules all = rules;
    all.min_detour = 0;
    const Map map = walled();
    const OpenedMap closed(map);
    Searcher searcher;
    const DrawnMissions drawn = draw_missions(map, all);
    const auto long_enough = [&](const Scenario& mission) {
        return searcher.find(closed, mission.start, mission.goal).length > 1.1 * distance(mission.start, mission.goal);
    };
    EXPECT_EQ(std::ranges::count_if(drawn.kept, long_enough), std::ssize(draw_missions(map, rules).kept));
}

// Pins the numbers: what is drawn must not change between versions or platforms.
TEST(DrawMissions, AreTheSameEverywhere) {
    const DrawnMissions missions = draw_missions(walled(), rules);
    ASSERT_GE(missions.kept.size(), 2U);
    EXPECT_EQ(missions.kept[0].start, (Cell{54, 28}));
    EXPECT_EQ(missions.kept[0].goal, (Cell{21, 29}));
    EXPECT_EQ(missions.kept.size(), 143U);
}

TEST(DrawMissions, DependOnSeedAndMap) {
    const auto first_start = [](const Map& map, std::uint64_t seed) {
        return draw_missions(map, {.pairs = 1, .min_distance = 10, .min_detour = 0, .seed = seed}).kept;
    };
    MissionRules other = rules;
    ++other.seed;
    const auto starts = [](const DrawnMissions& missions) {
        std::vector<Cell> cells;
        for (const Scenario& mission : missions.kept) cells.push_back(mission.start);
        return cells;
    };
    EXPECT_NE(starts(draw_missions(walled(), rules)), starts(draw_missions(walled(), other)));
    EXPECT_EQ(first_start(Map(Grid(50, 50)), 1).size() + first_start(Map(Grid(51, 50)), 1).size(), 0U)
        << "no detour on a free map";
    Grid changed = walled().grid();
    changed.set_blocked({0, 0}, true);
    EXPECT_NE(starts(draw_missions(walled(), rules)), starts(draw_missions(Map(std::move(changed)), rules)));
}

TEST(DrawMissions, SayThatTheMapHasNoSuchPairs) {
    EXPECT_EQ(input_error([] { draw_missions(Map(Grid(20, 20)), {.pairs = 1, .min_distance = 27}); }),
              "no two free cells that lie far enough apart were found in 1000000 draws: lower --min-distance");
    Grid full(3, 1);
    for (int x = 0; x < 3; ++x) full.set_blocked({x, 0}, true);
    const Map closed(std::move(full));
    EXPECT_NE(input_error([&] { draw_missions(closed, {.pairs = 1, .min_distance = 0}); }), "");
}

TEST(DrawMissions, MakeTeamsOfThePairs) {
    const Map map = walled();
    MissionRules near = rules;
    near.pairs = 2000;
    const std::vector<Scenario> pairs = draw_missions(map, near).kept;
    Rules of_team;
    of_team.objective = Objective::flowtime;
    const std::vector<Mission> teams = teams_of(map, pairs, {5, 7}, of_team);
    ASSERT_GT(teams.size(), 3U);
    EXPECT_LE(teams.size(), pairs.size() / 5);
    std::size_t pair = 0;
    for (const Mission& team : teams) {
        ASSERT_EQ(team.agents.size(), 12U);
        validate(map, team);
        EXPECT_EQ(team.rules.objective, Objective::flowtime);
        for (std::size_t i = 0; i < 12; ++i) {
            const Agent& agent = team.agents[i];
            EXPECT_EQ(agent.kind, i < 5 ? AgentKind::ground : AgentKind::air);
            if (i >= 5) {
                EXPECT_EQ(agent.start, team.agents[(i - 5) % 5].start);
                EXPECT_EQ(agent.goal, team.agents[(i - 5) % 5].goal);
                continue;
            }
            // Each pair once, in order; some are left out.
            while (pair < pairs.size() && (pairs[pair].start != agent.start || pairs[pair].goal != agent.goal)) ++pair;
            ASSERT_LT(pair++, pairs.size());
        }
    }
    EXPECT_EQ(teams_of(map, pairs, {1, 1}, {}).size(), pairs.size());
    EXPECT_FALSE(teams_of(map, pairs, {1, 1}, {}).front().is_team());
}

}  // namespace
}  // namespace waybreaker::experiment
