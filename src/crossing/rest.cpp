#include "crossing/rest.hpp"

#include <algorithm>
#include <limits>

namespace waybreaker::crossing {

void Rest::start_query(const Regions& regions, Vertex start, Vertex goal, const CrossingOptions& options, bool pinched,
                       Interrupt& interrupt) {
    start_ = start;
    goal_ = goal;
    longest_ = 2 * options.length_limit * (1 + rounding);
    removed_ = options.removed;
    interrupt_ = &interrupt;
    CrossingOptions all_open;
    all_open.body = options.body;
    all_open.relaxed = options.relaxed;
    fan_.start_query(regions, goal, all_open, pinched, nullptr, interrupt);
    fan_.ray().pass_destructible();
    known_.clear();
    known_[key(goal)] = 0;
}

double Rest::from(Vertex v) {
    if (const auto rest = known(v)) return *rest;
    const double rest = search(v) * (1 - rounding);
    if (interrupt_->cause() != Interrupt::Cause::none) return length(goal_ - v);
    known_[key(v)] = rest;
    return rest;
}

std::optional<double> Rest::known(Vertex v) const {
    const auto found = known_.find(key(v));
    return found == known_.end() ? std::nullopt : std::optional(found->second);
}

// A* that ends where the rest is known.
double Rest::search(Vertex v) {
    driven_ = length(v - start_);
    labels_.assign(1, {.at = v, .estimate = length(goal_ - v)});
    open_.assign(1, 0);
    reached_.clear();
    while (!open_.empty()) {
        const std::uint32_t index = open_.front();
        std::ranges::pop_heap(open_, [this](auto a, auto b) { return later(a, b); });
        open_.pop_back();
        const Label label = labels_[index];
        if (known(label.at)) {
            for (std::uint32_t at = label.parent; at != 0; at = labels_[at].parent) {
                known_[key(labels_[at].at)] = label.estimate - labels_[at].cost;
            }
            return label.estimate;
        }
        if (index == 0 || label.cost <= reached_[key(label.at)]) expand(index);
        if (interrupt_->cause() != Interrupt::Cause::none) break;
    }
    return std::numeric_limits<double>::infinity();
}

void Rest::expand(std::uint32_t index) {
    const Label label = labels_[index];
    Viewpoint from{.at = label.at, .arriving = std::nullopt, .ahead = std::nullopt, .open = removed_};
    from.range = longest_ - driven_ - label.cost;
    if (index != 0) from.arriving = label.at - labels_[label.parent].at;
    for (const Reached& reached : fan_.look(from, false)) push(index, reached.at);
}

void Rest::push(std::uint32_t parent, Vertex at) {
    const double cost = labels_[parent].cost + length(at - labels_[parent].at);
    const double estimate = cost + known(at).value_or(length(goal_ - at));
    if (driven_ + estimate > longest_) return;
    const auto [before, first] = reached_.try_emplace(key(at), cost);
    if (!first && before->second <= cost) return;
    before->second = cost;
    labels_.push_back({at, cost, estimate, parent});
    open_.push_back(std::uint32_t(labels_.size() - 1));
    std::ranges::push_heap(open_, [this](auto a, auto b) { return later(a, b); });
}

}  // namespace waybreaker::crossing
