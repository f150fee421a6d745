// Earliest openings are lower bounds of all flights, against all shares, orders and boundary cells.
#include "schedule/earliest_openings.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "random_map.hpp"

namespace waybreaker {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// Flights that breach a set, each of the aircraft in turn: the least of each figure, the others aside.
class Flights {
  public:
    Flights(const Map& map, const Rules& rules, std::vector<const Agent*> aircraft, std::vector<ObstacleId> set)
        : map_(map), rules_(rules), aircraft_(std::move(aircraft)), set_(std::move(set)), gone_(set_.size(), false) {
        fly(0, 0, aircraft_.front()->start, 0, {});
    }
    EarliestOpenings::Times least{never, {never, never}};

  private:
    void fly(std::size_t a, double time, Cell at, int breached, EarliestOpenings::Times so_far) {
        const Agent& agent = *aircraft_[a];
        if (breached < agent.breaches) {
            for (std::size_t j = 0; j < set_.size(); ++j) {
                if (gone_[j]) continue;
                gone_[j] = true;
                for (const Cell c : map_.boundary(set_[j])) {
                    const double stay = rules_.breach_time.of(map_.obstacle(set_[j]));
                    const double open = time + distance(at, c) / agent.speed + stay;
                    EarliestOpenings::Times more = so_far;
                    more.open = std::max(more.open, open);
                    fly(a, open, c, breached + 1, more);
                }
                gone_[j] = false;
            }
        }
        const double home = time + distance(at, agent.goal) / agent.speed;
        so_far.home = {std::max(so_far.home.last, home), so_far.home.sum + home};
        if (a + 1 < aircraft_.size()) {
            fly(a + 1, 0, aircraft_[a + 1]->start, 0, so_far);
        } else if (std::ranges::count(gone_, true) == std::ptrdiff_t(gone_.size())) {
            least.open = std::min(least.open, so_far.open);
            least.home.last = std::min(least.home.last, so_far.home.last);
            least.home.sum = std::min(least.home.sum, so_far.home.sum);
        }
    }

    const Map& map_;
    const Rules& rules_;
    std::vector<const Agent*> aircraft_;
    std::vector<ObstacleId> set_;
    std::vector<bool> gone_;
};

RC_GTEST_PROP(EarliestOpenings, AreBelowEveryFlight, ()) {
    const int count = *number(1, 2);
    const int side = count == 1 ? 9 : 7;
    const PlainMap plain = *random_map(side, side);
    const Map map(plain.grid());
    RC_PRE(!map.obstacles().empty());
    Rules rules;
    rules.breach_time = {*rc::gen::element(0.0, 2.0), *rc::gen::element(0.0, 0.5)};
    std::vector<Agent> agents(std::size_t(count), Agent{.kind = AgentKind::air});
    std::vector<const Agent*> aircraft;
    for (Agent& agent : agents) {
        agent.start = any_cell(plain);
        agent.goal = any_cell(plain);
        agent.speed = *rc::gen::element(0.5, 1.0, 3.0);
        if (*number(0, 3) == 0) agent.breaches = *number(0, 2);
        aircraft.push_back(&agent);
    }
    std::vector<ObstacleId> set = some_obstacles(map, count == 1 ? 3 : 2);
    std::ranges::sort(set);
    set.erase(std::ranges::unique(set).begin(), set.end());
    const EarliestOpenings::Times exact = Flights(map, rules, aircraft, set).least;
    const EarliestOpenings::Times times = EarliestOpenings(map, rules, aircraft).of(set);
    RC_ASSERT(times.open <= exact.open + 1e-9);
    RC_ASSERT(times.home.last <= exact.home.last + 1e-9);
    RC_ASSERT(times.home.sum <= exact.home.sum + 1e-9);
    RC_ASSERT(std::isinf(times.home.sum) == std::isinf(exact.home.sum));
    // One obstacle is by way of one cell.
    if (set.size() > 1) return;
    RC_ASSERT(times.open >= exact.open - 1e-9);
    RC_ASSERT(times.home.last >= exact.home.last - 1e-9);
    RC_ASSERT(times.home.sum >= exact.home.sum - 1e-9);
}

// A larger set is never open earlier.
RC_GTEST_PROP(EarliestOpenings, GrowWithTheSet, ()) {
    const PlainMap plain = *random_map(16, 16);
    const Map map(plain.grid());
    Rules rules;
    rules.breach_time = {*rc::gen::element(0.0, 2.0), *rc::gen::element(0.0, 0.5)};
    std::vector<Agent> agents(std::size_t(*number(1, 3)), Agent{.kind = AgentKind::air});
    std::vector<const Agent*> aircraft;
    for (Agent& agent : agents) {
        agent.start = any_cell(plain);
        agent.goal = any_cell(plain);
        aircraft.push_back(&agent);
    }
    EarliestOpenings openings(map, rules, aircraft);
    EarliestOpenings::Times before = openings.of({});
    std::vector<ObstacleId> set;
    for (const Obstacle& obstacle : map.obstacles()) {
        if (set.size() == (aircraft.size() == 1 ? 8 : 6)) break;
        set.push_back(obstacle.id);
        const EarliestOpenings::Times times = openings.of(set);
        RC_ASSERT(times.open >= before.open - 1e-9);
        RC_ASSERT(times.home.last >= before.home.last - 1e-9);
        RC_ASSERT(times.home.sum >= before.home.sum - 1e-9);
        before = times;
    }
}

}  // namespace
}  // namespace waybreaker
