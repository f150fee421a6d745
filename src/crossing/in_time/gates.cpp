#include "crossing/in_time/gates.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace waybreaker::crossing {
namespace {

constexpr double spacing = 2;  // half cells between neighbours

}  // namespace

double GateGroup::first_estimate(double to_go) const {
    const double arrival = terms_.arrival + gap(terms_.from, *border_);
    return std::max(terms_.open, arrival) - terms_.early + to_go;
}

double GateGroup::cost_of(const Point& point) const {
    return std::max(terms_.open, point.arrival) - terms_.early;
}

// Where the agent comes long after the obstacle has opened it does not wait: the taut paths through it are no gates.
// The first points at which it is open are: with points a cell apart, the best place to bend may lie just behind the
// last at which it is not. For the lower bound a gate stands for all places around it.
bool GateGroup::is_gate(double arrival) const {
    return arrival - terms_.early < terms_.open + (terms_.early > 0 ? 0 : spacing);
}

void GateGroup::open_up(const std::function<bool(Vertex)>& stands) {
    for (const Vertex v : border_->points) {
        const double arrival = terms_.arrival + length(v - terms_.from);
        const bool free = stands(v);
        points_.push_back({.arrival = arrival, .cost_to_go = 0, .stands = free, .done = !is_gate(arrival) || !free});
    }
}

void GateGroup::queue_all(Vertex goal) {
    queue_.clear();
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
        if (!points_[i].done) queue_.push_back({estimate_of(i, goal), i});
    }
    std::ranges::make_heap(queue_, std::greater{});
    queued_ = true;
}

double GateGroup::estimate_of(std::uint32_t point, Vertex goal) const {
    return cost_of(points_[point]) + std::max(points_[point].cost_to_go, length(goal - border_->points[point]));
}

bool GateGroup::find_best(Vertex goal, const std::function<bool(Vertex)>& stands,
                          const std::function<double(Vertex, double)>& cost_to_go) {
    if (points_.empty()) open_up(stands);
    if (!queued_) queue_all(goal);
    while (!queue_.empty()) {
        const auto [least, at] = queue_.front();
        Point& point = points_[at];
        const double estimate = point.done ? least : estimate_of(at, goal);
        if (point.done || estimate > least) {
            std::ranges::pop_heap(queue_, std::greater{});
            queue_.pop_back();
            if (point.done) continue;
            queue_.push_back({estimate, at});
            std::ranges::push_heap(queue_, std::greater{});
            continue;
        }
        if (estimate == infinity) return false;
        best_ = at;
        best_gate_ = {border_->points[at], cost_of(point), estimate};
        if (point.cost_to_go_known) return true;
        point.cost_to_go_known = true;
        point.cost_to_go = cost_to_go(best_gate_.at, best_gate_.cost);
        learn_cost_to_go(at, goal);
    }
    return false;
}

// Triangle inequality: from a neighbour the goal is nearer by at most the step to it. Where no path is short enough,
// that says nothing of neighbours: a path that comes to them earlier may go on for longer.
void GateGroup::learn_cost_to_go(std::uint32_t point, Vertex goal) {
    if (points_[point].cost_to_go == infinity) return;
    std::vector<std::uint32_t> queue{point};
    for (std::size_t i = 0; i < queue.size(); ++i) {
        const double least = points_[queue[i]].cost_to_go - spacing;
        for (const std::uint32_t next : border_->neighbours[queue[i]]) {
            if (next == no_neighbour ||
                least <= std::max(points_[next].cost_to_go, length(goal - border_->points[next])))
                continue;
            points_[next].cost_to_go = least;
            queue.push_back(next);
        }
    }
}

void GateGroup::forget_cost_to_go() {
    for (Point& point : points_) {
        point.cost_to_go = 0;
        point.cost_to_go_known = false;
    }
    queued_ = false;
}

double GateGroup::past(Vertex v, const std::function<bool(Vertex)>& stands,
                       const std::function<double(Vertex)>& arrival_at) {
    if (points_.empty()) open_up(stands);
    while (true) {
        double earliest = infinity;
        std::uint32_t entry = 0;
        for (std::uint32_t i = 0; i < points_.size(); ++i) {
            if (!points_[i].stands) continue;
            const double there = cost_of(points_[i]) + length(v - border_->points[i]);
            if (there >= earliest) continue;
            earliest = there;
            entry = i;
        }
        if (earliest == infinity || points_[entry].proven) return earliest;
        prove(entry, arrival_at(border_->points[entry]));
    }
}

void GateGroup::prove(std::uint32_t point, double arrival) {
    points_[point].proven = true;
    learn_arrival(point, arrival);
    prove_around(point, arrival);
}

// An agent that gets from there to a neighbour before the obstacle opens needs no shorter path to it.
void GateGroup::prove_around(std::uint32_t point, double arrival) {
    std::vector<std::pair<std::uint32_t, double>> queue{{point, arrival}};
    for (std::size_t i = 0; i < queue.size(); ++i) {
        const double there = queue[i].second + spacing;
        if (there > terms_.open) return;  // as all that follow
        for (const std::uint32_t next : border_->neighbours[queue[i].first]) {
            if (next == no_neighbour || points_[next].proven) continue;
            points_[next].proven = true;
            queue.emplace_back(next, there);
        }
    }
}

// Triangle inequality: a path to a neighbour is shorter by at most the step from it.
void GateGroup::learn_arrival(std::uint32_t point, double arrival) {
    // Breadth first: all steps are equally long, so that each point is improved once.
    std::vector<std::pair<std::uint32_t, double>> queue{{point, arrival}};
    for (std::size_t i = 0; i < queue.size(); ++i) {
        const auto [at, least] = queue[i];
        if (at != point && (points_[at].proven || points_[at].arrival >= least)) continue;
        points_[at].arrival = std::max(points_[at].arrival, least);
        if (!is_gate(points_[at].arrival)) points_[at].done = true;
        if (least - spacing <= terms_.arrival) continue;
        for (const std::uint32_t next : border_->neighbours[at]) {
            if (next != no_neighbour && points_[next].arrival < least - spacing)
                queue.emplace_back(next, least - spacing);
        }
    }
}

}  // namespace waybreaker::crossing
