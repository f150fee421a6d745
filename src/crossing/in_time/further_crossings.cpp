#include "crossing/in_time/further_crossings.hpp"

#include <algorithm>
#include <utility>

#include "crossing/geometry/border.hpp"
#include "crossing/tuning.hpp"

namespace waybreaker::crossing {

void FurtherCrossings::start_ellipse() {
    openable_.clear();
    least_with_more_.clear();
    const Regions& regions = *query_.regions;
    for (std::uint32_t id = 1; id + 1 < regions.obstacle_limit(); ++id) {
        const ObstacleId obstacle{id};
        if (ray_.stays(obstacle)) continue;
        const Box box = regions.bounds(obstacle);
        const double to_go = gap(query_.goal, box);
        if (gap(query_.start, box) + to_go <= progress_.limit) openable_.push_back({obstacle, to_go});
    }
}

double FurtherCrossings::least_with_more(std::uint32_t set, double than) {
    if (least_with_more_.size() <= set) least_with_more_.resize(set + 1, -1);
    double& known = least_with_more_[set];
    if (known >= 0) return known;
    known = infinity;
    if (sets_[set].size() == query_.capacity()) return known;
    std::vector<ObstacleId> more;
    for (Openable& next : openable_) {
        const auto members = sets_[set];
        const auto at = std::ranges::lower_bound(members, next.obstacle);
        if (at != members.end() && *at == next.obstacle) continue;
        more.assign(members.begin(), at);
        more.push_back(next.obstacle);
        more.insert(more.end(), at, members.end());
        known = std::min(known, least_with(more, next.to_go) + sets_.paid(set));
        if (known > than) continue;
        std::swap(next, openable_.front());  // it often opens in time for the next set, too
        return known = 0;
    }
    return known;
}

// Lower bound for a path that crosses them and is so far from the goal when the last one opens.
double FurtherCrossings::least_with(std::span<const ObstacleId> sorted, double to_go) const {
    return sets_.unpaid_cost(sets_.opened_after(sorted) - query_.early + to_go, sorted);
}

double FurtherCrossings::cost_to_go_without_more(Vertex v, double cost, std::uint32_t set, double most) {
    const std::uint64_t labels = progress_.expanded + tuning::labels_in_advance;
    if (through_open_.expanded() > tuning::cost_to_go_for_each_label * labels) return cost_to_go_.from(v);
    through_open_.open(sets_[set]);
    return through_open_.within(v, most - cost - sets_.paid(set) - sets_.added(set));
}

double FurtherCrossings::estimate(const Label& label) {
    const double more = least_with_more(label.set, label.estimate);
    if (more <= label.estimate) return label.estimate;
    const double to_go = cost_to_go_without_more(label.at, label.cost, label.set, std::min(more, progress_.limit));
    return std::max(label.estimate, std::min(more, sets_.cost(label.cost + to_go, label.set)));
}

}  // namespace waybreaker::crossing
