// Vehicles in lockstep: nobody meets anybody, and one vehicle's way is the earliest there is.
#include "lockstep/lockstep.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <optional>

#include "ascii_map.hpp"
#include "lockstep/configurations.hpp"
#include "random_map.hpp"

namespace waybreaker {
namespace {

using lockstep::Aim;
using lockstep::Direction;
using lockstep::Lattice;
using lockstep::Meeting;
using lockstep::Occupancy;
using lockstep::Route;
using lockstep::Site;

Cell at(const std::vector<Cell>& route, double t) {
    return route[std::min(std::size_t(t), route.size() - 1)];
}

// Where it is between two moments.
Point place(const std::vector<Cell>& route, double t) {
    const Cell from = at(route, t);
    const Cell to = at(route, t + 1);
    const double share = t - double(std::size_t(t));
    return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
}

// How near the centres of any two come to each other, looked at in small steps.
double nearest(const std::vector<std::vector<Cell>>& routes) {
    std::size_t last = 0;
    for (const std::vector<Cell>& route : routes) last = std::max(last, route.size());
    double least = 1e9;
    for (double t = 0; t < double(last); t += 0.125) {
        for (std::size_t a = 0; a < routes.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b)
                least = std::min(least, distance(place(routes[a], t), place(routes[b], t)));
        }
    }
    return least;
}

struct Crowd {
    Map map;
    std::vector<lockstep::Trip> trips;
};

Crowd any_crowd(int side, int most) {
    const PlainMap plain = *random_map(side, side);
    const Map map(plain.grid());
    std::vector<Cell> free = plain.free_cells();
    RC_PRE(!free.empty());
    const Lattice lattice(OpenedMap(map), {});
    const auto left = lattice.distances_to(lattice.site(free.front()));
    if (*number(0, 9) != 0) std::erase_if(free, [&](Cell c) { return left[lattice.site(c)] == Lattice::unreachable; });
    const auto shuffled = [&] {
        for (std::size_t i = free.size(); i > 1; --i) std::swap(free[i - 1], free[std::size_t(*number(0, int(i) - 1))]);
        return free;
    };
    const auto count = std::min(free.size(), std::size_t(*number(1, most)));
    const std::vector<Cell> starts = shuffled();
    const std::vector<Cell> goals = shuffled();
    Crowd crowd{Map(plain.grid()), {}};
    for (std::size_t i = 0; i < count; ++i) crowd.trips.push_back({starts[i], goals[i]});
    return crowd;
}

bool never() {
    return false;
}

RC_GTEST_PROP(Lockstep, KeepsAllApart, ()) {
    const Crowd crowd = any_crowd(8, 20);
    const double apart = *rc::gen::element(0.5, 0.7, 1.0);
    const Body body{.radius = apart / 2};
    const OpenedMap map(crowd.map);
    const auto routes =
        lockstep::move_in_lockstep(map, body, apart, crowd.trips, *rc::gen::element(Aim::sum, Aim::last), never);
    RC_CLASSIFY(!routes, "none found");
    if (!routes) return;
    RC_ASSERT(routes->size() == crowd.trips.size());
    const LineOfSight sight(map, body);
    for (std::size_t i = 0; i < routes->size(); ++i) {
        const std::vector<Cell>& route = (*routes)[i];
        RC_ASSERT(route.front() == crowd.trips[i].start && route.back() == crowd.trips[i].goal);
        for (std::size_t t = 1; t < route.size(); ++t) {
            RC_ASSERT(distance(route[t - 1], route[t]) <= 1);
            RC_ASSERT(sight.clear(route[t - 1], route[t]));
        }
    }
    RC_ASSERT(nearest(*routes) >= apart - 1e-9);
}

// The earliest arrival among routes that may stand and step, by looking at all sites at all times.
std::optional<std::size_t> earliest(const Lattice& lattice, Meeting meeting, const std::vector<Route>& others,
                                    Site start, Site goal, std::size_t latest) {
    const auto where = [](const Route& route, std::size_t t) { return route[std::min(t, route.size() - 1)]; };
    const auto taken = [&](Site site, std::size_t t) {
        return std::ranges::any_of(others, [&](const Route& other) { return where(other, t) == site; });
    };
    const auto meets = [&](Site from, Site to, std::size_t t) {
        return std::ranges::any_of(
            others, [&](const Route& other) { return meeting(from, to, where(other, t), where(other, t + 1)); });
    };
    if (taken(start, 0)) return std::nullopt;
    std::vector<Site> reached{start};
    for (std::size_t t = 0; t <= latest; ++t) {
        bool stays = std::ranges::find(reached, goal) != reached.end();
        for (std::size_t later = t; later <= t + latest; ++later) stays = stays && !taken(goal, later);
        if (stays) return t;
        std::vector<Site> next;
        const auto add = [&](Site from, Site to) {
            if (taken(to, t + 1) || meets(from, to, t) || std::ranges::find(next, to) != next.end()) return;
            next.push_back(to);
        };
        for (const Site from : reached) {
            add(from, from);
            for (Direction d = 0; d < lockstep::directions; ++d) {
                if (lattice.open(from, d)) add(from, lattice.next(from, d));
            }
        }
        reached = std::move(next);
    }
    return std::nullopt;
}

RC_GTEST_PROP(Occupancy, FindsTheEarliestWayPastOthers, ()) {
    const Crowd crowd = any_crowd(7, 5);
    const Meeting meeting{.at_turns = *rc::gen::arbitrary<bool>()};
    const Lattice lattice(OpenedMap(crowd.map), {});
    Occupancy occupancy(lattice, meeting, 1U << 16U);
    Random random(std::uint64_t(*number(0, 1000)));
    std::vector<Route> others;
    for (const lockstep::Trip& trip : crowd.trips) {
        const Site start = lattice.site(trip.start);
        const Site goal = lattice.site(trip.goal);
        constexpr std::size_t latest = 60;
        const std::optional<Route> found = occupancy.find(start, goal, latest, random);
        const std::optional<std::size_t> expected = earliest(lattice, meeting, others, start, goal, latest);
        RC_ASSERT(found.has_value() == expected.has_value());
        if (!found) continue;
        RC_ASSERT(found->size() == *expected + 1);
        RC_ASSERT(found->front() == start && found->back() == goal);
        for (std::size_t t = 0; t + 1 < found->size(); ++t) {
            for (const Route& other : others) {
                const auto where = [&](std::size_t then) { return other[std::min(then, other.size() - 1)]; };
                RC_ASSERT(where(t + 1) != (*found)[t + 1]);
                RC_ASSERT(!meeting((*found)[t], (*found)[t + 1], where(t), where(t + 1)));
            }
        }
        occupancy.add(*found);
        others.push_back(*found);
        if (*number(0, 3) != 0) continue;
        const auto gone = std::size_t(*number(0, int(others.size()) - 1));
        occupancy.remove(others[gone]);
        others.erase(others.begin() + std::ptrdiff_t(gone));
    }
}

// Two swap ends in a corridor with one bay: one has to make way for the other.
TEST(Lockstep, MakesWayInABay) {
    PlainMap plain{7, 2, {0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 1, 1, 1}};
    const Map map(plain.grid());
    const std::vector<lockstep::Trip> trips{{{0, 0}, {6, 0}}, {{6, 0}, {0, 0}}};
    EXPECT_TRUE(lockstep::move_in_lockstep(OpenedMap(map), {.radius = 0.35}, 0.7, trips, Aim::sum, never));
    const Map corridor(Grid(7, 1));
    EXPECT_FALSE(lockstep::move_in_lockstep(OpenedMap(corridor), {.radius = 0.35}, 0.7, trips, Aim::sum, never));
}

// Two come out of a dead end that a third wants to go into, and all the rest are at home: whoever looks for that by
// chance moves these about.
TEST(Lockstep, MakesWayInADeadEnd) {
    const Map map = map_from_ascii(R"(
        ..........#######
        .................
        ..........#######
        ..........#######
        ..........#######)");
    std::vector<lockstep::Trip> trips{{{16, 1}, {14, 1}}, {{15, 1}, {12, 1}}, {{14, 1}, {15, 1}}};
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 6; ++x) trips.push_back({{x, y}, {x, y}});
    }
    std::vector<std::vector<std::uint32_t>> left;
    const Lattice lattice(OpenedMap(map), {});
    lockstep::Configuration starts;
    lockstep::Configuration goals;
    for (const lockstep::Trip& trip : trips) {
        starts.push_back(lattice.site(trip.start));
        goals.push_back(lattice.site(trip.goal));
        left.push_back(lattice.distances_to(goals.back()));
    }
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const auto moves = lockstep::move_all(lattice, starts, goals, left, seed, 100, never);
        ASSERT_TRUE(moves) << "seed " << seed;
        EXPECT_EQ(moves->back(), goals);
    }
}

}  // namespace
}  // namespace waybreaker
