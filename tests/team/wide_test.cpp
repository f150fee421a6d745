// Teams of discs that the unit square does not hold: each drives as well as in a mission of its own.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "ascii_map.hpp"
#include "checked_plan.hpp"
#include "random_map.hpp"
#include "vehicle.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

double any_wide_radius() {
    return *rc::gen::element(0.6, 0.7, 0.8, 1.0, 1.2, 1.5, 2.0);
}

// What a vehicle drives in a mission of its own, nothing removed; none if there is no way.
std::optional<double> driven_alone(const Map& map, const Agent& vehicle) {
    Mission mission = ground_and_air(vehicle.start, vehicle.goal);
    mission.agents[0].body = vehicle.body;
    mission.rules.removals = 0;
    return Planner().plan(map, mission).after.ground().length;
}

Cell any_place(const PlainMap& plain, const Map& map, const Body& body) {
    std::vector<Cell> places = plain.free_cells();
    std::erase_if(places, [&](Cell c) { return !fits(OpenedMap(map), c, body); });
    RC_PRE(!places.empty());
    return places[std::size_t(*number(0, int(places.size()) - 1))];
}

RC_GTEST_PROP(WideTeam, OfOneDrivesNoFartherThanItsMission, ()) {
    const PlainMap plain = *random_map(20, 20);
    const Map map(plain.grid());
    const Body body{.radius = any_wide_radius()};
    Mission mission;
    mission.agents = {vehicle("only", any_place(plain, map, body), any_place(plain, map, body), body.radius)};
    const Plan plan = Planner().plan(map, mission);
    RC_ASSERT(plan_faults(map, mission, plan) == "");
    const std::optional<double> alone = driven_alone(map, mission.agents[0]);
    RC_ASSERT(alone.has_value() == (plan.status == PlanStatus::solved));
    if (alone) RC_ASSERT(*plan.after.routes[0].length <= *alone * (1 + 1e-9));
}

// Rooms below each other with a wall between any two.
RC_GTEST_PROP(WideTeam, InRoomsOfTheirOwnDriveNoFartherThanTheirMissions, ()) {
    constexpr int side = 14;
    const int count = *number(2, 3);
    PlainMap plain{side, count * (side + 1) - 1, {}};
    for (int room = 0; room < count; ++room) {
        if (room > 0) plain.obstacles.insert(plain.obstacles.end(), side, 1);
        PlainMap part = *random_map(side, side);
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) plain.obstacles.push_back(part.contains({x, y}) ? part.at({x, y}) : 0);
        }
    }
    const Map map(plain.grid());
    Mission mission;
    for (int room = 0; room < count; ++room) {
        const Body body{.radius = any_wide_radius()};
        PlainMap others = plain;
        for (const Cell c : plain.cells()) {
            if (c.y / (side + 1) != room) others.obstacles[plain.index(c)] = 1;
        }
        const Cell start = any_place(others, map, body);
        mission.agents.push_back(vehicle(std::to_string(room), start, any_place(others, map, body), body.radius));
    }
    const Plan plan = Planner().plan(map, mission);
    RC_ASSERT(plan_faults(map, mission, plan) == "");
    for (std::size_t i = 0; i < mission.agents.size(); ++i) {
        const std::optional<double> alone = driven_alone(map, mission.agents[i]);
        if (plan.status == PlanStatus::solved) {
            RC_ASSERT(alone.has_value());
            RC_ASSERT(*plan.after.routes[i].length <= *alone * (1 + 1e-9));
        }
    }
}

}  // namespace
}  // namespace waybreaker
