#include "crossing/in_time/waits.hpp"

#include <algorithm>

namespace waybreaker::crossing {

void Waits::start_query() {
    borders_.start_query(*query_.regions, reach_of(*query_.options));
    path_lengths_.start_query(*query_.map, *query_.options);
    cost_to_go_from_.clear();
}

void Waits::start_ellipse() {
    group_numbers_.clear();
    groups_.resize(1);
}

bool Waits::in_time(const Label& from, const Reached& reached) {
    if (reached.crossed.empty()) return true;
    const double step = length(reached.at - from.at);
    std::vector<ObstacleId> set(sets_[from.set].begin(), sets_[from.set].end());
    Ray& ray = fan_.ray();
    ray.cast(from.at, reached.at, int(query_.capacity()), infinity);
    std::vector<Hit> hits;
    for (const Hit& hit : ray.hits()) {
        if (ray.opens(hit.region, reached.crossed)) hits.push_back(hit);
    }
    std::ranges::sort(hits, comes_first);
    for (const Hit& hit : hits) {
        add_members(hit.region, set);
        if (sets_.opened_after(set) > from.cost + hit.at * step + query_.early) return false;
    }
    return true;
}

// Adds the members of a region to a set; returns those that are new. Both are sorted.
std::vector<ObstacleId> Waits::add_members(RegionId region, std::vector<ObstacleId>& set) const {
    std::vector<ObstacleId> added;
    query_.regions->for_each_member(region, [&](ObstacleId obstacle) {
        const auto at = std::ranges::lower_bound(set, obstacle);
        if (at != set.end() && *at == obstacle) return;
        set.insert(at, obstacle);
        added.push_back(obstacle);
    });
    return added;
}

// An obstacle that a ray has entered may open later than the agent gets there, or to another place on its border.
void Waits::add_gates(std::uint32_t label) {
    const double cost = labels_[label].cost;
    const Vertex from = labels_[label].at;
    GateGroup::Terms terms;
    std::vector<ObstacleId> set;
    bool too_late = false;  // for all that the ray enters next
    for (const Entered& entered : fan_.entered()) {
        if (entered.first) {
            const auto crossed = sets_[labels_[label].set];
            set.assign(crossed.begin(), crossed.end());
            terms.passed.clear();
            too_late = false;
        }
        if (too_late) continue;
        terms.region = entered.region;
        terms.since = query_.options->relaxed ? labels_.last_gate(label) : first_in_time(label, set);
        terms.opened = add_members(entered.region, set);
        terms.open = sets_.opened_after(set);
        std::uint32_t group = 0;
        if (terms.open > cost + gap(from, borders_.of(entered.region))) group = add_group(terms, set);
        if (!entered.surely) {
            std::erase_if(set, [&](ObstacleId o) { return std::ranges::binary_search(terms.opened, o); });
        } else if (terms.open > cost + entered.at + query_.early) {
            // Only a lower bound may go on through what is not open yet.
            too_late = group == 0 || !query_.options->relaxed;
            terms.passed.push_back(group);
        }
    }
}

// Adds one group for all paths to a region from the last gate. Its number; 0 if it costs too much.
std::uint32_t Waits::add_group(GateGroup::Terms terms, const std::vector<ObstacleId>& set) {
    std::vector<std::uint32_t> key;
    for (const ObstacleId obstacle : set) key.push_back(obstacle.value);
    key.insert(key.end(), {terms.region.value, terms.since, 0});
    key.insert(key.end(), terms.passed.begin(), terms.passed.end());
    const auto [known, added] = group_numbers_.try_emplace(std::move(key), 0);
    if (!added) return known->second;
    terms.from = labels_[terms.since].at;
    terms.arrival = labels_[terms.since].cost;
    terms.early = query_.early;
    const Border& border = borders_.of(terms.region);
    const double first = GateGroup(terms, border).first_estimate(cost_to_go_from(border, terms.region));
    if (first > progress_.limit) return 0;
    terms.set = sets_.find_or_add(set);
    Label label;
    label.group = std::uint32_t(groups_.size());
    label.set = terms.set;
    label.estimate = sets_.cost(first, terms.set);
    if (label.estimate > progress_.limit) return 0;
    known->second = label.group;
    groups_.emplace_back(std::move(terms), border);
    labels_.add_open(label);
    return label.group;
}

// Lower bound of the cost to go from anywhere on a border.
double Waits::cost_to_go_from(const Border& border, RegionId region) {
    if (cost_to_go_.is_straight_line()) return gap(query_.goal, border);
    const auto [known, added] = cost_to_go_from_.try_emplace(region.value, 0);
    if (!added) return known->second;
    std::vector<std::pair<double, Vertex>> points;
    for (const Vertex v : border.points) points.emplace_back(length(query_.goal - v), v);
    std::ranges::stable_sort(points, {}, &std::pair<double, Vertex>::first);
    double least = infinity;
    for (const auto& [straight, v] : points) {
        if (straight >= least) break;
        least = std::min(least, cost_to_go_.from(v));
    }
    return known->second = least;
}

std::optional<Label> Waits::take_gate(std::uint32_t index) {
    const std::uint32_t set = labels_[index].set;
    GateGroup& group = groups_[labels_[index].group];
    const auto stands = [&](Vertex v) { return borders_.stands(v, sets_[set]); };
    // First as if nothing else were crossed; then what a path costs at least that crosses more.
    const double more = further_.least_with_more(set, labels_[index].estimate);
    if (more <= labels_[index].estimate) labels_[index].settled = true;
    const auto cost_to_go = [&](Vertex v, double cost) {
        return labels_[index].settled ? cost_to_go_.from(v)
                                      : further_.cost_to_go_without_more(v, cost, set, std::min(more, progress_.limit));
    };
    while (group.find_best(query_.goal, stands, cost_to_go)) {
        double estimate = sets_.cost(group.best().estimate, set);
        if (!labels_[index].settled && estimate > more) {
            labels_[index].settled = true;
            group.forget_cost_to_go();
            continue;
        }
        if (labels_[index].settled) estimate = std::max(estimate, more);
        if (estimate > progress_.limit) return std::nullopt;
        if (estimate > labels_[index].estimate) {
            labels_[index].estimate = estimate;
            labels_.insert(index);
            return std::nullopt;
        }
        if (group.proven()) {
            group.take();
            labels_.insert(index);
            return gate_label(index);
        }
        group.prove(arrival_at_gate(group.terms(), group.best().at));
        if (progress_.interrupt.due_now()) {  // the gates that are left still count for the bound
            labels_.insert(index);
            return std::nullopt;
        }
    }
    return std::nullopt;
}

Label Waits::gate_label(std::uint32_t group_label) const {
    const std::uint32_t number = labels_[group_label].group;
    const GateGroup& group = groups_[number];
    Label label;
    label.at = group.best().at;
    label.parent = group.terms().since;
    label.since = group.terms().since;
    label.gate = number;
    label.set = labels_[group_label].set;
    label.cost = group.best().cost;
    label.estimate =
        std::max(sets_.cost(label.cost + cost_to_go_.from(label.at), label.set), labels_[group_label].estimate);
    return label;
}

// Lower bound of the arrival at a gate: neither the shortest path through what is open by then gets there earlier, nor
// one past any of the obstacles that open late.
double Waits::arrival_at_gate(const GateGroup::Terms& terms, Vertex gate) {
    double arrival = terms.arrival + length_to_gate(terms, gate);
    for (const std::uint32_t passed : terms.passed) {
        GateGroup& group = groups_[passed];
        const auto stands = [&](Vertex v) { return borders_.stands(v, sets_[group.terms().set]); };
        const auto arrival_at = [&](Vertex v) { return group.terms().arrival + length_to_gate(group.terms(), v); };
        arrival = std::max(arrival, group.past(gate, stands, arrival_at));
    }
    return arrival;
}

double Waits::length_to_gate(const GateGroup::Terms& terms, Vertex gate) {
    std::vector<ObstacleId> open(sets_[terms.set].begin(), sets_[terms.set].end());
    std::erase_if(open, [&](ObstacleId o) { return std::ranges::binary_search(terms.opened, o); });
    return path_lengths_.length(terms.from, gate, open, [&](const CrossingOptions& options) {
        ++progress_.expanded;
        return find_path_(terms.from, gate, options);
    });
}

// The first place on the path to a label from which every path through the set is in time; the label itself if none is.
std::uint32_t Waits::first_in_time(std::uint32_t label, std::span<const ObstacleId> sorted) const {
    const double open = sets_.opened_after(sorted);
    const std::uint32_t since = labels_.last_gate(label);
    while (label != since && labels_[labels_[label].parent].cost >= open) label = labels_[label].parent;
    return label;
}

}  // namespace waybreaker::crossing
