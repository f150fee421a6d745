// When agents finish, against vehicles that drive from passage to passage and wait there.
#include "schedule/precedence.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "random_map.hpp"
#include "schedule/tour_times.hpp"

namespace waybreaker {
namespace {

constexpr double hair = 1e-9;

Agent aircraft(Cell start, Cell goal, double speed) {
    Agent agent;
    agent.kind = AgentKind::air;
    agent.start = start;
    agent.goal = goal;
    agent.speed = speed;
    return agent;
}

Cell any_cell() {
    return {*number(0, 30), *number(0, 30)};
}

// Aircraft that share the targets, and vehicles that pass some of them on several ways.
struct Fleet {
    std::vector<Agent> aircraft;
    std::size_t targets = 0;
    std::vector<std::vector<double>> stays;  // by aircraft and target
    std::vector<Tour> tours;
    std::vector<std::vector<Drive>> vehicles;

    Precedence precedence() const {
        std::vector<const Agent*> flyers;
        for (const Agent& agent : aircraft) flyers.push_back(&agent);
        Precedence precedence(flyers, targets, stays);
        for (const std::vector<Drive>& drives : vehicles) precedence.add_vehicle(drives);
        return precedence;
    }
};

Fleet any_fleet() {
    Fleet world;
    const int aircraft_count = *number(1, 3);
    for (int a = 0; a < aircraft_count; ++a) {
        world.aircraft.push_back(aircraft(any_cell(), any_cell(), *rc::gen::element(0.5, 1.0, 3.0)));
    }
    world.tours.resize(world.aircraft.size());
    world.targets = std::size_t(*number(0, 5));
    for (std::size_t a = 0; a < world.aircraft.size(); ++a) {
        world.stays.push_back(*rc::gen::container<std::vector<double>>(world.targets, rc::gen::element(0.0, 1.0, 7.3)));
    }
    for (std::size_t target = 0; target < world.targets; ++target) {
        world.tours[std::size_t(*number(0, aircraft_count - 1))].push_back({target, any_cell()});
    }
    world.vehicles.resize(std::size_t(*number(0, 3)));
    for (std::vector<Drive>& drives : world.vehicles) {
        drives.resize(std::size_t(*number(1, 3)));
        for (Drive& drive : drives) {
            drive.arrival = *number(0, 60);
            for (std::size_t target = 0; target < world.targets; ++target) {
                if (*number(0, 1) == 0) continue;
                drive.passages.push_back({target, drive.arrival * *number(0, 10) / 10});
            }
        }
    }
    return world;
}

// Each move and each wait one after the other.
double driven(Drive drive, const std::map<std::size_t, double>& cleared) {
    std::ranges::sort(drive.passages, {}, &Passage::due);
    double time = 0;
    double before = 0;
    for (const Passage& passage : drive.passages) {
        time = std::max(time + passage.due - before, cleared.at(passage.target));
        before = passage.due;
    }
    return time + drive.arrival - before;
}

RC_GTEST_PROP(Precedence, EverybodyFinishesWhenDrivenStepByStep, ()) {
    const Fleet world = any_fleet();
    Finish expected;
    std::map<std::size_t, double> cleared;
    for (std::size_t a = 0; a < world.tours.size(); ++a) {
        const Agent& agent = world.aircraft[a];
        Cell at = agent.start;
        double time = 0;
        for (const Stop& stop : world.tours[a]) {
            time += distance(at, stop.at) / agent.speed + world.stays[a][stop.target];
            cleared[stop.target] = time;
            at = stop.at;
        }
        expected.add(AgentKind::air, time + distance(at, agent.goal) / agent.speed);
    }
    for (const std::vector<Drive>& drives : world.vehicles) {
        std::vector<double> ends;
        for (const Drive& drive : drives) ends.push_back(driven(drive, cleared));
        expected.add(AgentKind::ground, *std::ranges::min_element(ends));
    }
    const Precedence precedence = world.precedence();
    const Finish found = precedence.finish(world.tours);
    RC_ASSERT(std::abs(found.ground - expected.ground) < hair);
    RC_ASSERT(std::abs(found.air - expected.air) < hair);
    RC_ASSERT(std::abs(found.flowtime - expected.flowtime) < hair * 100);
    const std::vector<double> times = precedence.cleared(world.tours);
    for (const auto& [target, time] : cleared) RC_ASSERT(std::abs(times[target] - time) < hair);
}

TEST(Precedence, NobodyPassesWhatNobodyBreaches) {
    const Agent flyer = aircraft({0, 0}, {0, 0}, 1);
    Precedence precedence({&flyer}, 2, {{0, 0}});
    precedence.add_vehicle({{10, {{1, 4}}}, {12, {}}});
    const std::vector<Tour> tours{{{0, {3, 0}}}};
    EXPECT_EQ(precedence.cleared(tours), (std::vector<double>{3, Precedence::never}));
    EXPECT_EQ(precedence.finish(tours).ground, 12) << "around it";
}

TEST(Precedence, VehicleWithoutAWayNeverArrives) {
    Precedence precedence({}, 0, {});
    precedence.add_vehicle({{5}});
    precedence.add_vehicle({});
    EXPECT_TRUE(std::isinf(precedence.finish({}).ground));
}

// The path says the same as the times: the end of a stay is when the target is gone.
RC_GTEST_PROP(Tour, PathHasAPointForEachTime, ()) {
    const Agent flyer = aircraft(any_cell(), any_cell(), *rc::gen::element(0.7, 1.0, 3.0));
    const double stay = *rc::gen::element(0.0, 0.1, 7.3);
    const Tour tour{{0, any_cell()}, {1, any_cell()}};
    std::vector<Waypoint> expected{{double(flyer.start.x), double(flyer.start.y), 0}};
    const auto stays = [stay](std::size_t) { return stay; };
    const double home = fly(flyer, tour, stays, [&](const Stop& stop, double begun, double cleared) {
        RC_ASSERT(cleared == begun + stay);
        expected.push_back({double(stop.at.x), double(stop.at.y), begun});
        if (stay > 0) expected.push_back({double(stop.at.x), double(stop.at.y), cleared});
    });
    expected.push_back({double(flyer.goal.x), double(flyer.goal.y), home});
    RC_ASSERT(flown(flyer, tour, stays) == expected);
    for (std::size_t i = 1; i < expected.size(); ++i) {
        const Waypoint& a = expected[i - 1];
        const Waypoint& b = expected[i];
        const double way = std::hypot(b.x - a.x, b.y - a.y);
        const double time = way > 0 ? way / flyer.speed : b.t - a.t;
        RC_ASSERT(std::abs(b.t - a.t - time) < hair);
    }
}

}  // namespace
}  // namespace waybreaker
