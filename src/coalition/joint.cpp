#include "coalition/joint.hpp"

#include <algorithm>
#include <functional>
#include <tuple>

#include "coalition/tuning.hpp"
#include "model/objective.hpp"

namespace waybreaker::coalition {
namespace {

// The most promising node comes out of the heap first; of these the one with most vehicles.
bool later(const auto& a, const auto& b) {
    if (a.bound != b.bound) return a.bound > b.bound;
    if (a.depth != b.depth) return a.depth < b.depth;
    if (a.opened != b.opened) return a.opened > b.opened;
    return std::tie(a.cost, a.sum, a.last) > std::tie(b.cost, b.sum, b.last);
}

}  // namespace

Joint::Joint(const Problem& problem, const Columns& columns, const Relaxation::Proof& proof, EarliestOpenings& openings,
             double reached)
    : problem_(problem), columns_(columns), proof_(proof), openings_(openings), reached_(reached) {
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        least_last_ = std::max(least_last_, columns.of(i).least);
        const Columns::Search& search = proof.searches[i];
        if (proof.weights[i] > 0 && columns.of(i).columns.size() > 1) {
            order_.push_back(i);
            bound_of_unknown_ = std::min(bound_of_unknown_, proof.bound + search.complete_below - search.least);
        } else {
            others.push_back(i);
        }
    }
    // Those first whose choice matters most.
    const auto gain = [&](std::size_t i) { return columns.of(i).columns.front().arrival - columns.of(i).least; };
    std::ranges::stable_sort(order_, std::greater<>(), gain);
    Node root;
    for (const std::size_t i : others) {
        root.cost += proof.searches[i].least;
        root.sum += weighted(problem.weight(i), columns.of(i).least);
    }
    for (const std::size_t i : order_) add_candidates(i);
    least_cost_after_.assign(order_.size() + 1, 0);
    least_sum_after_.assign(order_.size() + 1, 0);
    for (std::size_t k = order_.size(); k-- > 0;) {
        least_cost_after_[k] = least_cost_after_[k + 1] + proof.searches[order_[k]].least;
        least_sum_after_[k] =
            least_sum_after_[k + 1] + weighted(problem.weight(order_[k]), columns.of(order_[k]).least);
    }
    if (const auto bound = bound_of(root)) {
        root.bound = *bound;
        open_.push_back(root);
    }
}

void Joint::add_candidates(std::size_t vehicle) {
    std::vector<Candidate>& all = candidates_.emplace_back();
    const Pool& pool = columns_.of(vehicle);
    for (const Column& column : pool.columns) {
        Candidate& candidate = all.emplace_back();
        candidate.column = &column;
        candidate.cost = proof_.weights[vehicle] * column.arrival;
        for (const std::uint32_t at : column.opened) {
            candidate.opened.push_back(pool.obstacles[at]);
            candidate.cost += proof_.prices[vehicle][at];
        }
        std::ranges::sort(candidate.opened);
        if (proof_.bound + candidate.cost - proof_.searches[vehicle].least >= reached_) all.pop_back();
    }
    std::ranges::stable_sort(all, {}, &Candidate::cost);
}

// None if it is `reached` or more.
std::optional<double> Joint::bound_of(const Node& node) const {
    const Returns& home = openings_.of(united(problem_.forced(), node.opened)).home;
    const double last_on_ground = std::max(node.last, least_last_);
    double bound = problem_.objective(node.sum + least_sum_after_[node.depth] + home.sum,
                                      std::max(last_on_ground, home.last), last_on_ground);
    if (bound < reached_ && node.depth < order_.size()) bound = std::max(bound, bound_by_prices(node, home.sum));
    return bound < reached_ ? std::optional(bound) : std::nullopt;
}

double Joint::bound_by_prices(const Node& node, double flights) const {
    double detours = 0;
    if (problem_.sums()) {
        detours = flights;
        for (const Agent* agent : problem_.aircraft()) detours -= agent->weight * Problem::straight_flight(*agent);
        for (const ObstacleId id : united(problem_.forced(), node.opened)) detours -= problem_.weighted_breach_time(id);
    }
    const std::size_t more = std::size_t(problem_.spare_removals()) - node.opened.size();
    double paid = proof_.offers.best(more, detours, node.opened);
    for (const ObstacleId id : node.opened) paid += proof_.sums[id.value];
    return proof_.fixed + node.cost + least_cost_after_[node.depth] - paid;
}

void Joint::expand(const Node& node) {
    for (const Candidate& candidate : candidates_[node.depth]) {
        Node next{0,
                  node.depth + 1,
                  node.cost + candidate.cost,
                  node.sum + weighted(problem_.weight(order_[node.depth]), candidate.column->arrival),
                  std::max(node.last, candidate.column->arrival),
                  united(node.opened, candidate.opened)};
        if (!problem_.allows(next.opened)) continue;
        const std::optional<double> bound = bound_of(next);
        if (!bound) continue;
        next.bound = std::max(*bound, node.bound);
        open_.push_back(std::move(next));
        std::ranges::push_heap(open_, later<Node, Node>);
    }
}

std::optional<Set> Joint::next() {
    while (!open_.empty() && expanded_ < tuning::most_nodes && !problem_.interrupts().due()) {
        const Node node = open_.front();
        std::ranges::pop_heap(open_, later<Node, Node>);
        open_.pop_back();
        if (node.depth < order_.size()) {
            ++expanded_;
            expand(node);
        } else if (std::ranges::find(enumerated_, node.opened) == enumerated_.end()) {
            if (enumerated_.empty()) least_ = node.bound;
            enumerated_.push_back(node.opened);
            return node.opened;
        }
    }
    return std::nullopt;
}

double Joint::bound() const {
    return std::min({least_, bound_of_unknown_, open_.empty() ? reached_ : open_.front().bound});
}

}  // namespace waybreaker::coalition
