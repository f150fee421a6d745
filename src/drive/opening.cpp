#include "drive/opening.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "drive/fitted.hpp"
#include "drive/shortened.hpp"
#include "model/rubble.hpp"
#include "model/timeline.hpp"

namespace waybreaker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Share of the time left for the optimal ground path, before a quick search takes over.
constexpr double share_of_optimal_path = 0.5;
// Relative, above the path of the relaxed body: a path so short is good enough; so long, the disc may have another way.
constexpr double short_enough = 0.01;
constexpr double too_long = 0.05;

// In so little time for each cell of the map the other searches may not come to their end.
constexpr double seconds_a_cell = 1e-5;

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

Opening open_by_cells(const Trip& trip, const Searchers& searchers, std::vector<ObstacleId> removed) {
    const Stopwatch watch;
    const SearchResult found =
        searchers.cells.find(OpenedMap(trip.map, removed), trip.driver.start, trip.driver.goal, trip.by_cells());
    return opening_of(std::move(removed), found, watch.seconds());
}

// `expected`: about how long the square's path is, cells; 0 if nobody knows.
Opening open_by_crossing(const Trip& trip, const Searchers& searchers, std::vector<ObstacleId> removed,
                         double expected = 0) {
    const Stopwatch watch;
    CrossingOptions options = open_search(trip, removed);
    options.expected = expected;
    const CrossingResult found = searchers.crossing.find(trip.map, trip.driver.start, trip.driver.goal, options);
    return opening_of(trip, std::move(removed), found, watch.seconds());
}

// The shorter one, with the work of both.
Opening shorter(Opening one, Opening other) {
    const bool takes_other = other.ground.length.value_or(infinity) < one.ground.length.value_or(infinity);
    Opening& taken = takes_other ? other : one;
    const Opening& left = takes_other ? one : other;
    taken.ground.expanded += left.ground.expanded;
    taken.ground.generated += left.ground.generated;
    taken.ground.seconds += left.ground.seconds;
    taken.limited = taken.limited || left.limited;
    return std::move(taken);
}

// Of obstacles that leave rubble: those on the quickest way, each worth what it costs.
std::vector<ObstacleId> worth_passing(const Trip& trip, const Searchers& searchers,
                                      const std::vector<ObstacleId>& removed) {
    const std::vector<double> prices(trip.map.obstacles().size() + 1, trip.rubble * trip.driver.speed);
    CrossingOptions options = open_search(trip, {});
    options.crossings = int(removed.size());
    options.only = removed;
    options.prices = prices;
    const CrossingResult found = searchers.crossing.find(trip.map, trip.driver.start, trip.driver.goal, options);
    return found.best.path.empty() ? removed : found.best.crossed;
}

// Whether so little time is left, for the size of the map, that Theta* comes first.
bool is_short_of_time(const Trip& trip) {
    return trip.deadline.left() < seconds_a_cell * double(trip.map.grid().cell_count());
}

// Of a disc that the square does not stand for: the square's path; where that is far above the relaxed body's, the
// shortest of it, of Theta*'s and of one along that of the relaxed body. None, if none can be shorter than so many
// cells.
Opening open_for_disc(const Trip& trip, const Searchers& searchers, std::vector<ObstacleId> removed,
                      double shorter_than) {
    const Body& body = trip.driver.body;
    const auto search_cells = [&] {
        Opening opening = open_by_cells(trip, searchers, removed);
        const std::vector<Point> path = opening.ground.path;
        if (!path.empty()) drive(trip, opening, path, path_length(path));
        return opening;
    };
    const bool cells_first = shorter_than == infinity && is_short_of_time(trip);
    Opening by_cells = cells_first ? search_cells() : Opening{removed};
    CrossingOptions options = open_search(trip, removed);
    options.relaxed = true;
    options.length_limit = shorter_than;
    const CrossingResult guide = searchers.crossing.find(trip.map, trip.driver.start, trip.driver.goal, options);
    if (guide.status == SearchStatus::no_path) return {std::move(removed)};
    Opening opening = open_by_crossing(trip, searchers, removed);
    const auto is_within = [&](double gap) {
        return opening.ground.length && *opening.ground.length <= guide.lower_bound * (1 + gap);
    };
    if (is_within(short_enough)) return opening;
    if (!cells_first) by_cells = search_cells();
    opening = shorter(std::move(opening), std::move(by_cells));
    if (guide.best.path.empty() || is_within(short_enough)) return opening;
    const Stopwatch watch;
    const double known = std::min(shorter_than, opening.ground.length.value_or(infinity));
    const OpenedMap map(trip.map, removed);
    const std::vector<Point> path = fitted(map, body, guide.best.path, known, !is_within(too_long));
    if (!path.empty()) drive(trip, opening, path, path_length(path));
    opening.ground.seconds += watch.seconds();
    return opening;
}

Opening open_all(const Trip& trip, const Searchers& searchers, std::vector<ObstacleId> removed, double shorter_than) {
    if (!trip.by_crossing()) return open_by_cells(trip, searchers, std::move(removed));
    if (!trip.driver.body.is_point() && !square_stands_for(trip.driver.body)) {
        return open_for_disc(trip, searchers, std::move(removed), shorter_than);
    }
    Opening opening = open_by_crossing(trip, searchers, removed);
    const bool out_of_time = opening.limited && !opening.ground.length && opening.ground.expanded < trip.expansions;
    if (!out_of_time) return opening;
    opening = open_by_cells(trip, searchers, std::move(removed));
    opening.limited = true;
    return opening;
}

// Past some of the removed obstacles only.
Opening open_through_rubble(const Trip& trip, const Searchers& searchers, std::vector<ObstacleId> removed,
                            double shorter_than) {
    std::vector<ObstacleId> passed = trip.by_crossing() ? worth_passing(trip, searchers, removed) : removed;
    Opening opening = open_all(trip, searchers, std::move(passed), shorter_than);
    if (!trip.by_crossing()) {
        const Opening around = open_by_cells(trip, searchers, {});
        const bool is_quicker = around.ground.length &&
                                (!opening.ground.length || cells_driven(trip, around) < cells_driven(trip, opening));
        if (is_quicker) opening.ground = around.ground;
    }
    opening.removed = std::move(removed);
    return opening;
}

}  // namespace

double cells_driven(const Trip& trip, const Opening& opening) {
    const double length = opening.ground.length.value_or(infinity);
    if (trip.rubble == 0 || !opening.ground.length) return length;
    const std::vector<double> stands =
        stands_on(trip.map, opening.ground.path, trip.driver.body, {opening.removed, trip.rubble});
    return length + std::accumulate(stands.begin(), stands.end(), 0.0) * trip.driver.speed;
}

SearchOptions Trip::by_cells() const {
    SearchOptions options = search;
    if (by_crossing()) options.planner = Algorithm::theta;
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

bool square_stands_for(const Body& body) {
    return !body.is_point() && body.reach() >= 0.36 && body.reach() <= 0.5;
}

Opening open(const Trip& trip, const Searchers& searchers, std::vector<ObstacleId> removed, double shorter_than) {
    const bool has_rubble = trip.rubble > 0 && !removed.empty();
    return has_rubble ? open_through_rubble(trip, searchers, std::move(removed), shorter_than)
                      : open_all(trip, searchers, std::move(removed), shorter_than);
}

Opening open(const Trip& trip, const Searchers& searchers, std::vector<ObstacleId> removed, const CrossingResult& found,
             double seconds, double shorter_than) {
    const Body& body = trip.driver.body;
    if (trip.by_crossing() && body.is_point()) return opening_of(trip, std::move(removed), found, seconds);
    if (!trip.by_crossing() || !square_stands_for(body) || trip.rubble > 0)
        return open(trip, searchers, std::move(removed), shorter_than);
    Opening opening = open_by_crossing(trip, searchers, removed, found.best.length);
    if (!opening.limited) return opening;
    return shorter(std::move(opening), opening_of(trip, std::move(removed), found, seconds));
}

Opening drivable(const Trip& trip, const Searchers& searchers, const CrossingPath& path,
                 std::vector<ObstacleId> removed) {
    Opening opening{std::move(removed), SearchStatus::found, {}, false};
    Route& ground = opening.ground;
    ground.path.push_back(path.path.front());
    ground.length = 0;
    auto gate = path.gates.begin();
    for (std::size_t i = 1; i < path.path.size(); ++i) {
        const Point from = ground.path.back();
        const Point to = path.path[i];
        const bool waits_there = gate != path.gates.end() && gate->at == to;
        if (!waits_there) {
            if (from != to) ground.path.push_back(to);
            *ground.length += distance(from, to);
            continue;
        }
        CrossingOptions options;
        options.body = trip.driver.body;
        options.limits = trip.limits(trip.deadline.left());
        options.removed = (gate++)->crossed;  // a gate may be where one of them stood
        const CrossingResult leg = searchers.crossing.find(trip.map, cell_of(from), cell_of(to), options);
        if (leg.best.path.empty()) {
            return {std::move(opening.removed), leg.status, {}, leg.status == SearchStatus::limit_reached};
        }
        ground.path.insert(ground.path.end(), leg.best.path.begin() + 1, leg.best.path.end());
        *ground.length += leg.best.length;
        ground.expanded += leg.expanded;
        ground.generated += leg.generated;
    }
    return opening;
}

}  // namespace waybreaker
