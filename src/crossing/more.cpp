// What else opens: a path in time crosses more than it has, and that opens late, or the rest of its way leads past all
// that stands. Both say more than the straight line: docs/exact.md.
#include <algorithm>
#include <limits>

#include "crossing/search.hpp"

namespace waybreaker {

using namespace crossing;

// What can be crossed on a path that matters.
void CrossingSearcher::Search::list_openable() {
    openable_.clear();
    least_with_more_.clear();
    for (std::uint32_t id = 1; id + 1 < regions_->obstacle_limit(); ++id) {
        const ObstacleId obstacle{id};
        if (fan_.ray().stays(obstacle)) continue;
        const Box box = regions_->bounds(obstacle);
        const double rest = gap(goal_, box);
        if (gap(start_, box) + rest <= limit_) openable_.push_back({obstacle, rest});
    }
}

// No path that crosses more than the set costs less: whatever it crosses next opens with all of the set. 0 if one may
// cost no more than `than`: then it does not matter how much less.
double CrossingSearcher::Search::least_with_more(std::uint32_t set, double than) {
    if (least_with_more_.size() <= set) least_with_more_.resize(set + 1, -1);
    double& known = least_with_more_[set];
    if (known >= 0) return known;
    known = std::numeric_limits<double>::infinity();
    if (int(sets_[set].size()) == capacity_) return known;
    std::vector<ObstacleId> more;
    for (Openable& next : openable_) {
        const auto members = sets_[set];
        const auto at = std::ranges::lower_bound(members, next.obstacle);
        if (at != members.end() && *at == next.obstacle) continue;
        more.assign(members.begin(), at);
        more.push_back(next.obstacle);
        more.insert(more.end(), at, members.end());
        known = std::min(known, least_with(more, next.rest) + paid(set));
        if (known > than) continue;
        std::swap(next, openable_.front());  // it often opens in time for the next set, too
        return known = 0;
    }
    return known;
}

// What a path costs at least that crosses them, and is so far from the goal when the last one opens.
double CrossingSearcher::Search::least_with(std::span<const ObstacleId> sorted, double rest) const {
    const double ground = opened_after(sorted) - early_ + rest;
    if (!options_->done_after) return ground;
    const double done = 2 * options_->done_after(ids_of(sorted));
    return options_->adds_both ? ground + done : std::max(ground, done);
}

// How far it is to the goal at least for who crosses nothing else, if the path then costs no more than that.
double CrossingSearcher::Search::rest_without_more(Vertex v, double cost, std::uint32_t set, double most) {
    // Where sets are many, what is learnt of one serves few labels.
    constexpr std::uint64_t most_for_each_expansion = 8;
    if (without_more_.expanded() > most_for_each_expansion * (result_.expanded + 100)) return rest(v);
    without_more_.open(sets_[set]);
    const double flight = options_->adds_both ? done_after_[set] : 0;
    return without_more_.within(v, most - cost - paid(set) - flight);
}

// Once for each label, when its turn comes: it crosses more, and that opens late, or it drives past all that stands.
// False if it costs too much by that, or is put back.
bool CrossingSearcher::Search::settle(std::uint32_t index) {
    Label& label = labels_[index];
    if (label.settled || label.group != 0 || label.at == goal_) return true;
    label.settled = true;
    const double more = least_with_more(label.set, label.estimate);
    if (more <= label.estimate) return true;
    const double rest = rest_without_more(label.at, label.cost, label.set, std::min(more, limit_));
    const double least = std::min(more, with_flight(label.cost + rest, label.set));
    if (least <= label.estimate) return true;
    label.estimate = least;
    if (least <= limit_) insert(index);
    return false;
}

}  // namespace waybreaker
