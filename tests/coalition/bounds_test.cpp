// What bounds of coalitions are made of: offers against every set of obstacles, flights against every way to share a
// set out among the aircraft, every order and every cell.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "ascii_map.hpp"
#include "coalition/all_sets.hpp"
#include "coalition/columns.hpp"
#include "coalition/offers.hpp"
#include "random_map.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::coalition {
namespace {

std::vector<Offer> any_offers() {
    std::vector<Offer> offers;
    for (std::uint32_t id = 1; id <= std::uint32_t(*number(0, 8)); ++id) {
        offers.push_back({{id}, double(*number(-2, 9)), double(*number(0, 6))});
    }
    return offers;
}

// Of the sets of at most so many offers.
double best_of(const std::vector<Offer>& offers, int most, double floor, const Set& beside) {
    double best = -std::numeric_limits<double>::infinity();
    for (std::uint32_t subset = 0; subset < 1U << offers.size(); ++subset) {
        if (std::popcount(subset) > most) continue;
        double paid = 0;
        double detour = floor;
        bool apart = true;
        for (std::size_t k = 0; k < offers.size(); ++k) {
            if ((subset >> k & 1U) == 0) continue;
            paid += offers[k].paid;
            detour = std::max(detour, offers[k].detour);
            apart = apart && !contains(beside, offers[k].obstacle);
        }
        if (apart) best = std::max(best, paid - detour);
    }
    return best;
}

RC_GTEST_PROP(Offers, HaveTheBestPaidSet, ()) {
    const std::vector<Offer> all = any_offers();
    const int most = *number(0, 4);
    const double floor = *number(0, 4);
    Set beside;
    for (const Offer& offer : all) {
        if (*number(0, 3) == 0) beside.push_back(offer.obstacle);
    }
    std::vector<ObstacleId> chosen;
    const double best = Offers(all).best(std::size_t(most), floor, beside, &chosen);
    RC_ASSERT(best == best_of(all, most, floor, beside));
    double paid = 0;
    double detour = floor;
    for (const ObstacleId id : chosen) {
        paid += all[id.value - 1].paid;
        detour = std::max(detour, all[id.value - 1].detour);
    }
    RC_ASSERT(paid - detour == best);
    RC_ASSERT(int(chosen.size()) <= most);
}

RC_GTEST_PROP(Offers, AreFreeUpToALimit, ()) {
    std::vector<Offer> all = any_offers();
    const std::size_t most = std::size_t(*number(1, 4));
    const FreeOffers free(Offers(all), most);
    const double before = Offers(all).best(most);
    const int unpriced = *number(1, 5);
    for (int i = 0; i < unpriced; ++i) {
        const double detour = *number(0, 7);
        all.push_back({{100 + std::uint32_t(i)}, free.of(detour), detour});
    }
    RC_ASSERT(Offers(all).best(most) <= before + 1e-9);
}

// The least arrival plus prices over all sets, of the relaxed body for which everything opens at once: past each set
// the shortest path that crosses nothing.
double least_of_all_sets(const Map& map, const Mission& mission, const std::vector<double>& prices) {
    const Agent& agent = mission.agents.front();
    double least = std::numeric_limits<double>::infinity();
    const auto try_sets = [&](auto& self, std::size_t next, const Set& set, double paid) -> void {
        CrossingOptions options;
        options.relaxed = true;
        options.removed = set;
        const CrossingResult found = CrossingSearcher().find(map, agent.start, agent.goal, options);
        if (found.status == SearchStatus::found) least = std::min(least, found.best.cost + paid);
        if (set.size() == std::size_t(mission.rules.removals)) return;
        for (std::size_t k = next; k < map.obstacles().size(); ++k) {
            Set more = set;
            more.push_back(map.obstacles()[k].id);
            self(self, k + 1, more, paid + prices[map.obstacles()[k].id.value]);
        }
    };
    try_sets(try_sets, 0, {}, 0);
    return least;
}

// What was proven at other prices is a bound at these: the vehicle's square costs no less; and without times it
// is as much as the relaxed body pays.
RC_GTEST_PROP(Columns, ProveLimitsOnePriceAfterTheOther, ()) {
    const PlainMap plain = *random_map(10, 10);
    const Map map(plain.grid());
    RC_PRE(!map.obstacles().empty());
    Mission mission;
    mission.agents.resize(3);
    mission.agents[0].start = any_free_cell(plain);
    mission.agents[0].goal = any_free_cell(plain);
    for (Agent* agent : {&mission.agents[1], &mission.agents[2]}) {
        agent->kind = AgentKind::air;
        agent->start = any_cell(plain);
        agent->goal = any_cell(plain);
    }
    mission.rules.removals = *number(1, 3);
    mission.rules.objective = Objective::flowtime;
    mission.rules.timing = *rc::gen::element(Timing::enforce, Timing::ignore);
    const team::Interrupts interrupts{Deadline(), {}};
    const Problem problem(map, mission, interrupts);
    CrossingSearcher crossing;
    Searcher theta;
    Workers workers(problem, crossing, theta);
    Columns columns(problem, workers, Shape::relaxed);
    EarliestOpenings openings(map, mission.rules, {problem.aircraft().begin(), problem.aircraft().end()});
    CrossingOptions driven;
    driven.crossings = mission.rules.removals;
    if (mission.rules.timing == Timing::enforce) {
        driven.opened_after = [&](std::span<const ObstacleId> crossed) {
            Set set(crossed.begin(), crossed.end());
            std::ranges::sort(set);
            return openings.of(set).open;
        };
    }
    for (int round = 0; round < 3; ++round) {
        std::vector<double> prices;
        for (std::size_t id = 0; id <= map.obstacles().size(); ++id) prices.push_back(*number(0, 6) / 2.0);
        driven.prices = prices;
        const CrossingResult best =
            CrossingSearcher().find(map, mission.agents[0].start, mission.agents[0].goal, driven);
        if (best.status != SearchStatus::found) continue;
        const double least = columns.search(0, prices, workers.own()).least;
        RC_ASSERT(least <= best.best.cost + 1e-9);
        if (mission.rules.timing == Timing::ignore) {
            RC_ASSERT(least >= least_of_all_sets(map, mission, prices) - 1e-9);
            continue;
        }
        // In time the relaxed body slips between diagonal neighbours and pays for none of them, gates cost half a cell
        // less, and a search may end early.
        constexpr double hardly_more = 0.7;
        const std::vector<double> nothing(prices.size(), 0);
        RC_ASSERT(least >= hardly_more * least_of_all_sets(map, mission, nothing));
    }
}

// The subsets of what may be removed beside what must be; one vehicle gains by all of them, if by any.
// The vehicle is through the rubble of the first obstacle long before the second one opens.
TEST(Columns, CountNoRubbleThatAWaitSwallows) {
    const Map map = map_from_ascii("S.a.....b...G");
    Mission mission{{vehicle("rover", {0, 0}, {12, 0}), aircraft("heli", {1, 0}), aircraft("idle", {0, 0})}};
    mission.agents[2].breaches = 0;
    mission.rules.removals = 2;
    mission.rules.objective = Objective::flowtime;
    mission.rules.breach_time.per_obstacle = 6;
    mission.rules.rubble = 3;
    const Plan plan = Planner().plan(map, mission);
    ASSERT_EQ(plan.breaches.size(), 2U);
    const double arrival = plan.agents[0].path.back().t;
    const team::Interrupts interrupts{Deadline(), {}};
    const Problem problem(map, mission, interrupts);
    CrossingSearcher crossing;
    Searcher theta;
    Workers workers(problem, crossing, theta);
    Columns columns(problem, workers, Shape::relaxed);
    const std::vector<double> free(map.obstacles().size() + 1, 0);
    EXPECT_LE(columns.search(0, free, workers.own()).least, arrival * (1 + 1e-9));
    const std::vector<Column>& known = columns.of(0).columns;
    const auto crosses_both = [](const Column& column) { return column.opened.size() == 2; };
    ASSERT_EQ(std::ranges::count_if(known, crosses_both), 1);
    const Column& both = *std::ranges::find_if(known, crosses_both);
    EXPECT_LE(both.arrival, arrival * (1 + 1e-9));
    EXPECT_GE(both.arrival, arrival - 2);  // all but what is a cell apart at each obstacle
}

TEST(AllSets, AreThoseThatMayBeRemoved) {
    const std::string_view picture = R"(
        S.a.b.G
        ###c###
        d......)";
    const Map map = map_from_ascii(picture);
    const auto id = [&](char mark) { return map.obstacle_at(mark_in_ascii(picture, mark)); };
    Mission mission;
    mission.agents.resize(3);
    mission.agents[0].start = mark_in_ascii(picture, 'S');
    mission.agents[0].goal = mark_in_ascii(picture, 'G');
    for (Agent* agent : {&mission.agents[1], &mission.agents[2]}) agent->kind = AgentKind::air;
    mission.rules.removals = 3;
    mission.rules.force = {id('d')};
    mission.rules.protect = {id('c'), id('#')};
    mission.rules.budget = 3;
    const team::Interrupts interrupts{Deadline(), {}};
    CrossingSearcher crossing;
    Searcher theta;
    const auto sets = [&](std::size_t most) {
        const Problem problem(map, mission, interrupts);
        Workers workers(problem, crossing, theta);
        return all_sets(problem, Columns(problem, workers, Shape::relaxed), most);
    };
    EXPECT_EQ(sets(4), (std::vector<Set>{{}, {id('a')}, {id('b')}, {id('a'), id('b')}}));
    EXPECT_EQ(sets(3), std::vector<Set>());
    mission.rules.budget = 2;
    EXPECT_EQ(sets(4), (std::vector<Set>{{}, {id('a')}, {id('b')}}));
    mission.rules.removals = 1;
    EXPECT_EQ(sets(4), std::vector<Set>{{}});
}

}  // namespace
}  // namespace waybreaker::coalition
