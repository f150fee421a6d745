#include "schedule/earliest_openings.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "model/bases.hpp"
#include "schedule/timetable.hpp"

namespace waybreaker {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// Obstacles whose orders are looked at; the others are breached on the way.
constexpr std::size_t most_toured_by_one = 8;
constexpr std::size_t most_toured_by_several = 6;  // the time grows with 3 to this power

// From a cell beside one obstacle to a cell beside another, at least: by their boxes.
double hop(const Box& a, const Box& b) {
    const int x = std::max({a.min.x - b.max.x - 2, b.min.x - a.max.x - 2, 0});
    const int y = std::max({a.min.y - b.max.y - 2, b.min.y - a.max.y - 2, 0});
    return std::sqrt(double(x) * x + double(y) * y);
}

}  // namespace

EarliestOpenings::EarliestOpenings(const Map& map, const Rules& rules, std::vector<const Agent*> aircraft)
    : map_(map), rules_(rules), aircraft_(std::move(aircraft)), legs_(aircraft_.size()) {}

double EarliestOpenings::least_stay(ObstacleId id) const {
    double least = never;
    for (std::size_t a = 0; a < aircraft_.size(); ++a) least = std::min(least, stay(a, id));
    return least;
}

const EarliestOpenings::Times& EarliestOpenings::of(std::span<const ObstacleId> obstacles) {
    const auto [known, is_new] = known_.try_emplace({obstacles.begin(), obstacles.end()});
    if (is_new) known->second = times_of(obstacles);
    return known->second;
}

const EarliestOpenings::Legs& EarliestOpenings::legs(std::size_t aircraft, ObstacleId id) {
    const auto [known, is_new] = legs_[aircraft].try_emplace(id, Legs{never, never, never});
    Legs& legs = known->second;
    if (!is_new) return legs;
    const Agent& agent = *aircraft_[aircraft];
    for (const Cell at : map_.boundary(id)) {
        const double first = agent.airspace.length(agent.begin(), at);
        const double last = agent.airspace.length(at, agent.goal);
        legs.first = std::min(legs.first, first);
        legs.last = std::min(legs.last, last);
        legs.whole = std::min(legs.whole, first + last);
    }
    return legs;
}

// The shortest way through each subset that ends at each of its members (Held and Karp 1962).
EarliestOpenings::Flights EarliestOpenings::flights_of(std::size_t aircraft, std::span<const ObstacleId> obstacles) {
    const Agent& agent = *aircraft_[aircraft];
    const std::size_t count = obstacles.size();
    const std::uint32_t subsets = 1U << count;
    std::vector<double> lengths(subsets * count, never);
    Flights flights{std::vector<double>(subsets, never), std::vector<double>(subsets, never)};
    flights.open[0] = 0;
    flights.home[0] =
        agent.ready_at + with_recharging(agent, agent.airspace.length(agent.begin(), agent.goal) / agent.speed);
    for (std::size_t i = 0; i < count; ++i)
        lengths[(std::size_t{1} << i) * count + i] = legs(aircraft, obstacles[i]).first;
    for (std::uint32_t subset = 1; subset < subsets; ++subset) {
        if (std::popcount(subset) > agent.breaches) continue;
        double stays = 0;
        double open = never;
        double home = never;
        double farthest = 0;
        double whole = 0;
        for (std::size_t last = 0; last < count; ++last) {
            if ((subset >> last & 1U) == 0) continue;
            const double length = lengths[subset * count + last];
            const Legs& alone = legs(aircraft, obstacles[last]);
            stays += stay(aircraft, obstacles[last]);
            open = std::min(open, length);
            home = std::min(home, length + alone.last);
            farthest = std::max(farthest, alone.first);
            whole = std::max(whole, alone.whole);
            const Box& from = map_.obstacle(obstacles[last]).bounds;
            for (std::size_t next = 0; next < count; ++next) {
                if ((subset >> next & 1U) != 0) continue;
                double& longer = lengths[(subset | 1U << next) * count + next];
                longer = std::min(longer, length + hop(from, map_.obstacle(obstacles[next]).bounds));
            }
        }
        double& opened = flights.open[subset];
        double& landed = flights.home[subset];
        opened = agent.ready_at + with_recharging(agent, std::max(open, farthest) / agent.speed + stays);
        landed = agent.ready_at + with_recharging(agent, std::max(home, whole) / agent.speed + stays);
        if (!agent.may_land_at(landed)) opened = landed = never;
        // By boxes, a flight by way of a large obstacle would be shorter than one past it.
        for (std::uint32_t rest = subset; rest != 0; rest &= rest - 1) {
            const std::uint32_t fewer = subset & ~(rest & (~rest + 1));
            opened = std::max(opened, flights.open[fewer]);
            landed = std::max(landed, flights.home[fewer]);
        }
    }
    return flights;
}

EarliestOpenings::Times EarliestOpenings::times_of(std::span<const ObstacleId> all) {
    // What opens by itself is nobody's to breach.
    const std::vector<ObstacleId> rest = to_breach(rules_, all);
    Times times = times_of_breached(rest);
    if (rules_.timing == Timing::ignore) return times;
    for (const TimedOpening& opening : rules_.opened) {
        if (std::ranges::find(all, opening.obstacle) != all.end()) times.open = std::max(times.open, opening.at);
    }
    return times;
}

EarliestOpenings::Times EarliestOpenings::times_of_breached(std::span<const ObstacleId> obstacles) {
    const std::size_t most = aircraft_.size() == 1 ? most_toured_by_one : most_toured_by_several;
    const std::span<const ObstacleId> toured = obstacles.first(std::min(obstacles.size(), most));
    const std::uint32_t subsets = 1U << toured.size();
    constexpr Times none{never, {never, never}};
    // Of the aircraft so far, by the subset that they breach.
    std::vector<Times> least(subsets, none);
    least[0] = {};
    for (std::size_t a = 0; a < aircraft_.size(); ++a) {
        const Flights flights = flights_of(a, toured);
        const double weight = aircraft_[a]->weight;
        std::vector<Times> more(subsets, none);
        for (std::uint32_t all = 0; all < subsets; ++all) {
            for (std::uint32_t own = all;; own = (own - 1) & all) {
                const Times& others = least[all ^ own];
                Times& both = more[all];
                both.open = std::min(both.open, std::max(others.open, flights.open[own]));
                both.home.last = std::min(both.home.last, std::max(others.home.last, flights.home[own]));
                both.home.sum = std::min(both.home.sum, others.home.sum + weighted(weight, flights.home[own]));
                if (own == 0 || a == 0) break;  // before the first aircraft nothing is breached
            }
        }
        least = std::move(more);
    }
    Times times = least[subsets - 1];
    double rest = 0;
    for (const ObstacleId id : obstacles.subspan(toured.size())) rest += least_stay(id);
    times.home.sum += weighted(least_weight_of(aircraft_), rest);
    if (aircraft_.size() == 1) {
        times.open += rest;
        times.home.last += rest;
    }
    add_single_visits(obstacles, times);
    if (rules_.timing == Timing::ignore) times.open = 0;
    return times;
}

// Some aircraft flies to each of them; an only one breaches all others as well.
void EarliestOpenings::add_single_visits(std::span<const ObstacleId> obstacles, Times& times) {
    double all = 0;
    for (const ObstacleId id : obstacles) all += least_stay(id);
    for (const ObstacleId id : obstacles) {
        double open = never;
        double home = never;
        for (std::size_t a = 0; a < aircraft_.size(); ++a) {
            const Agent& agent = *aircraft_[a];
            if (agent.breaches == 0) continue;
            const double stays = aircraft_.size() == 1 ? all : stay(a, id);
            const double landed = agent.ready_at + with_recharging(agent, legs(a, id).whole / agent.speed + stays);
            if (!agent.may_land_at(landed)) continue;
            open = std::min(open, agent.ready_at + with_recharging(agent, legs(a, id).first / agent.speed + stays));
            home = std::min(home, landed);
        }
        times.open = std::max(times.open, open);
        times.home.last = std::max(times.home.last, home);
    }
}

}  // namespace waybreaker
