#include "drive/opening.hpp"

#include <algorithm>
#include <utility>

#include "drive/fitted.hpp"
#include "drive/shortened.hpp"
#include "plan/timeline.hpp"

namespace waybreaker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Of the time that is left: for the optimal ground path, before a quick search takes over.
constexpr double share_of_optimal_path = 0.5;
// Likewise: for the path of Theta* that another is compared with.
constexpr double share_of_comparison = 0.2;
// Relative, above the path of the relaxed body: a path so short is good enough; so long, the disc may have another way.
constexpr double short_enough = 0.01;
constexpr double too_long = 0.05;

// As the disc drives it; a point drives the path as it is.
void drive(const Trip& trip, Opening& opening, const std::vector<Point>& path, double length) {
    opening.status = SearchStatus::found;  // even where a limit ended the search
    const Body& body = trip.driver.body;
    opening.ground.path = body.is_point() ? path : shortened(OpenedMap(trip.map, opening.removed), body, path);
    opening.ground.length = opening.ground.path == path ? length : path_length(opening.ground.path);
}

// The optimal path in half the time that is left.
CrossingOptions open_search(const Trip& trip, std::span<const ObstacleId> removed) {
    CrossingOptions options;
    options.body = trip.driver.body;
    options.removed = removed;
    options.limits = trip.limits(trip.deadline.share(share_of_optimal_path).left());
    return options;
}

Opening open_by_cells(const Trip& trip, const Searchers& searchers, std::vector<ObstacleId> removed,
                      double share_of_time = 1) {
    const Stopwatch watch;
    SearchOptions options = trip.by_cells();
    options.limits = trip.limits(trip.deadline.share(share_of_time).left());
    const SearchResult found =
        searchers.cells.find(OpenedMap(trip.map, removed), trip.driver.start, trip.driver.goal, options);
    return opening_of(std::move(removed), found, watch.seconds());
}

// Of the path and Theta*'s.
void take_shorter(const Trip& trip, const Searchers& searchers, Opening& opening) {
    Opening other = open_by_cells(trip, searchers, opening.removed, share_of_comparison);
    opening.limited = opening.limited || other.limited;
    if (other.status != SearchStatus::found) return;
    const std::vector<Point> path = std::move(other.ground.path);
    drive(trip, other, path, path_length(path));
    if (opening.ground.length.value_or(infinity) <= other.ground.length.value_or(infinity)) return;
    other.limited = opening.limited;
    opening = std::move(other);
}

}  // namespace

SearchOptions Trip::by_cells() const {
    SearchOptions options = search;
    if (by_crossing()) options.planner = Planner::theta;
    options.limits = limits(deadline.left());
    return options;
}

Opening opening_of(std::vector<ObstacleId> removed, const SearchResult& search, double seconds) {
    Opening opening{std::move(removed), search.status, {}, search.status == SearchStatus::limit_reached};
    Route& ground = opening.ground;
    if (search.status == SearchStatus::found) ground.length = search.length;
    ground.expanded = search.expanded;
    ground.generated = search.generated;
    ground.seconds = seconds;
    ground.path.assign(search.path.begin(), search.path.end());
    return opening;
}

Opening opening_of(const Trip& trip, std::vector<ObstacleId> removed, const CrossingResult& search, double seconds) {
    Opening opening{std::move(removed), search.status, {}, search.status == SearchStatus::limit_reached};
    Route& ground = opening.ground;
    ground.expanded = search.expanded;
    ground.generated = search.generated;
    ground.seconds = seconds;
    if (search.best.path.empty()) return opening;
    drive(trip, opening, search.best.path, search.best.length);
    return opening;
}

void fit_to_disc(const Trip& trip, const Searchers& searchers, Opening& opening, double shorter_than) {
    const Body& body = trip.driver.body;
    if (body.is_point() || square_stands_for(body)) return;
    const Stopwatch watch;
    CrossingOptions options = open_search(trip, opening.removed);
    options.relaxed = true;
    options.length_limit = std::min(shorter_than, opening.ground.length.value_or(infinity));
    const CrossingResult guide = searchers.crossing.find(trip.map, trip.driver.start, trip.driver.goal, options);
    if (guide.best.path.empty()) return;
    const auto is_within = [&](double gap) {
        return opening.ground.length && *opening.ground.length <= guide.lower_bound * (1 + gap);
    };
    if (is_within(short_enough)) return;
    const std::vector<Point> path =
        fitted(OpenedMap(trip.map, opening.removed), body, guide.best.path, options.length_limit, !is_within(too_long));
    if (!path.empty()) drive(trip, opening, path, path_length(path));
    if (trip.compares && !is_within(short_enough)) take_shorter(trip, searchers, opening);
    options = open_search(trip, opening.removed);
    if (!opening.ground.length &&
        searchers.crossing.has_steps(trip.map, trip.driver.start, trip.driver.goal, options)) {
        const bool limited = opening.limited;
        opening = open_by_cells(trip, searchers, std::move(opening.removed));
        opening.limited = opening.limited || limited;
    }
    opening.ground.seconds += watch.seconds();
}

bool square_stands_for(const Body& body) {
    return !body.is_point() && body.reach() >= 0.36 && body.reach() <= 0.5;
}

Opening open(const Trip& trip, const Searchers& searchers, std::vector<ObstacleId> removed) {
    const Stopwatch watch;
    if (!trip.by_crossing()) return open_by_cells(trip, searchers, std::move(removed));
    const CrossingOptions options = open_search(trip, removed);
    const CrossingResult found = searchers.crossing.find(trip.map, trip.driver.start, trip.driver.goal, options);
    const bool out_of_time = found.status == SearchStatus::limit_reached && found.best.path.empty() &&
                             found.expanded < options.limits.expansions;
    if (out_of_time) {
        Opening opening = open_by_cells(trip, searchers, std::move(removed));
        opening.limited = true;
        return opening;
    }
    Opening opening = opening_of(trip, removed, found, watch.seconds());
    fit_to_disc(trip, searchers, opening);
    return opening;
}

}  // namespace waybreaker
