#include "coalition/flight_limits.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "select/opening_times.hpp"

namespace waybreaker::coalition {
namespace {

constexpr std::size_t most_toured = 6;  // obstacles; the others are breached on the way

}  // namespace

const FlightLimits::Limits& FlightLimits::of(const Set& set) {
    const auto [known, is_new] = known_.try_emplace(set);
    if (is_new) known->second = limits_of(set);
    return known->second;
}

const FlightLimits::Legs& FlightLimits::legs(std::size_t aircraft, ObstacleId id) {
    const auto [known, is_new] = legs_[aircraft].try_emplace(id);
    Legs& legs = known->second;
    if (!is_new) return legs;
    const Agent& agent = *problem_.aircraft()[aircraft];
    for (const Cell at : problem_.map().boundary(id)) {
        const double first = distance(agent.start, at);
        const double last = distance(at, agent.goal);
        legs.first = std::min(legs.first, first);
        legs.last = std::min(legs.last, last);
        legs.whole = std::min(legs.whole, first + last);
    }
    return legs;
}

// The shortest way through each subset that ends at each of its members (Held and Karp 1962).
FlightLimits::Flights FlightLimits::flights_of(std::size_t aircraft, std::span<const ObstacleId> obstacles) {
    const Agent& agent = *problem_.aircraft()[aircraft];
    const std::size_t count = obstacles.size();
    const std::uint32_t subsets = 1U << count;
    std::vector<double> lengths(subsets * count, infinity);
    Flights flights{std::vector<double>(subsets, infinity), std::vector<double>(subsets, infinity)};
    flights.open[0] = 0;
    flights.home[0] = Problem::straight_flight(agent);
    for (std::size_t i = 0; i < count; ++i)
        lengths[(std::size_t{1} << i) * count + i] = legs(aircraft, obstacles[i]).first;
    for (std::uint32_t subset = 1; subset < subsets; ++subset) {
        if (std::popcount(subset) > agent.breaches) continue;
        double stay = 0;
        double open = infinity;
        double home = infinity;
        double whole = 0;
        for (std::size_t last = 0; last < count; ++last) {
            if ((subset >> last & 1U) == 0) continue;
            const double length = lengths[subset * count + last];
            stay += problem_.breach_time(obstacles[last]);
            open = std::min(open, length);
            home = std::min(home, length + legs(aircraft, obstacles[last]).last);
            whole = std::max(whole, legs(aircraft, obstacles[last]).whole);
            for (std::size_t next = 0; next < count; ++next) {
                if ((subset >> next & 1U) != 0) continue;
                double& longer = lengths[(subset | 1U << next) * count + next];
                const Box& from = problem_.map().obstacle(obstacles[last]).bounds;
                longer = std::min(longer, length + hop(from, problem_.map().obstacle(obstacles[next]).bounds));
            }
        }
        flights.open[subset] = open / agent.speed + stay;
        flights.home[subset] = std::max(home, whole) / agent.speed + stay;
    }
    return flights;
}

FlightLimits::Limits FlightLimits::limits_of(const Set& set) {
    const std::span<const ObstacleId> toured = std::span(set).first(std::min(set.size(), most_toured));
    const std::uint32_t subsets = 1U << toured.size();
    // Of the aircraft so far, by the subset that they breach.
    std::vector<Limits> least(subsets, {infinity, infinity, infinity});
    least[0] = {};
    for (std::size_t a = 0; a < problem_.aircraft().size(); ++a) {
        const Flights flights = flights_of(a, toured);
        std::vector<Limits> more(subsets, {infinity, infinity, infinity});
        for (std::uint32_t all = 0; all < subsets; ++all) {
            for (std::uint32_t own = all;; own = (own - 1) & all) {
                const Limits& others = least[all ^ own];
                more[all].sum = std::min(more[all].sum, others.sum + flights.home[own]);
                more[all].last = std::min(more[all].last, std::max(others.last, flights.home[own]));
                more[all].open = std::min(more[all].open, std::max(others.open, flights.open[own]));
                if (own == 0) break;
            }
        }
        least = std::move(more);
    }
    Limits limits = least[subsets - 1];
    for (const ObstacleId id : set) limits.open = std::max(limits.open, problem_.earliest_opening(id));
    for (const ObstacleId id : std::span(set).subspan(toured.size())) limits.sum += problem_.breach_time(id);
    if (problem_.rules().timing == Timing::ignore) limits.open = 0;
    return limits;
}

}  // namespace waybreaker::coalition
