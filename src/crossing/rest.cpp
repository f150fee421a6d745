#include "crossing/rest.hpp"

#include <algorithm>

namespace waybreaker::crossing {

void Rest::start_query(const Regions& regions, Vertex start, Vertex goal, double longest,
                       const CrossingOptions& options, Passes passes, bool pinched, Interrupt& interrupt) {
    start_ = start;
    goal_ = goal;
    longest_ = longest * (1 + rounding);
    interrupt_ = &interrupt;
    CrossingOptions all_open;
    all_open.body = options.body;
    all_open.relaxed = options.relaxed;
    fan_.start_query(regions, goal, all_open, pinched, nullptr, interrupt);
    if (passes == Passes::destructible) fan_.ray().pass_destructible();
    known_with_.clear();
    expanded_ = 0;
    open(options.removed);
}

void Rest::open(std::span<const ObstacleId> obstacles) {
    open_obstacles_.assign(obstacles.begin(), obstacles.end());
    known_ = &known_with_[open_obstacles_];
    note(goal_, {0, true});
}

double Rest::from(Vertex v, double at_most) {
    if (const Known rest = known(v); rest.exact) return rest.least;
    const double matters = longest_ - length(v - start_);
    range_ = std::min(matters, at_most * (1 + rounding));
    double rest = search(v, SIZE_MAX);
    if (rest == infinity && range_ < matters) {  // rounded off
        range_ = matters;
        rest = search(v, SIZE_MAX);
    }
    if (interrupt_->cause() != Interrupt::Cause::none) return length(goal_ - v);
    rest *= 1 - rounding;
    if (rest < infinity) {
        // Who is so far from v is at most so much nearer to the goal, as in Adaptive A* (Koenig, Likhachev 2005).
        for (const Label& label : labels_) note(label.at, {rest - label.cost});
    }
    note(v, {rest, true});
    return rest;
}

double Rest::within(Vertex v, double range) {
    const Known before = known(v);
    if (before.exact || before.least > range) return before.least;
    range_ = range * (1 + rounding);
    const double found = search(v, most_expanded);
    if (interrupt_->cause() != Interrupt::Cause::none) return before.least;
    Known rest{found * (1 - rounding), true};
    if (found == infinity) rest = {open_.empty() ? range_ : labels_[open_.front()].estimate * (1 - rounding)};
    for (const Label& label : labels_) note(label.at, {rest.least - label.cost});
    note(v, rest);
    return rest.least;
}

Rest::Known Rest::known(Vertex v) const {
    const auto found = known_->find(key(v));
    return found == known_->end() ? Known{length(goal_ - v)} : found->second;
}

void Rest::note(Vertex v, Known rest) {
    Known& known = known_->try_emplace(key(v), Known{length(goal_ - v)}).first->second;
    if (!known.exact && (rest.exact || rest.least > known.least)) known = rest;
}

// A* that ends where the rest is known, or once it has taken so many labels.
double Rest::search(Vertex v, std::size_t patience) {
    labels_.assign(1, {.at = v, .estimate = known(v).least});
    open_.assign(1, 0);
    reached_.clear();
    while (!open_.empty() && patience-- > 0) {
        const std::uint32_t index = open_.front();
        std::ranges::pop_heap(open_, [this](auto a, auto b) { return later(a, b); });
        open_.pop_back();
        const Label label = labels_[index];
        if (label.exact) {
            for (std::uint32_t at = label.parent; at != 0; at = labels_[at].parent) {
                note(labels_[at].at, {label.estimate - labels_[at].cost, true});
            }
            return label.estimate;
        }
        if (index == 0 || label.cost <= reached_[key(label.at)]) expand(index);
        if (interrupt_->cause() != Interrupt::Cause::none) break;
    }
    return infinity;
}

void Rest::expand(std::uint32_t index) {
    ++expanded_;
    const Label label = labels_[index];
    Viewpoint from{.at = label.at, .arriving = std::nullopt, .ahead = std::nullopt, .open = open_obstacles_};
    from.range = range_ - label.cost;
    if (index != 0) from.arriving = label.at - labels_[label.parent].at;
    for (const Reached& reached : fan_.look(from, false)) push(index, reached.at);
}

void Rest::push(std::uint32_t parent, Vertex at) {
    const double cost = labels_[parent].cost + length(at - labels_[parent].at);
    const Known rest = known(at);
    const double estimate = cost + rest.least;
    if (estimate > range_) return;
    const auto [before, first] = reached_.try_emplace(key(at), cost);
    if (!first && before->second <= cost) return;
    before->second = cost;
    labels_.push_back({at, cost, estimate, parent, rest.exact});
    open_.push_back(std::uint32_t(labels_.size() - 1));
    std::ranges::push_heap(open_, [this](auto a, auto b) { return later(a, b); });
}

}  // namespace waybreaker::crossing
