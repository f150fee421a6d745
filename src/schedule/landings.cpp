#include "schedule/landings.hpp"

#include <algorithm>
#include <utility>

#include "model/bases.hpp"

namespace waybreaker {
namespace {

// Of those that get to a stop, so many are looked at any further.
constexpr std::size_t most_begun = 32;

// A tour up to one of its stops.
struct Begun {
    Point at;
    Tour tour = {};
    double time = 0;                 // units of time
    double flown = 0;                // since the battery was full
    std::vector<double> lefts = {};  // when the stops are left

    bool is_no_worse_than(const Begun& other) const {
        return at == other.at && time <= other.time && flown <= other.flown &&
               std::ranges::equal(lefts, other.lefts, std::less_equal<>());
    }
};

// Without those that others beat, the earliest first.
std::vector<Begun> best_of(std::vector<Begun> all) {
    std::ranges::stable_sort(all, {}, &Begun::time);
    std::vector<Begun> best;
    for (Begun& begun : all) {
        const auto beats = [&](const Begun& other) { return other.is_no_worse_than(begun); };
        if (best.size() < most_begun && std::ranges::none_of(best, beats)) best.push_back(std::move(begun));
    }
    return best;
}

}  // namespace

std::vector<Tour> with_landings(const Agent& aircraft, std::span<const Visit> visits,
                                const std::function<double(std::size_t)>& stay) {
    const Bases bases(aircraft);
    std::vector<Begun> all{{aircraft.begin(), {}, aircraft.ready_at, aircraft.flown}};
    std::vector<Begun> longer;
    // Calls found(begun) with each way of going on to a place and staying there.
    const auto go_on = [&](const Begun& from, Point to, double stays, const auto& found) {
        for (const BaseWay& way : bases.ways(from.at, from.flown, to)) {
            if (!bases.is_enough(way.flown + stays)) continue;
            Begun& next = longer.emplace_back(from);
            for (const Cell base : way.landings) next.tour.push_back({Stop::base, base});
            next.at = to;
            next.time += way.lasts + stays;
            next.flown = way.flown + stays;
            found(next);
        }
    };
    for (const Visit& visit : visits) {
        const double stays = stay(visit.target);
        for (const Begun& begun : all) {
            for (const Cell cell : visit.cells) {
                go_on(begun, cell, stays, [&](Begun& next) {
                    next.tour.push_back({visit.target, cell});
                    next.lefts.push_back(next.time);
                });
            }
        }
        all = best_of(std::exchange(longer, {}));
    }
    for (const Begun& begun : all) go_on(begun, aircraft.goal, 0, [](Begun& next) { next.flown = 0; });
    std::vector<Tour> tours;
    for (Begun& begun : best_of(std::move(longer))) tours.push_back(std::move(begun.tour));
    return tours;
}

std::vector<Tour> with_landings(const Agent& aircraft, const Tour& tour,
                                const std::function<double(std::size_t)>& stay) {
    std::vector<Visit> visits;
    for (const Stop& stop : tour) visits.push_back({stop.target, {stop.at}});
    return with_landings(aircraft, visits, stay);
}

}  // namespace waybreaker
