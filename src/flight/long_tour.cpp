#include "flight/long_tour.hpp"

#include <algorithm>
#include <limits>

#include "flight/best_cells.hpp"
#include "flight/exact.hpp"
#include "flight/local_search.hpp"

namespace waybreaker {
namespace {

// The tour's stops, inserted one after another, in order of target, where each lengthens the tour least.
Tour by_insertion(Point start, Tour stops, Point goal, const Airspace& air) {
    std::ranges::sort(stops, {}, &Stop::target);
    Tour tour;
    for (const Stop& stop : stops) {
        double least = std::numeric_limits<double>::infinity();
        std::size_t place = 0;
        for (std::size_t i = 0; i <= tour.size(); ++i) {
            const Point from = i > 0 ? Point(tour[i - 1].at) : start;
            const Point to = i < tour.size() ? Point(tour[i].at) : goal;
            const double more = air.length(from, stop.at) + air.length(stop.at, to) - air.length(from, to);
            if (more >= least) continue;
            least = more;
            place = i;
        }
        tour.insert(tour.begin() + std::ptrdiff_t(place), stop);
    }
    return tour;
}

// Plans the stops first..first + exact_window - 1 anew, in any order and at any cells. Whether that gains.
bool replan_part(Point start, Tour& tour, Point goal, std::span<const Target> targets, const Airspace& air,
                 std::size_t first) {
    const std::size_t last = std::min(first + exact_window, tour.size());
    const Point from = first > 0 ? Point(tour[first - 1].at) : start;
    const Point to = last < tour.size() ? Point(tour[last].at) : goal;
    std::vector<std::size_t> members;
    for (std::size_t i = first; i < last; ++i) members.push_back(tour[i].target);
    std::ranges::sort(members);

    std::vector<Target> part;
    for (const std::size_t member : members) part.push_back(targets[member]);
    Tour known;
    for (std::size_t i = first; i < last; ++i) {
        const auto member = std::ranges::lower_bound(members, tour[i].target);
        known.push_back({std::size_t(member - members.begin()), tour[i].at});
    }
    const Tour better = shortest_tour(from, to, part, known, air);
    if (tour_length(from, better, to, air) > tour_length(from, known, to, air) - least_gain) return false;
    for (std::size_t i = 0; i < better.size(); ++i) tour[first + i] = {members[better[i].target], better[i].at};
    return true;
}

// Replans overlapping parts, then the cells of all stops, until nothing gains or the time is over.
Tour by_windows(Point start, Tour tour, Point goal, std::span<const Target> targets, const Airspace& air,
                const Deadline& deadline) {
    for (bool better = true; better;) {
        better = false;
        for (std::size_t first = 0; first < tour.size() && !deadline.passed(); first += exact_window / 2) {
            better = replan_part(start, tour, goal, targets, air, first) || better;
        }
        if (better) {
            tour = improved_tour(start, std::move(tour), goal, targets, air);
        } else if (!deadline.passed()) {
            better = choose_best_cells(start, tour, goal, targets, air);
        }
    }
    return tour;
}

}  // namespace

Tour good_tour(Point start, Point goal, std::span<const Target> targets, const Tour& known, const Airspace& air,
               const Deadline& deadline) {
    Tour first = by_windows(start, improved_tour(start, known, goal, targets, air), goal, targets, air, deadline);
    if (deadline.passed()) return first;
    const Tour inserted = by_insertion(start, known, goal, air);
    const Tour second =
        by_windows(start, improved_tour(start, inserted, goal, targets, air), goal, targets, air, deadline);
    return tour_length(start, second, goal, air) < tour_length(start, first, goal, air) ? second : first;
}

}  // namespace waybreaker
