#include "crossing/gates.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace waybreaker::crossing {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double spacing = 2;  // of neighbours, half cells

}  // namespace

double GateGroup::first_estimate(double rest) const {
    const double arrival = terms_.arrival + gap(terms_.from, *border_);
    return std::max(terms_.open, arrival) - terms_.early + rest;
}

double GateGroup::cost_of(const Point& point) const {
    return std::max(terms_.open, point.arrival) - terms_.early;
}

// Where the agent comes long after the obstacle has opened it does not wait: the taut paths through it are no gates.
// The first points at which it is open are: with points a cell apart, the best place to bend may lie just behind the
// last at which it is not. For the lower limit a gate stands for all places around it.
bool GateGroup::is_gate(double arrival) const {
    return arrival - terms_.early < terms_.open + (terms_.early > 0 ? 0 : spacing);
}

void GateGroup::open_up(const std::function<bool(Vertex)>& stands) {
    for (const Vertex v : border_->points) {
        const double arrival = terms_.arrival + length(v - terms_.from);
        const bool free = stands(v);
        left_.push_back(std::uint32_t(points_.size()));
        points_.push_back({.arrival = arrival, .rest = 0, .stands = free, .done = !is_gate(arrival) || !free});
    }
}

bool GateGroup::find_best(Vertex goal, const std::function<bool(Vertex)>& stands,
                          const std::function<double(Vertex)>& rest) {
    if (points_.empty()) open_up(stands);
    while (true) {
        best_gate_.estimate = infinity;
        std::erase_if(left_, [&](std::uint32_t i) { return points_[i].done; });
        for (const std::uint32_t i : left_) {
            const double cost = cost_of(points_[i]);
            const double estimate = cost + std::max(points_[i].rest, length(goal - border_->points[i]));
            if (estimate >= best_gate_.estimate) continue;
            best_ = i;
            best_gate_ = {border_->points[i], cost, estimate};
        }
        if (best_gate_.estimate == infinity) return false;
        if (points_[best_].rest_known) return true;
        points_[best_].rest_known = true;
        points_[best_].rest = rest(best_gate_.at);
    }
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
    learn(point, arrival);
    prove_around(point, arrival);
}

// Whoever gets from there to a neighbour before the obstacle opens needs no shorter way to it.
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

// From its neighbours no way there can be shorter than theirs.
void GateGroup::learn(std::uint32_t point, double arrival) {
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
