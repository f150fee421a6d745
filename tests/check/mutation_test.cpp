// Plans with one thing wrong: each is rejected, for the right reason.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>
#include <map>

#include "checked_plan.hpp"
#include "hand_made.hpp"
#include "random_map.hpp"

namespace waybreaker {
namespace {

// A valid plan; agents[0] is the ground agent, which enters removed[entered].
struct LonePlan {
    const Map& map;
    Mission mission;
    Plan plan;
    std::size_t entered = 0;

    Itinerary& ground() { return plan.agents[0]; }
    Itinerary& air() { return plan.agents[1]; }
    Breach& breach() { return plan.breaches[entered]; }
};

struct Mutation {
    std::string name;
    Rule broken;
    std::function<bool(LonePlan&)> mutate;  // false if it cannot be made in this case
};

// The agent drives or flies on without a stop, so that nothing but its way is new.
void retime(Itinerary& agent) {
    for (std::size_t i = 1; i < agent.path.size(); ++i) {
        const Waypoint& a = agent.path[i - 1];
        Waypoint& b = agent.path[i];
        b.t = a.t + std::hypot(b.x - a.x, b.y - a.y) / agent.speed;
    }
}

// Any cell for which that holds.
template <class Holds>
std::optional<Cell> find_cell(const Map& map, Holds holds) {
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            if (holds(Cell{x, y})) return Cell{x, y};
        }
    }
    return std::nullopt;
}

bool is_removed(const Plan& plan, ObstacleId obstacle) {
    return std::any_of(plan.breaches.begin(), plan.breaches.end(),
                       [obstacle](const Breach& breach) { return breach.obstacle == obstacle; });
}

bool through_a_wall(LonePlan& c) {
    const auto wall = find_cell(c.map, [&](Cell cell) {
        const ObstacleId obstacle = c.map.obstacle_at(cell);
        return obstacle && !is_removed(c.plan, obstacle);
    });
    if (!wall) return false;
    c.ground().path.insert(c.ground().path.begin() + 1, {double(wall->x), double(wall->y), 0});
    retime(c.ground());
    set_figures(c.plan);
    return true;
}

bool off_the_boundary(LonePlan& c) {
    const std::vector<Cell> boundary = c.map.boundary(c.breach().obstacle);
    const auto elsewhere =
        find_cell(c.map, [&](Cell cell) { return std::count(boundary.begin(), boundary.end(), cell) == 0; });
    if (!elsewhere) return false;
    c.breach().at = *elsewhere;
    return true;
}

// Of the mutations that change one number by a clear amount.
bool add(std::optional<double>& number, double amount) {
    if (number) *number += amount;
    return number.has_value();
}

// The ground agent stands at its start for a unit of time and says why.
bool wait_at_start(LonePlan& c, Wait wait) {
    for (Waypoint& point : c.ground().path) point.t += 1;
    const Waypoint start = c.ground().path.front();
    c.ground().path.insert(c.ground().path.begin(), {start.x, start.y, 0});
    wait.at = {start.x, start.y};
    c.ground().waits = {wait};
    set_figures(c.plan);
    return true;
}

const std::vector<Mutation> mutations{
    {"leaves before it is ready", Rule::start,
     [](LonePlan& c) {
         c.mission.agents[0].ready_at = c.ground().path.back().t + 1;
         return true;
     }},
    {"breaches more than it may", Rule::capacity,
     [](LonePlan& c) {
         c.mission.agents[1].breaches = int(c.plan.breaches.size()) - 1;
         return true;
     }},
    {"drives through a wall", Rule::collision, through_a_wall},
    {"drives through what is not removed any more", Rule::collision,
     [](LonePlan& c) { return c.plan.breaches.erase(c.plan.breaches.begin() + std::ptrdiff_t(c.entered)), true; }},
    {"enters too early", Rule::collision,
     [](LonePlan& c) {
         c.mission.rules.timing = Timing::enforce;
         return c.breach().cleared_at > *c.breach().entered_at + 0.01;
     }},
    {"is cleared after it is entered", Rule::collision,
     [](LonePlan& c) {
         c.mission.rules.timing = Timing::enforce;
         c.breach().cleared_at = *c.breach().entered_at + 1;
         return true;
     }},
    {"bends between cells", Rule::vertex,
     [](LonePlan& c) {
         return c.ground().path.insert(c.ground().path.begin() + 1, {0.25, 0, 0}), true;
     }},
    {"bends off the map", Rule::vertex,
     [](LonePlan& c) {
         return c.ground().path.insert(c.ground().path.begin() + 1, {-1, 0, 0}), true;
     }},
    {"drives backwards in time", Rule::time,
     [](LonePlan& c) {
         std::vector<Waypoint>& path = c.ground().path;
         if (path.size() < 3) return false;
         std::swap(path[1].t, path[2].t);
         return path[2].t < path[1].t;
     }},
    {"drives faster than it can", Rule::speed,
     [](LonePlan& c) {
         for (Waypoint& point : c.ground().path) point.t *= 0.9;
         return true;
     }},
    {"drives slower than it does", Rule::speed, [](LonePlan& c) { return c.ground().speed *= 1.1, true; }},
    {"flies faster than it can", Rule::speed,
     [](LonePlan& c) {
         const std::vector<Waypoint>& path = c.air().path;
         c.air().path.back().t -= 0.1;
         return path[path.size() - 2].t < path.back().t;
     }},
    {"leaves something of the way out", Rule::speed,
     [](LonePlan& c) { return c.ground().path.front().x -= 100, c.ground().path.size() > 1; }},
    {"starts elsewhere", Rule::start, [](LonePlan& c) { return c.ground().start.x += 1, true; }},
    {"starts later", Rule::start,
     [](LonePlan& c) {
         for (Waypoint& point : c.air().path) point.t += 0.5;
         return true;
     }},
    {"ends elsewhere", Rule::goal, [](LonePlan& c) { return c.air().goal.y += 1, true; }},
    {"has nobody to fly", Rule::agents, [](LonePlan& c) { return c.plan.agents.pop_back(), true; }},
    {"has two to drive", Rule::agents, [](LonePlan& c) { return c.plan.agents.push_back(c.ground()), true; }},
    {"has no path", Rule::agents, [](LonePlan& c) { return c.ground().path.clear(), true; }},
    {"is another than the mission's", Rule::agents, [](LonePlan& c) { return c.air().id = "else", true; }},
    {"has no route", Rule::agents, [](LonePlan& c) { return c.plan.after.routes.pop_back(), true; }},
    {"has no speed", Rule::agents, [](LonePlan& c) { return c.ground().speed = 0, true; }},
    {"removes what there is not", Rule::obstacle,
     [](LonePlan& c) { return c.breach().obstacle.value = std::uint32_t(c.map.obstacles().size()) + 1, true; }},
    {"removes nothing", Rule::obstacle, [](LonePlan& c) { return c.breach().obstacle.value = 0, true; }},
    {"removes what is protected", Rule::obstacle,
     [](LonePlan& c) { return c.mission.rules.protect.push_back(c.breach().obstacle), true; }},
    {"removes it twice", Rule::repetition,
     [](LonePlan& c) { return c.plan.breaches.push_back(c.plan.breaches.back()), true; }},
    {"removes too many", Rule::removals,
     [](LonePlan& c) { return c.mission.rules.removals = int(c.plan.breaches.size()) - 1, true; }},
    {"removes what is too heavy", Rule::budget,
     [](LonePlan& c) { return c.mission.rules.budget = double(c.plan.breaches.size()) - 0.5, true; }},
    {"leaves what must go", Rule::removals,
     [](LonePlan& c) {
         c.mission.rules.force = {c.breach().obstacle};
         c.plan.breaches.erase(std::ranges::find(c.plan.breaches, c.mission.rules.force[0], &Breach::obstacle));
         return true;
     }},
    {"counts cells wrongly", Rule::cells, [](LonePlan& c) { return c.breach().cells += 1, true; }},
    {"names the source wrongly", Rule::cells, [](LonePlan& c) { return c.breach().source_id += 1, true; }},
    {"breaches off the boundary", Rule::boundary, off_the_boundary},
    {"breaches off the flight", Rule::breach,
     [](LonePlan& c) {
         const auto off = [&](Cell cell) {
             const auto& path = c.air().path;
             return std::none_of(path.begin(), path.end(),
                                 [cell](const Waypoint& p) { return std::hypot(p.x - cell.x, p.y - cell.y) < 1; });
         };
         const std::optional<Cell> cell = find_cell(c.map, off);
         if (cell) c.breach().at = *cell;
         return cell.has_value();
     }},
    {"is breached later", Rule::breach,
     [](LonePlan& c) { return c.breach().cleared_at += 0.2, c.air().path.back().t > c.breach().cleared_at + 1; }},
    {"is breached before the mission", Rule::breach, [](LonePlan& c) { return c.breach().cleared_at = -1, true; }},
    {"takes time to breach", Rule::breach,
     [](LonePlan& c) { return c.mission.rules.breach_time.per_cell = 0.01, true; }},
    {"lists the last breach first", Rule::order,
     [](LonePlan& c) {
         std::reverse(c.plan.breaches.begin(), c.plan.breaches.end());
         return c.plan.breaches.front().cleared_at > c.plan.breaches.back().cleared_at + 0.01;
     }},
    {"would remove it again next", Rule::next,
     [](LonePlan& c) { return c.plan.next.push_back({.obstacle = c.breach().obstacle}), true; }},
    {"would remove next what there is not", Rule::next,
     [](LonePlan& c) { return c.plan.next.push_back({.obstacle = {}}), true; }},
    {"says it is entered later", Rule::entered, [](LonePlan& c) { return add(c.breach().entered_at, 0.01); }},
    {"says it is never entered", Rule::entered, [](LonePlan& c) { return c.breach().entered_at.reset(), true; }},
    {"says it is entered", Rule::entered,
     [](LonePlan& c) {
         for (Breach& breach : c.plan.breaches) {
             if (!breach.entered_at) return breach.entered_at = 1, true;
         }
         return false;
     }},
    {"drives farther than it says", Rule::length, [](LonePlan& c) { return add(c.plan.after.ground().length, -0.01); }},
    {"flies farther than it says", Rule::length, [](LonePlan& c) { return add(c.plan.after.air().length, -0.01); }},
    {"has no length", Rule::length, [](LonePlan& c) { return c.plan.after.ground().length.reset(), true; }},
    {"ends later than it says", Rule::makespan, [](LonePlan& c) { return add(c.plan.after.makespan, -0.01); }},
    {"ends earlier than it says", Rule::makespan, [](LonePlan& c) { return add(c.plan.after.makespan, 0.01); }},
    {"adds up wrongly", Rule::flowtime, [](LonePlan& c) { return add(c.plan.after.flowtime, 0.01); }},
    {"is there at another time than it says", Rule::ground_makespan,
     [](LonePlan& c) { return add(c.plan.after.ground_makespan, 0.01); }},
    {"was there at another time before", Rule::before,
     [](LonePlan& c) { return add(c.plan.before.ground_makespan, 0.01); }},
    {"was shorter before than straight", Rule::before,
     [](LonePlan& c) { return c.plan.before.ground().length ? (c.plan.before.ground().length = -1, true) : false; }},
    {"added up wrongly before", Rule::before, [](LonePlan& c) { return add(c.plan.before.flowtime, 0.01); }},
    {"ended at another time before", Rule::before, [](LonePlan& c) { return add(c.plan.before.makespan, 0.01); }},
    {"had no end before", Rule::before,
     [](LonePlan& c) { return c.plan.before.makespan ? (c.plan.before.makespan.reset(), true) : false; }},
    {"flew another way before", Rule::before, [](LonePlan& c) { return add(c.plan.before.air().length, 0.01); }},
    {"is better than its bound", Rule::bound,
     [](LonePlan& c) { return c.plan.bound = *c.plan.after.makespan + 0.01, true; }},
    {"is better than its bound on the flowtime", Rule::bound,
     [](LonePlan& c) {
         c.mission.rules.objective = Objective::flowtime;
         c.plan.bound = *c.plan.after.flowtime + 0.01;
         return true;
     }},
    {"is better than its bound on the ground agent's arrival", Rule::bound,
     [](LonePlan& c) {
         c.mission.rules.objective = Objective::ground_makespan;
         c.plan.bound = *c.plan.after.ground_makespan + 0.01;
         return true;
     }},
    {"has a bound above doing nothing", Rule::bound,
     [](LonePlan& c) {
         if (!c.plan.before.makespan || *c.plan.before.makespan + 0.1 > *c.plan.after.makespan) return false;
         c.plan.bound = *c.plan.before.makespan + 0.1;
         return true;
     }},
    {"has another gap", Rule::gap,
     [](LonePlan& c) {
         c.plan.bound = *c.plan.after.makespan / 1.5;
         c.plan.gap = 0.4;
         return *c.plan.bound > 0;
     }},
    {"has a gap to nothing", Rule::gap, [](LonePlan& c) { return c.plan.gap = 0.1, true; }},
    {"saves less than any plan could", Rule::saves,
     [](LonePlan& c) {
         c.plan.bound = *c.plan.after.makespan - 0.5;
         return c.breach().saves = -0.6, true;
     }},
    {"fails for less than any plan could", Rule::if_failed,
     [](LonePlan& c) {
         c.plan.bound = *c.plan.after.makespan - 0.5;
         return c.breach().if_failed = IfFailed{*c.plan.bound - 0.1}, true;
     }},
    {"removes more after a failure than it may", Rule::if_failed,
     [](LonePlan& c) {
         const auto allowed = std::size_t(c.mission.rules.removals);
         c.breach().if_failed =
             IfFailed{*c.plan.after.makespan + 1, std::vector<ObstacleId>(allowed + 1, ObstacleId{1})};
         return true;
     }},
    {"gains something else", Rule::gain,
     [](LonePlan& c) {
         const auto& alone = c.plan.before.ground().length;
         if (alone) c.ground().gain = *alone / c.ground().speed - c.ground().path.back().t + 0.01;
         return alone.has_value();
     }},
    {"gains what it cannot know", Rule::gain,
     [](LonePlan& c) { return c.ground().gain = 1, !c.plan.before.ground().length; }},
    {"gains in the air", Rule::gain, [](LonePlan& c) { return c.air().gain = 0, true; }},
    {"waits where it never is", Rule::waits,
     [](LonePlan& c) {
         return c.ground().waits.push_back({.at = {-5, 1e300}, .from = 9, .until = 12}), true;
     }},
    {"waits while it drives", Rule::waits,
     [](LonePlan& c) {
         return c.ground().waits.push_back({.at = Point(c.ground().start), .from = 0, .until = 0.01}), true;
     }},
    {"waits until before", Rule::waits, [](LonePlan& c) { return wait_at_start(c, {.from = 0.5, .until = 0.2}); }},
    {"waits for nobody", Rule::waits,
     [](LonePlan& c) {
         return wait_at_start(c, {.from = 0, .until = 1, .reason = WaitReason::agent, .agent = "zzz"});
     }},
    {"waits for itself", Rule::waits,
     [](LonePlan& c) {
         return wait_at_start(c, {.from = 0, .until = 1, .reason = WaitReason::agent, .agent = c.ground().id});
     }},
    {"waits to be ready", Rule::waits,
     [](LonePlan& c) { return wait_at_start(c, {.from = 0, .until = 1, .reason = WaitReason::readiness}); }},
    {"waits for a zone that there is not", Rule::waits,
     [](LonePlan& c) { return wait_at_start(c, {.from = 0, .until = 1, .reason = WaitReason::zone, .zone = 1}); }},
    {"waits for what is not removed", Rule::waits,
     [](LonePlan& c) {
         return wait_at_start(
             c, {.from = 0, .until = 1, .reason = WaitReason::opening, .obstacle = {}, .agent = c.air().id});
     }},
    {"waits for what is open", Rule::waits,
     [](LonePlan& c) {
         const Wait wait{.from = 0,
                         .until = 1,
                         .reason = WaitReason::opening,
                         .obstacle = c.breach().obstacle,
                         .agent = c.air().id};
         return wait_at_start(c, wait) && c.breach().cleared_at < 0.9;
     }},
    {"says there is no plan", Rule::status, [](LonePlan& c) { return c.plan.status = PlanStatus::no_plan, true; }},
    {"has no agents", Rule::status, [](LonePlan& c) { return c.plan.agents.clear(), true; }},
};

// A map, a mission and the paper's plan for it, in which some removed obstacle is entered.
void for_any_case(const std::function<void(const LonePlan&)>& visit) {
    const PlainMap plain = *random_map(24, 20);
    const Map map(plain.grid());
    Mission mission = ground_and_air(any_free_cell(plain), any_free_cell(plain));
    mission.agents[0].speed = *rc::gen::element(0.5, 1.0, 4.0);
    mission.agents[1].speed = *rc::gen::element(0.5, 1.0, 4.0);
    mission.rules.removals = *number(1, 4);
    Method method;
    follow_paper(mission.rules, method);
    const Plan plan = Planner().plan(map, mission, method);
    RC_PRE(plan.status == PlanStatus::solved);
    const auto entered = std::find_if(plan.breaches.begin(), plan.breaches.end(),
                                      [](const Breach& breach) { return breach.entered_at.has_value(); });
    RC_PRE(entered != plan.breaches.end());
    visit({map, mission, plan, std::size_t(entered - plan.breaches.begin())});
}

TEST(Mutation, IsRejectedForTheRightReason) {
    // The rarest can be made in one case out of five.
    constexpr int enough_for_all = 100;
    int cases = 0;
    std::map<std::string, int> made;
    const bool all_rejected = rc::check("every mutation of every plan is rejected", [&] {
        for_any_case([&](const LonePlan& valid) {
            RC_ASSERT(broken_rules(valid.map, valid.mission, valid.plan).empty());
            ++cases;
            for (const Mutation& mutation : mutations) {
                LonePlan mutant = valid;
                if (!mutation.mutate(mutant)) continue;
                ++made[mutation.name];
                const std::set<Rule> broken = broken_rules(mutant.map, mutant.mission, mutant.plan);
                if (!broken.contains(mutation.broken)) {
                    std::string message = mutation.name + ", but breaks only";
                    for (const Rule rule : broken) message.append(" ").append(to_string(rule));
                    RC_FAIL(message);
                }
            }
        });
    });
    EXPECT_TRUE(all_rejected);
    if (cases < enough_for_all) return;
    for (const Mutation& mutation : mutations) EXPECT_GT(made[mutation.name], 0) << mutation.name;
}

TEST(Mutation, BreaksEveryRule) {
    std::set<Rule> broken;
    for (const Mutation& mutation : mutations) broken.insert(mutation.broken);
    for (int rule = int(Rule::map) + 1; rule <= int(Rule::waits); ++rule) {
        if (Rule(rule) == Rule::separation) continue;  // of teams
        EXPECT_TRUE(broken.contains(Rule(rule))) << to_string(Rule(rule));
    }
}

}  // namespace
}  // namespace waybreaker
