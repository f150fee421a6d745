// Paths tried one after the other: the known one, those next to it, those farther off.
#include <algorithm>
#include <cmath>
#include <string>

#include "core/range.hpp"
#include "safe_interval/driven.hpp"
#include "safe_interval/search.hpp"
#include "safe_interval/tuning.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {

using safe_interval::Leg;
using safe_interval::Region;
namespace tuning = safe_interval::tuning;

namespace {

void validate(const OpenedMap& map, const Traffic& traffic, Cell start, Cell goal, const SafeIntervalOptions& options) {
    validate(options.body);
    require_range(options.speed, least_speed, most_speed, "the speed");
    require_range(options.ready_at, 0, most_breach_time, "the time at which the agent is ready");
    require_range(options.rubble, 0, most_breach_time, "the time that rubble takes");
    require_range(options.since, 0, options.ready_at, "the time at which the agent is at its start");
    if (!(options.limits.seconds >= 0)) throw InputError("the time limit of a search cannot be negative");
    if (safe_interval::index_of(traffic).width() != map.width() ||
        safe_interval::index_of(traffic).height() != map.height()) {
        throw InputError("the traffic is that of a map of another size");
    }
    if (!options.known.empty() && (options.known.front() != start || options.known.back() != goal)) {
        throw InputError("the known way does not go from the start to the goal");
    }
    for (const TimedOpening& opening : options.openings) {
        if (std::ranges::binary_search(map.removed(), opening.obstacle)) continue;
        throw InputError("obstacle " + std::to_string(opening.obstacle.value) +
                         " opens at a time, but the opened map still has it");
    }
}

}  // namespace

SafeIntervalResult SafeIntervalSearcher::Search::run(const OpenedMap& map, const Traffic& traffic, Cell start,
                                                     Cell goal, const SafeIntervalOptions& options) {
    validate(map, traffic, start, goal, options);
    map_ = &map;
    traffic_ = &safe_interval::index_of(traffic);
    options_ = &options;
    sight_.emplace(map, options.body);
    start_ = start;
    goal_ = goal;
    radius_ = options.body.reach();
    deadline_ = Deadline(options.limits.seconds);
    expanded_ = 0;
    arrive_before_ = options.arrive_before;
    const auto stands = [&](Cell c) { return map.map().grid().contains(c) && sight_->fits(c); };
    SafeIntervalResult result;
    if (!stands(start) || !stands(goal)) return result;
    std::vector<Cell> way;
    result.status = find_way(way);
    if (result.status != SearchStatus::found) return result;
    std::vector<Waypoint> straight_on = safe_interval::driven(map, way, options);
    const double earliest = straight_on.back().t;
    if (meets_nobody(straight_on)) {
        result.status = earliest < options.arrive_before ? SearchStatus::found : SearchStatus::no_path;
        if (result.status == SearchStatus::found) result.path = std::move(straight_on);
        return result;
    }
    const std::size_t cells = map.map().grid().cell_count();
    if (cells <= tuning::small_map) {
        search_in(safe_interval::everywhere, way, result);
    } else {
        search_in(safe_interval::along_the_path, way, result);
        const bool late = (arrive_before_ - earliest) * options.speed > tuning::least_loss;
        const double longest = (arrive_before_ - options.ready_at) * options.speed;
        const bool interrupted = result.status != SearchStatus::found && result.status != SearchStatus::no_path;
        if (late && !interrupted && cells <= tuning::largest_map)
            search_in({std::ceil(longest / tuning::length_unit) * tuning::length_unit}, way, result);
    }
    result.expanded = expanded_;
    return result;
}

// For a path that is earlier than that of the result.
void SafeIntervalSearcher::Search::search_in(Region region, std::span<const Cell> way, SafeIntervalResult& result) {
    if (!sight_) return;  // no query has begun
    distances_ = &memory_.get(*map_, *sight_, options_->body, way, region, deadline_);
    const SearchStatus status = search();
    if (result.path.empty()) result.status = status;
    if (status != SearchStatus::found) return;
    result.path = path_to(reached_);
    arrive_before_ = result.path.back().t;
}

SearchStatus SafeIntervalSearcher::Search::find_way(std::vector<Cell>& way) {
    way.assign(options_->known.begin(), options_->known.end());
    if (!way.empty()) return SearchStatus::found;
    SearchOptions options;
    options.body = options_->body;
    options.limits = options_->limits;
    SearchResult found = searcher_.find(*map_, start_, goal_, options);
    way = std::move(found.path);
    return found.status;
}

bool SafeIntervalSearcher::Search::meets_nobody(std::span<const Waypoint> path) const {
    bool meets = false;
    for (const Leg& leg : safe_interval::TrafficIndex::legs(path, options_->stays)) {
        traffic_->near(leg, radius_, [&](const safe_interval::TrafficIndex::Piece& piece) {
            meets = !safe_interval::overlap(leg, piece.leg, traffic_->reach(piece, radius_)).empty();
            return !meets;
        });
        if (meets) return false;
    }
    return true;
}

SafeIntervalSearcher::SafeIntervalSearcher() : search_(std::make_unique<Search>()) {}
SafeIntervalSearcher::~SafeIntervalSearcher() = default;
SafeIntervalSearcher::SafeIntervalSearcher(SafeIntervalSearcher&&) noexcept = default;
SafeIntervalSearcher& SafeIntervalSearcher::operator=(SafeIntervalSearcher&&) noexcept = default;

SafeIntervalResult SafeIntervalSearcher::find(const OpenedMap& map, const Traffic& traffic, Cell start, Cell goal,
                                              const SafeIntervalOptions& options) {
    return search_->run(map, traffic, start, goal, options);
}

}  // namespace waybreaker
