// Schedules of one vehicle and several aircraft, against all shares, orders and boundary cells.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "schedule/joint_schedule.hpp"
#include "world.hpp"

namespace waybreaker {
namespace {

// The least objective of all ways to breach what must be removed.
class AllSorties {
  public:
    AllSorties(const Map& map, const JointTask& task) : task_(task) {
        const std::vector<Waypoint> driven = timed(task.ground_path, task.driver.speed);
        unhindered_ = driven.back().t;
        for (const ObstacleId id : task.removed) {
            cells_.push_back(map.boundary(id));
            entries_.push_back(first_touch(map, id, driven, task.driver.body.reach()));
            stays_.push_back(task.rules.breach_time.of(map.obstacle(id)));
        }
        gone_.assign(cells_.size(), false);
        fly(0, 0, task.aircraft.front()->start, 0, {unhindered_, 0, 0});
    }
    double least = std::numeric_limits<double>::infinity();

  private:
    void fly(std::size_t a, double time, Cell at, int breached, const Finish& finish) {
        const Agent& agent = *task_.aircraft[a];
        if (breached < agent.breaches) {
            for (std::size_t i = 0; i < cells_.size(); ++i) {
                if (gone_[i]) continue;
                gone_[i] = true;
                for (const Cell c : cells_[i]) {
                    const double cleared = time + distance(at, c) / agent.speed + stays_[i];
                    Finish later = finish;
                    if (entries_[i]) {
                        later.ground = std::max(later.ground, unhindered_ + std::max(cleared - *entries_[i], 0.0));
                    }
                    fly(a, cleared, c, breached + 1, later);
                }
                gone_[i] = false;
            }
        }
        Finish landed = finish;
        landed.add(AgentKind::air, time + distance(at, agent.goal) / agent.speed);
        if (a + 1 < task_.aircraft.size()) {
            fly(a + 1, 0, task_.aircraft[a + 1]->start, 0, landed);
        } else if (std::ranges::count(gone_, false) == 0) {
            landed.flowtime += landed.ground;
            least = std::min(least, rank(task_.rules.objective, landed).first);
        }
    }

    const JointTask& task_;
    double unhindered_ = 0;
    std::vector<std::vector<Cell>> cells_;
    std::vector<std::optional<double>> entries_;
    std::vector<double> stays_;
    std::vector<bool> gone_;
};

std::vector<Agent> any_aircraft(const World& world, int count, int targets) {
    std::vector<Agent> agents(std::size_t(count), world.flyer);
    for (Agent& agent : agents) {
        agent.id = "bird" + std::to_string(&agent - agents.data());
        agent.start = {*number(0, world.map.width() - 1), *number(0, world.map.height() - 1)};
        agent.speed = *rc::gen::element(0.5, 1.0, 3.0);
    }
    if (*number(0, 2) == 0) agents.front().breaches = *number(1, targets + 1);
    return agents;
}

std::vector<const Agent*> pointers(const std::vector<Agent>& agents) {
    std::vector<const Agent*> all;
    for (const Agent& agent : agents) all.push_back(&agent);
    return all;
}

RC_GTEST_PROP(JointSchedule, IsTheBestOfAllSorties, ()) {
    const int obstacles = *number(1, 3);
    const World world = any_world(9, 7, obstacles, 2);
    RC_PRE(!world.removed.empty());
    const std::vector<Agent> agents = any_aircraft(world, 2, obstacles);
    const std::vector<const Agent*> aircraft = pointers(agents);
    const JointTask task{world.street, world.driver, aircraft, world.rules, world.removed};
    const JointSchedule schedule = best_joint_schedule(world.map, task);
    const double reached = rank(world.rules.objective, finish_of(schedule.arrival(), schedule.home)).first;
    const double least = AllSorties(world.map, task).least;
    RC_LOG() << reached << " of " << least << '\n';
    RC_ASSERT(reached >= least - 1e-6);
    const double slack = world.rules.objective == Objective::flowtime ? 0.25 : 1e-6;
    RC_ASSERT(reached <= least * (1 + slack) + 1e-6);
    RC_CLASSIFY(reached <= least + 1e-6);
}

// Each breach is once, by one who may; the figures are those of the paths.
RC_GTEST_PROP(JointSchedule, KeepsToItsTask, ()) {
    const World world = any_world(20, 16, *number(1, 9), 4);
    const std::vector<Agent> agents = any_aircraft(world, *number(1, 4), int(world.removed.size()));
    const std::vector<const Agent*> aircraft = pointers(agents);
    if (aircraft.size() == 1) RC_PRE(agents.front().breaches >= int(world.removed.size()));
    const JointTask task{world.street, world.driver, aircraft, world.rules, world.removed};
    const JointSchedule schedule = best_joint_schedule(world.map, task);
    std::vector<ObstacleId> breached;
    std::vector<int> by(agents.size(), 0);
    double last = 0;
    for (const TimedBreach& breach : schedule.breaches) {
        breached.push_back(breach.obstacle);
        ++by[breach.aircraft];
        RC_ASSERT(breach.cleared_at >= last);
        last = breach.cleared_at;
        const double stay = world.rules.breach_time.of(world.map.obstacle(breach.obstacle));
        RC_ASSERT(std::abs(breach.cleared_at - breach.begun_at - stay) < 1e-6);
        const std::vector<Waypoint>& air = schedule.air[breach.aircraft];
        RC_ASSERT(std::ranges::any_of(air, [&](const Waypoint& w) {
            return Point(w.x, w.y) == Point(breach.at) && std::abs(w.t - breach.cleared_at) < 1e-6;
        }));
        if (breach.entered_at) RC_ASSERT(*breach.entered_at >= breach.cleared_at - 1e-6);
    }
    std::ranges::sort(breached);
    RC_ASSERT(breached == world.removed);
    Returns home;
    for (std::size_t a = 0; a < agents.size(); ++a) {
        RC_ASSERT(by[a] <= agents[a].breaches);
        home = {std::max(home.last, schedule.air[a].back().t), home.sum + schedule.air[a].back().t};
    }
    RC_ASSERT(home.last == schedule.home.last && home.sum == schedule.home.sum);
}

}  // namespace
}  // namespace waybreaker
