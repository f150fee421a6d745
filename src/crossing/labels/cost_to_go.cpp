#include "crossing/labels/cost_to_go.hpp"

#include <algorithm>

#include "crossing/tuning.hpp"

namespace waybreaker::crossing {

void CostToGo::start_query(const CrossingQuery& query, Passes passes, Interrupt& interrupt) {
    start_ = query.start;
    goal_ = query.goal;
    longest_ = query.longest() * (1 + rounding);
    interrupt_ = &interrupt;
    CrossingOptions all_open;
    all_open.body = query.options->body;
    all_open.relaxed = query.options->relaxed;
    fan_.start_query(*query.regions, goal_, all_open, query.pinched, nullptr, interrupt);
    if (passes == Passes::destructible) fan_.ray().pass_destructible();
    known_with_.clear();
    expanded_ = 0;
    open(query.removed);
    // If nothing that stays is in the way from the start, the straight line is taken to say as much everywhere.
    straight_ =
        passes == Passes::destructible && detour_from(start_, infinity) <= length(goal_ - start_) * (1 + rounding);
}

void CostToGo::use_straight_line(Vertex goal) {
    goal_ = goal;
    straight_ = true;
}

void CostToGo::open(std::span<const ObstacleId> obstacles) {
    open_obstacles_.assign(obstacles.begin(), obstacles.end());
    known_ = &known_with_[open_obstacles_];
    learn(goal_, {0, true});
}

double CostToGo::detour_from(Vertex v, double at_most) {
    if (const Known bound = known(v); bound.exact) return bound.least;
    const double matters = longest_ - length(v - start_);
    range_ = std::min(matters, at_most * (1 + rounding));
    double least = search(v, SIZE_MAX);
    if (least == infinity && range_ < matters) {  // rounded off
        range_ = matters;
        least = search(v, SIZE_MAX);
    }
    if (interrupt_->cause() != Interrupt::Cause::none) return length(goal_ - v);
    least *= 1 - rounding;
    if (least < infinity) {
        // Triangle inequality: a label so far from v is at most so much nearer to the goal, as in Adaptive A* (Koenig,
        // Likhachev 2005).
        for (const Label& label : labels_) learn(label.at, {least - label.cost});
    }
    learn(v, {least, true});
    return least;
}

double CostToGo::within(Vertex v, double range) {
    const Known before = known(v);
    if (before.exact || before.least > range) return before.least;
    range_ = range * (1 + rounding);
    const double found = search(v, tuning::most_expanded_for_cost_to_go);
    if (interrupt_->cause() != Interrupt::Cause::none) return before.least;
    Known bound{found * (1 - rounding), true};
    if (found == infinity) bound = {open_.empty() ? range_ : labels_[open_.front()].estimate * (1 - rounding)};
    for (const Label& label : labels_) learn(label.at, {bound.least - label.cost});
    learn(v, bound);
    return bound.least;
}

CostToGo::Known CostToGo::known(Vertex v) const {
    const auto found = known_->find(key(v));
    return found == known_->end() ? Known{length(goal_ - v)} : found->second;
}

void CostToGo::learn(Vertex v, Known bound) {
    Known& known = known_->try_emplace(key(v), Known{length(goal_ - v)}).first->second;
    if (!known.exact && (bound.exact || bound.least > known.least)) known = bound;
}

// A* that ends where the cost to go is known, or once it has taken so many labels.
double CostToGo::search(Vertex v, std::size_t expansions) {
    labels_.assign(1, {.at = v, .estimate = known(v).least});
    open_.assign(1, 0);
    reached_.clear();
    while (!open_.empty() && expansions-- > 0) {
        const std::uint32_t index = open_.front();
        std::ranges::pop_heap(open_, [this](auto a, auto b) { return later(a, b); });
        open_.pop_back();
        const Label label = labels_[index];
        if (label.exact) {
            for (std::uint32_t at = label.parent; at != 0; at = labels_[at].parent) {
                learn(labels_[at].at, {label.estimate - labels_[at].cost, true});
            }
            return label.estimate;
        }
        if (index == 0 || label.cost <= reached_[key(label.at)]) expand(index);
        if (interrupt_->cause() != Interrupt::Cause::none) break;
    }
    return infinity;
}

void CostToGo::expand(std::uint32_t index) {
    ++expanded_;
    const Label label = labels_[index];
    Viewpoint from{.at = label.at, .arriving = std::nullopt, .ahead = std::nullopt, .open = open_obstacles_};
    from.range = range_ - label.cost;
    if (index != 0) from.arriving = label.at - labels_[label.parent].at;
    for (const Reached& reached : fan_.look(from, false)) push(index, reached.at);
}

void CostToGo::push(std::uint32_t parent, Vertex at) {
    const double cost = labels_[parent].cost + length(at - labels_[parent].at);
    const Known to_go = known(at);
    const double estimate = cost + to_go.least;
    if (estimate > range_) return;
    const auto [before, first] = reached_.try_emplace(key(at), cost);
    if (!first && before->second <= cost) return;
    before->second = cost;
    labels_.push_back({at, cost, estimate, parent, to_go.exact});
    open_.push_back(std::uint32_t(labels_.size() - 1));
    std::ranges::push_heap(open_, [this](auto a, auto b) { return later(a, b); });
}

}  // namespace waybreaker::crossing
