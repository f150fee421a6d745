// Paths in time: obstacles open late, and whoever opens them has to get home.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "crossing/search.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {

using namespace crossing;

// When all of them are open, in half cells.
double CrossingSearcher::Search::opened_after(std::span<const ObstacleId> sorted) const {
    const std::vector<ObstacleId> ids = ids_of(sorted);
    if (ids.empty()) return 0;
    const double cells = options_->opened_after(ids);
    if (std::isnan(cells)) throw InputError("opened_after must say a number");
    return 2 * cells;
}

std::uint32_t CrossingSearcher::Search::add_set(std::span<const ObstacleId> sorted) {
    const std::uint32_t known = sets_.size();
    const std::uint32_t set = sets_.find_or_add(sorted);
    if (set < known) return set;
    if (options_->done_after) {
        const double cells = options_->done_after(ids_of(sorted));
        if (!(cells >= 0)) throw InputError("done_after must say a number, at least 0");
        done_after_.push_back(2 * cells);
    }
    if (!options_->prices.empty()) {
        double paid = 0;
        for (const ObstacleId id : ids_of(sorted)) paid += 2 * options_->prices[id.value];
        paid_.push_back(paid);
    }
    return set;
}

double CrossingSearcher::Search::estimate(const Label& label) {
    return with_flight(label.cost + rest(label.at), label.set);
}

double CrossingSearcher::Search::with_flight(double ground, std::uint32_t set) const {
    if (!options_->done_after) return ground + paid(set);
    const double done = done_after_[set];
    return (options_->adds_both ? ground + done : std::max(ground, done)) + paid(set);
}

// The cost of the way from a label to what it has reached; none if it would have to wait on the way.
std::optional<double> CrossingSearcher::Search::cost_of(std::uint32_t parent, const Reached& reached) {
    const Label& from = labels_[parent];
    const double step = length(reached.at - from.at);
    if (!waits_ || reached.crossed.empty()) return from.cost + step;
    std::vector<ObstacleId> set(sets_[from.set].begin(), sets_[from.set].end());
    Ray& ray = fan_.ray();
    ray.cast(from.at, reached.at, capacity_, std::numeric_limits<double>::infinity());
    std::vector<Hit> hits;
    for (const Hit& hit : ray.hits()) {
        if (ray.opens(hit.region, reached.crossed)) hits.push_back(hit);
    }
    std::ranges::sort(hits, {}, &Hit::at);
    for (const Hit& hit : hits) {
        add_members(hit.region, set);
        if (opened_after(set) > from.cost + hit.at * step + early_) return std::nullopt;
    }
    return from.cost + step;
}

// The members of the region that were not in the set before; both sorted.
std::vector<ObstacleId> CrossingSearcher::Search::add_members(RegionId region, std::vector<ObstacleId>& set) const {
    std::vector<ObstacleId> added;
    regions_->for_each_member(region, [&](ObstacleId obstacle) {
        const auto at = std::ranges::lower_bound(set, obstacle);
        if (at != set.end() && *at == obstacle) return;
        set.insert(at, obstacle);
        added.push_back(obstacle);
    });
    return added;
}

// What a ray has entered may open later than the agent gets there, or to another place on its border.
void CrossingSearcher::Search::push_gates(std::uint32_t parent) {
    const double cost = labels_[parent].cost;
    const Vertex from = labels_[parent].at;
    GateGroup::Terms terms;
    std::vector<ObstacleId> set;
    bool too_late = false;  // for all that the ray enters next
    for (const Entered& entered : fan_.entered()) {
        if (entered.first) {
            const auto crossed = sets_[labels_[parent].set];
            set.assign(crossed.begin(), crossed.end());
            terms.passed.clear();
            too_late = false;
        }
        if (too_late) continue;
        terms.region = entered.region;
        terms.since = options_->relaxed ? since_of(parent) : since_all_open(parent, set);
        terms.opened = add_members(entered.region, set);
        terms.open = opened_after(set);
        std::uint32_t group = 0;
        if (terms.open > cost + gap(from, borders_.of(entered.region))) group = push_group(terms, set);
        if (!entered.surely) {
            std::erase_if(set, [&](ObstacleId o) { return std::ranges::binary_search(terms.opened, o); });
        } else if (terms.open > cost + entered.at + early_) {
            // Only a lower limit may go on through what is not open yet.
            too_late = group == 0 || !options_->relaxed;
            terms.passed.push_back(group);
        }
    }
}

// Once for all ways to a region from the last gate. Its number; 0 if it costs too much.
std::uint32_t CrossingSearcher::Search::push_group(GateGroup::Terms terms, const std::vector<ObstacleId>& set) {
    std::vector<std::uint32_t> key;
    for (const ObstacleId obstacle : set) key.push_back(obstacle.value);
    key.insert(key.end(), {terms.region.value, terms.since, 0});
    key.insert(key.end(), terms.passed.begin(), terms.passed.end());
    const auto [known, added] = group_numbers_.try_emplace(std::move(key), 0);
    if (!added) return known->second;
    terms.from = labels_[terms.since].at;
    terms.arrival = labels_[terms.since].cost;
    terms.early = early_;
    const Border& border = borders_.of(terms.region);
    const double first = GateGroup(terms, border).first_estimate(rest_of(border, terms.region));
    if (first > limit_) return 0;
    terms.set = add_set(set);
    Label label;
    label.group = std::uint32_t(groups_.size());
    label.set = terms.set;
    label.estimate = with_flight(first, terms.set);
    if (label.estimate > limit_) return 0;
    known->second = label.group;
    groups_.emplace_back(std::move(terms), border);
    labels_.push_back(label);
    insert(std::uint32_t(labels_.size() - 1));
    return label.group;
}

// How far it is to the goal at least, from anywhere on a border.
double CrossingSearcher::Search::rest_of(const Border& border, RegionId region) {
    if (!detours_) return gap(goal_, border);
    const auto [known, added] = rest_of_.try_emplace(region.value, 0);
    if (!added) return known->second;
    std::vector<std::pair<double, Vertex>> points;
    for (const Vertex v : border.points) points.emplace_back(length(goal_ - v), v);
    std::ranges::sort(points, {}, &std::pair<double, Vertex>::first);
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [straight, v] : points) {
        if (straight >= least) break;
        least = std::min(least, rest(v));
    }
    return known->second = least;
}

// Takes the next gate out of a group, or puts the group back where it belongs by now.
void CrossingSearcher::Search::expand_group(std::uint32_t index) {
    const std::uint32_t set = labels_[index].set;
    GateGroup& group = groups_[labels_[index].group];
    const auto stands = [&](Vertex v) { return borders_.stands(v, sets_[set]); };
    // First as if nothing else were crossed; then what a path costs at least that crosses more.
    const double more = least_with_more(set, labels_[index].estimate);
    if (more <= labels_[index].estimate) labels_[index].settled = true;
    const auto rest_from = [&](Vertex v, double cost) {
        return labels_[index].settled ? rest(v) : rest_without_more(v, cost, set, std::min(more, limit_));
    };
    while (group.find_best(goal_, stands, rest_from)) {
        double estimate = with_flight(group.best().estimate, set);
        if (!labels_[index].settled && estimate > more) {
            labels_[index].settled = true;
            group.forget_rests();
            continue;
        }
        if (labels_[index].settled) estimate = std::max(estimate, more);
        if (estimate > limit_) return;
        if (estimate > labels_[index].estimate) {
            labels_[index].estimate = estimate;
            insert(index);
            return;
        }
        if (group.proven()) {
            group.take();
            insert(index);
            push_gate(index);
            return;
        }
        group.prove(arrival_at_gate(group.terms(), group.best().at));
        if (interrupt_.due_now()) {  // the gates that are left still count for the bound
            insert(index);
            return;
        }
    }
}

void CrossingSearcher::Search::push_gate(std::uint32_t of) {
    const std::uint32_t number = labels_[of].group;
    const GateGroup& group = groups_[number];
    Label label;
    label.at = group.best().at;
    label.parent = group.terms().since;
    label.since = group.terms().since;
    label.gate = number;
    label.set = labels_[of].set;
    label.cost = group.best().cost;
    label.estimate = std::max(estimate(label), labels_[of].estimate);
    add(label);
}

// No way gets there earlier: neither the shortest through what is open by then, nor past any of those that open late.
double CrossingSearcher::Search::arrival_at_gate(const GateGroup::Terms& terms, Vertex gate) {
    double arrival = terms.arrival + way_to_gate(terms, gate);
    for (const std::uint32_t passed : terms.passed) {
        GateGroup& group = groups_[passed];
        const auto stands = [&](Vertex v) { return borders_.stands(v, sets_[group.terms().set]); };
        const auto arrival_at = [&](Vertex v) { return group.terms().arrival + way_to_gate(group.terms(), v); };
        arrival = std::max(arrival, group.past(gate, stands, arrival_at));
    }
    return arrival;
}

// How long the shortest way to a gate is through what is open by then.
double CrossingSearcher::Search::way_to_gate(const GateGroup::Terms& terms, Vertex gate) {
    std::vector<ObstacleId> open(sets_[terms.set].begin(), sets_[terms.set].end());
    std::erase_if(open, [&](ObstacleId o) { return std::ranges::binary_search(terms.opened, o); });
    return ways_.length(terms.from, gate, open, [&](const CrossingOptions& options) {
        ++result_.expanded;
        if (!way_to_gate_) way_to_gate_ = another();
        way_to_gate_->to_gate_ = true;
        way_to_gate_->regions_of_ = regions_of_;
        return way_to_gate_->run_between(*map_, terms.from, gate, options, nullptr);
    });
}

// The first of the places on the way to a label from which every way through the set is in time; the label itself if
// none is.
std::uint32_t CrossingSearcher::Search::since_all_open(std::uint32_t label, std::span<const ObstacleId> sorted) const {
    const double open = opened_after(sorted);
    const std::uint32_t since = since_of(label);
    while (label != since && labels_[labels_[label].parent].cost >= open) label = labels_[label].parent;
    return label;
}

std::uint32_t CrossingSearcher::Search::since_of(std::uint32_t label) const {
    return labels_[label].gate != 0 ? label : labels_[label].since;
}

}  // namespace waybreaker
