#include "safe_interval/search.hpp"

#include <algorithm>
#include <cmath>

#include "safe_interval/driven.hpp"

namespace waybreaker {

using safe_interval::for_ever;
using safe_interval::Interval;
using safe_interval::Leg;
using safe_interval::Move;
using safe_interval::Vector;

namespace {

Vector vector_of(Cell c) {
    return {double(c.x), double(c.y)};
}

Move move_between(Cell from, Cell to, double speed) {
    const double duration = distance(from, to) / speed;
    return {vector_of(from), (1 / duration) * (vector_of(to) - vector_of(from)), duration};
}

}  // namespace

SearchStatus SafeIntervalSearcher::Search::search() {
    nodes_.clear();
    open_.clear();
    if (!distances_->complete()) return SearchStatus::limit_reached;
    open_steps_ = &memory_.open_steps(options_->body);
    nodes_of_.resize(std::max(nodes_of_.size(), distances_->size()));
    ++query_;
    reached_ = none;
    const Nodes ends = nodes_at(goal_);
    if (ends.count == 0) return SearchStatus::no_path;
    const Node& last = nodes_[ends.first + ends.count - 1];
    if (options_->stays && last.to < for_ever) return SearchStatus::no_path;
    goal_free_from_ = options_->stays ? last.from : 0;
    const Nodes starts = nodes_at(start_);
    if (starts.count == 0 || nodes_[starts.first].from > options_->since ||
        nodes_[starts.first].to < options_->ready_at) {
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

// When the agent may be there if it is to arrive in time: it comes no earlier, and goes no later, than by straight
// lines. Whether it can stand at the start from the first moment, and at the goal for ever, is asked as well.
Interval SafeIntervalSearcher::Search::useful_times(Cell cell) const {
    constexpr double rounding = 1e-9;
    const double earliest = options_->ready_at + distance(start_, cell) / options_->speed;
    const double latest = arrive_before_ - distance(cell, goal_) / options_->speed;
    return {cell == start_ ? options_->since : earliest * (1 - rounding), cell == goal_ ? for_ever : latest};
}

// One for each safe interval: what is left of the useful time when all that comes too near is taken away.
void SafeIntervalSearcher::Search::add_nodes(Cell cell) {
    const Interval useful = useful_times(cell);
    if (useful.empty()) return;
    unsafe_.clear();
    const Leg here{vector_of(cell), {}, useful.from, useful.to};
    traffic_->near(here, radius_, [&](const safe_interval::TrafficIndex::Piece& piece) {
        const Interval near = safe_interval::overlap(piece.leg, here, traffic_->reach(piece, radius_));
        if (!near.empty()) unsafe_.push_back(near);
        return true;
    });
    std::ranges::sort(unsafe_, {}, &Interval::from);  // of those that begin at one time only the latest end matters
    double from = useful.from;
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
    if (from < useful.to) add(useful.to);
}

bool SafeIntervalSearcher::Search::is_end(std::uint32_t node) const {
    return nodes_[node].cell == goal_ && (!options_->stays || nodes_[node].to == for_ever);
}

// `by` none: the node is reached at that time. Else it may be, from `by` or its parent, and is looked at when its turn
// comes: most turns never do.
void SafeIntervalSearcher::Search::push(std::uint32_t at, double arrival, std::uint32_t by) {
    const double ahead = double(distances_->to_goal(nodes_[at].cell)) / options_->speed;
    const double cost = std::max(arrival + ahead, goal_free_from_);
    if (!(cost < arrive_before_) || cost == for_ever) return;
    open_.push_back({cost, ahead, arrival, at, by});
    std::push_heap(open_.begin(), open_.end());
}

// To all neighbours, and to the next bend of the way on if nobody were there.
void SafeIntervalSearcher::Search::expand(std::uint32_t at) {
    if (!sight_) return;  // no query has begun
    nodes_[at].expanded = true;
    const Cell here = nodes_[at].cell;
    offer(at, distances_->next(here));
    open_steps_->from(here, *sight_, [&](Cell beside) {
        if (distances_->to_goal(beside) != safe_interval::Distances::unknown) offer(at, beside);
    });
}

// Opens the nodes of a cell that might be reached earlier than by what is known: if nobody is in the way.
void SafeIntervalSearcher::Search::offer(std::uint32_t by, Cell to) {
    const Nodes nodes = nodes_at(to);
    const Node from = nodes_[by];
    const double duration = distance(from.cell, to) / options_->speed;
    const Interval beside{from.arrival + duration, from.to + duration};
    Interval straight;
    if (from.parent != none) {
        const Node& parent = nodes_[from.parent];
        const double direct = distance(parent.cell, to) / options_->speed;
        straight = {parent.arrival + direct, parent.to + direct};
    }
    for (std::uint32_t at = nodes.first; at < nodes.first + nodes.count; ++at) {
        const Node& node = nodes_[at];
        const bool tried = from.parent == none || node.tried == from.parent;
        const double earliest = tried ? beside.from : std::min(beside.from, straight.from);
        const double latest = tried ? beside.to : std::max(beside.to, straight.to);
        const double arrival = std::max(earliest, node.from);
        if (node.expanded || arrival >= node.arrival || arrival > node.to || latest < node.from) continue;
        push(at, arrival, by);
    }
}

// As Theta*: straight from where `by` was come from, if that can be; else from `by`.
void SafeIntervalSearcher::Search::come_from(std::uint32_t by, std::uint32_t to) {
    const double known = nodes_[to].arrival;
    if (const std::uint32_t parent = nodes_[by].parent; parent != none && parent != nodes_[to].tried) {
        relax(parent, to);
        nodes_[to].tried = parent;
    }
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
    const double ready = from.arrival + safe_interval::rubble_before(*map_, from.cell, node.cell, *options_);
    const double opened = std::max({earliest, ready, opened_for(from.cell, node.cell, duration)});
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
        traffic_->near(leg, radius_, [&](const safe_interval::TrafficIndex::Piece& piece) {
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
        const double arrival = reached.parent == none ? options_->since : reached.arrival;
        const Waypoint here{double(reached.cell.x), double(reached.cell.y), arrival};
        if (departure > arrival) path.push_back({here.x, here.y, departure});
        path.push_back(here);
        departure = reached.departure;
    }
    std::ranges::reverse(path);
    return path;
}

}  // namespace waybreaker
