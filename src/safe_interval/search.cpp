#include "safe_interval/search.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/range.hpp"
#include "safe_interval/driven.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {

using safe_interval::for_ever;
using safe_interval::Interval;
using safe_interval::Leg;
using safe_interval::Move;
using safe_interval::Vector;

namespace {

// Of more cells: ways near the known one are tried first.
constexpr std::size_t small_map = 4096;
// Of more cells: no others are.
constexpr std::size_t largest_map = std::size_t{1} << 22U;

void validate(const OpenedMap& map, const Traffic& traffic, Cell start, Cell goal, const SafeIntervalOptions& options) {
    validate(options.body);
    require_range(options.speed, least_speed, most_speed, "the speed");
    require_range(options.ready_at, 0, most_breach_time, "the time at which the agent is ready");
    if (!(options.limits.seconds >= 0)) throw InputError("the time limit of a search cannot be negative");
    if (traffic.index().width() != map.width() || traffic.index().height() != map.height()) {
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

Vector vector_of(Cell c) {
    return {double(c.x), double(c.y)};
}

Move move_between(Cell from, Cell to, double speed) {
    const double duration = distance(from, to) / speed;
    return {vector_of(from), (1 / duration) * (vector_of(to) - vector_of(from)), duration};
}

}  // namespace

SafeIntervalResult SafeIntervalSearcher::Search::run(const OpenedMap& map, const Traffic& traffic, Cell start,
                                                     Cell goal, const SafeIntervalOptions& options) {
    validate(map, traffic, start, goal, options);
    map_ = &map;
    traffic_ = &traffic.index();
    options_ = &options;
    sight_.emplace(map, options.body);
    start_ = start;
    goal_ = goal;
    radius_ = options.body.reach();
    deadline_ = Deadline(options.limits.seconds);
    expanded_ = 0;
    const auto stands = [&](Cell c) { return map.map().grid().contains(c) && sight_->fits(c); };
    SafeIntervalResult result;
    if (!stands(start) || !stands(goal)) return result;
    std::vector<Cell> way;
    result.status = find_way(way);
    if (result.status != SearchStatus::found) return result;
    if (std::vector<Waypoint> path = safe_interval::driven(map.map(), way, options); meets_nobody(path)) {
        result.status = path.back().t < options.arrive_before ? SearchStatus::found : SearchStatus::no_path;
        if (result.status == SearchStatus::found) result.path = std::move(path);
        return result;
    }
    const std::size_t cells = map.map().grid().cell_count();
    const bool small = cells <= small_map;
    if (!small) {
        distances_ = &memory_.get(map, *sight_, options.body, goal, way, deadline_);
        result.status = search();
    }
    const bool far = cells <= largest_map && options.arrive_before == for_ever;
    if (small || (result.status == SearchStatus::no_path && far)) {
        distances_ = &memory_.get(map, *sight_, options.body, goal, {}, deadline_);
        result.status = search();
    }
    if (result.status == SearchStatus::found) result.path = path_to(reached_);
    result.expanded = expanded_;
    return result;
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
    for (const Leg& leg : Traffic::Index::legs(path, options_->stays)) {
        traffic_->near(leg, radius_, [&](const Traffic::Index::Piece& piece) {
            meets = !safe_interval::overlap(leg, piece.leg, traffic_->reach(piece, radius_)).empty();
            return !meets;
        });
        if (meets) return false;
    }
    return true;
}

SearchStatus SafeIntervalSearcher::Search::search() {
    nodes_.clear();
    open_.clear();
    if (!distances_->complete()) return SearchStatus::limit_reached;
    nodes_of_.resize(std::max(nodes_of_.size(), distances_->size()));
    ++query_;
    reached_ = none;
    const Nodes ends = nodes_at(goal_);
    if (ends.count == 0) return SearchStatus::no_path;
    const Node& last = nodes_[ends.first + ends.count - 1];
    if (options_->stays && last.to < for_ever) return SearchStatus::no_path;
    goal_free_from_ = options_->stays ? last.from : 0;
    const Nodes starts = nodes_at(start_);
    if (starts.count == 0 || nodes_[starts.first].from > 0 || nodes_[starts.first].to < options_->ready_at) {
        return SearchStatus::no_path;
    }
    nodes_[starts.first].arrival = options_->ready_at;
    push(starts.first, options_->ready_at, none);
    while (!open_.empty()) {
        if (const auto ended = interrupted()) return *ended;
        std::pop_heap(open_.begin(), open_.end());
        const Open best = open_.back();
        open_.pop_back();
        const Node& node = nodes_[best.node];
        if (node.expanded) continue;
        if (best.by != none) {
            if (best.arrival < node.arrival) come_from(best.by, best.node);
            continue;
        }
        if (best.arrival > node.arrival) continue;
        ++expanded_;
        if (is_end(best.node)) {
            reached_ = best.node;
            return SearchStatus::found;
        }
        expand(best.node);
    }
    return SearchStatus::no_path;
}

std::optional<SearchStatus> SafeIntervalSearcher::Search::interrupted() const {
    if (expanded_ >= options_->limits.expansions) return SearchStatus::limit_reached;
    if (expanded_ % 64 != 0) return std::nullopt;
    if (options_->limits.stop.stop_requested()) return SearchStatus::stopped;
    return deadline_.passed() ? std::optional(SearchStatus::limit_reached) : std::nullopt;
}

SafeIntervalSearcher::Search::Nodes SafeIntervalSearcher::Search::nodes_at(Cell cell) {
    Nodes& nodes = nodes_of_[distances_->index(cell)];
    if (nodes.query == query_) return nodes;
    nodes.query = query_;
    nodes.first = std::uint32_t(nodes_.size());
    add_nodes(cell);
    nodes.count = std::uint32_t(nodes_.size()) - nodes.first;
    return nodes;
}

// One for each safe interval: what is left of time when all that comes too near is taken away.
void SafeIntervalSearcher::Search::add_nodes(Cell cell) {
    unsafe_.clear();
    const Leg here{vector_of(cell), {}, 0, for_ever};
    traffic_->near(here, radius_, [&](const Traffic::Index::Piece& piece) {
        const Interval near = safe_interval::overlap(piece.leg, here, traffic_->reach(piece, radius_));
        if (!near.empty()) unsafe_.push_back(near);
        return true;
    });
    std::ranges::sort(unsafe_, {}, &Interval::from);
    double from = 0;
    const auto add = [&](double to) {
        Node node;
        node.cell = cell;
        node.from = from;
        node.to = to;
        nodes_.push_back(node);
    };
    for (const Interval& near : unsafe_) {
        if (near.from > from) add(near.from);
        from = std::max(from, near.to);
    }
    if (from < for_ever) add(for_ever);
}

bool SafeIntervalSearcher::Search::is_end(std::uint32_t node) const {
    return nodes_[node].cell == goal_ && (!options_->stays || nodes_[node].to == for_ever);
}

// `by` none: the node is reached at that time. Else it may be, from `by` or its parent, and is looked at when its turn
// comes: most turns never do.
void SafeIntervalSearcher::Search::push(std::uint32_t at, double arrival, std::uint32_t by) {
    const double ahead = double(distances_->to_goal(nodes_[at].cell)) / options_->speed;
    const double cost = std::max(arrival + ahead, goal_free_from_);
    if (!(cost < options_->arrive_before) || cost == for_ever) return;
    open_.push_back({cost, ahead, arrival, at, by});
    std::push_heap(open_.begin(), open_.end());
}

// To all neighbours, and to the next bend of the way on if nobody were there.
void SafeIntervalSearcher::Search::expand(std::uint32_t at) {
    nodes_[at].expanded = true;
    const Cell here = nodes_[at].cell;
    offer(at, distances_->next(here));
    for (const Cell step : safe_interval::steps) {
        const Cell beside{here.x + step.x, here.y + step.y};
        if (distances_->to_goal(beside) == safe_interval::Distances::unknown || !sees(here, beside)) continue;
        offer(at, beside);
    }
}

// Opens the nodes of a cell that might be reached earlier than by what is known: if nobody is in the way.
void SafeIntervalSearcher::Search::offer(std::uint32_t by, Cell to) {
    const Nodes nodes = nodes_at(to);
    const Node from = nodes_[by];
    const double duration = distance(from.cell, to) / options_->speed;
    double earliest = from.arrival + duration;
    double latest = from.to + duration;
    if (from.parent != none) {
        const Node& parent = nodes_[from.parent];
        const double direct = distance(parent.cell, to) / options_->speed;
        earliest = std::min(earliest, parent.arrival + direct);
        latest = std::max(latest, parent.to + direct);
    }
    for (std::uint32_t at = nodes.first; at < nodes.first + nodes.count; ++at) {
        const Node& node = nodes_[at];
        const double arrival = std::max(earliest, node.from);
        if (node.expanded || arrival >= node.arrival || arrival > node.to || latest < node.from) continue;
        push(at, arrival, by);
    }
}

// As Theta*: straight from where `by` was come from, if that can be; else from `by`.
void SafeIntervalSearcher::Search::come_from(std::uint32_t by, std::uint32_t to) {
    const double known = nodes_[to].arrival;
    if (nodes_[by].parent != none) relax(nodes_[by].parent, to);
    relax(by, to);
    if (nodes_[to].arrival < known) push(to, nodes_[to].arrival, none);
}

// Comes straight from another node, if that is earlier and can be.
void SafeIntervalSearcher::Search::relax(std::uint32_t by, std::uint32_t to) {
    const Node& from = nodes_[by];
    Node& node = nodes_[to];
    if (from.cell == node.cell) return;
    const double duration = distance(from.cell, node.cell) / options_->speed;
    const double latest = std::min({from.to, node.to - duration, node.arrival - duration});
    const double earliest = std::max(from.arrival, node.from - duration);
    if (earliest > latest || earliest + duration >= node.arrival || !sees(from.cell, node.cell)) return;
    const double opened = std::max(earliest, opened_for(from.cell, node.cell, duration));
    const double departure = safe_departure(move_between(from.cell, node.cell, options_->speed), opened, latest);
    const double arrival = std::max(departure + duration, node.from);
    if (departure > latest || arrival >= node.arrival) return;
    node.arrival = arrival;
    node.departure = departure;
    node.parent = by;
}

// The first departure, from `earliest` on, with which the move meets nobody; later than `latest` if there is none by
// then. Hops over the unsafe departures of whom it meets, so that only those around at the time are looked at.
double SafeIntervalSearcher::Search::safe_departure(const Move& move, double earliest, double latest) const {
    double departure = earliest;
    for (double next = earliest; departure <= latest && departure < for_ever; departure = next) {
        const Leg leg{move.start, move.velocity, departure, departure + move.duration};
        traffic_->near(leg, radius_, [&](const Traffic::Index::Piece& piece) {
            const double reach = traffic_->reach(piece, radius_);
            if (safe_interval::overlap(leg, piece.leg, reach).empty()) return true;
            next = std::max(next, safe_interval::unsafe_departures(move, piece.leg, reach).to);
            return next <= latest;
        });
        if (next <= departure) break;
    }
    return departure;
}

double SafeIntervalSearcher::Search::opened_for(Cell from, Cell to, double duration) const {
    return safe_interval::opened_for(map_->map(), from, to, duration, *options_);
}

std::vector<Waypoint> SafeIntervalSearcher::Search::path_to(std::uint32_t node) const {
    std::vector<Waypoint> path;
    // To the node before, seen from the goal. Who has nowhere to go stands there until it is ready.
    double departure = nodes_[node].parent == none ? nodes_[node].arrival : 0;
    for (std::uint32_t at = node; at != none; at = nodes_[at].parent) {
        const Node& reached = nodes_[at];
        const double arrival = reached.parent == none ? 0 : reached.arrival;
        const Waypoint here{double(reached.cell.x), double(reached.cell.y), arrival};
        if (departure > arrival) path.push_back({here.x, here.y, departure});
        path.push_back(here);
        departure = reached.departure;
    }
    std::ranges::reverse(path);
    return path;
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
