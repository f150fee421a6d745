#include "crossing/search.hpp"

#include <algorithm>
#include <vector>

#include "crossing/trace.hpp"
#include "crossing/tuning.hpp"

namespace waybreaker {

using namespace crossing;

namespace {

constexpr double rounding = 1e-9;  // relative

std::vector<ObstacleId> sorted(std::span<const ObstacleId> ids) {
    std::vector<ObstacleId> set(ids.begin(), ids.end());
    std::ranges::sort(set);
    set.erase(std::unique(set.begin(), set.end()), set.end());
    return set;
}

// Whether a cell of the map is free once those obstacles, sorted, are removed.
bool stands(const Regions& regions, Cell c, std::span<const ObstacleId> removed) {
    if (!regions.map().grid().contains(c)) return false;
    const RegionId region = region_at(regions.map(), c);
    return !region || regions.within(region, removed);
}

SearchStatus status_of(Interrupt::Cause cause) {
    switch (cause) {
        case Interrupt::Cause::stop:
            return SearchStatus::stopped;
        case Interrupt::Cause::limit:
            return SearchStatus::limit_reached;
        case Interrupt::Cause::none:
            break;
    }
    return SearchStatus::not_found;
}

}  // namespace

std::unique_ptr<CrossingSearcher::Search> CrossingSearcher::Search::another() const {
    auto search = std::make_unique<Search>();
    search->regions_of_ = regions_of_;
    return search;
}

CrossingResult CrossingSearcher::Search::run(const Map& map, Cell start, Cell goal, const CrossingOptions& options,
                                             const Opener& opener, const Accept* accept) {
    progress_.interrupt = Interrupt(options.limits.seconds, options.limits.stop);
    const std::shared_ptr<const Regions> regions = regions_for(map, options);
    if (!regions->complete()) {
        CrossingResult unknown;
        unknown.status = status_of(progress_.interrupt.cause());
        unknown.lower_bound = distance(start, goal);
        return unknown;
    }
    const std::vector<ObstacleId> removed = sorted(options.removed);
    if (stands(*regions, start, removed) && stands(*regions, goal, removed)) {
        return run_between(map, centre(start), centre(goal), options, opener, accept);
    }
    CrossingResult none;
    none.lower_bound = infinity;
    return none;
}

// Grown once for all queries that move the same body on the same map, whatever its obstacles weigh.
std::shared_ptr<const Regions> CrossingSearcher::Search::regions_for(const Map& map, const CrossingOptions& options) {
    std::shared_ptr<const Regions>& known = regions_of_[std::size_t(reach_of(options) - 1)];
    if (known && known->serve(map, options)) return known;
    if (known && known->fit(map, options)) return known = std::make_shared<const Regions>(*known, map);
    auto regions = std::make_shared<const Regions>(map, options, progress_.interrupt);
    // Another query may have the time to complete what was interrupted.
    if (progress_.interrupt.cause() == Interrupt::Cause::none) known = regions;
    return regions;
}

CrossingResult CrossingSearcher::Search::run_between(const Map& map, Vertex start, Vertex goal,
                                                     const CrossingOptions& options, const Opener& opener,
                                                     const Accept* accept) {
    accept_ = accept;
    result_ = {};
    result_.lower_bound = infinity;
    start_query(map, start, goal, options, opener);
    search_ellipses();
    result_.expanded = progress_.expanded;
    result_.generated = progress_.expanded + labels_.open_count();
    return result_;
}

// The searcher of the path to a gate shares the maps grown for wide bodies.
CrossingResult CrossingSearcher::Search::find_path_to_gate(Vertex from, Vertex gate, const CrossingOptions& options) {
    if (!search_to_gate_) search_to_gate_ = std::make_unique<Search>();
    search_to_gate_->to_gate_ = true;
    search_to_gate_->regions_of_ = regions_of_;
    return search_to_gate_->run_between(*query_.map, from, gate, options, {}, nullptr);
}

void CrossingSearcher::Search::start_query(const Map& map, Vertex start, Vertex goal, const CrossingOptions& options,
                                           const Opener& opener) {
    progress_ = {.interrupt = Interrupt(options.limits.seconds, options.limits.stop)};
    query_.map = &map;
    query_.options = &options;
    query_.opener = &opener;
    query_.regions = regions_for(map, options);
    query_.start = start;
    query_.goal = goal;
    query_.removed = sorted(options.removed);
    query_.enumerates = accept_ != nullptr;
    query_.waits = bool(options.opened_after);
    const bool alone = !query_.waits || opener.opens_each_alone;  // another set may open later
    query_.by_count = !query_.enumerates && alone && !opener.done_after;
    // Gates may be where two cells touch at a corner.
    query_.pinched = query_.regions->pinched() && !query_.waits && !to_gate_;
    // The square turns and waits at lattice points only; the point is a lower bound for paths that wait anywhere.
    query_.early = reach_of(options) == 1 ? 1 : 0;
    Convex* const convex = query_.by_count && !query_.in_time() && options.prices.empty() ? &convex_ : nullptr;
    convex_.start_query(*query_.regions, reach_of(options));
    fan_.start_query(*query_.regions, goal, options, query_.pinched, convex, progress_.interrupt);
    if (query_.waits) {
        waits_.start_query();
        further_.start_query();
    }
    if (options.crossings == 0) {
        cost_to_go_.use_straight_line(goal);
    } else {
        cost_to_go_.start_query(query_, CostToGo::Passes::destructible, progress_.interrupt);
    }
}

// In ellipses that grow until one holds the path: what lies outside costs nothing, and the last one costs about as much
// as all before it.
void CrossingSearcher::Search::search_ellipses() {
    const CrossingOptions& options = *query_.options;
    const double longest = 2 * options.length_limit;
    sets_.clear();
    Label start;
    start.at = query_.start;
    start.set = sets_.find_or_add(query_.removed);
    const double straight = std::min(estimate(start), longest);
    const bool guessed = 2 * options.expected > straight;
    const double least = guessed ? 2 * options.expected : straight;
    proven_ = straight;
    reported_ = -1;
    // With nothing to cross detours are long; a weighted search hardly looks at what is far from its path.
    const bool wide = options.crossings == 0 || options.weight > 1;
    double slack = guessed ? tuning::first_slack_with_guess
                   : wide  ? tuning::first_slack_of_detours
                           : tuning::first_slack;
    for (;; slack *= slack < tuning::small_slack ? tuning::growth_of_small_slack : tuning::growth_of_slack) {
        const bool last = slack > tuning::largest_slack || longest < least * (1 + tuning::last_stretch * slack);
        progress_.limit = last ? longest : least * (1 + slack);
        const Outcome outcome = search_ellipse();
        if (outcome == Outcome::found) return;
        if (outcome != Outcome::exhausted) {
            result_.status = outcome == Outcome::stopped ? SearchStatus::stopped : SearchStatus::limit_reached;
            if (labels_.open_count() > 0) {
                const double least_left = labels_[labels_.first()].estimate / options.weight;
                proven_ = std::max(proven_, std::min(progress_.limit, least_left));
            }
            result_.lower_bound = proven_ / 2;
            if (!query_.enumerates) result_.best = path_to(labels_.first_at(query_.goal));
            return;
        }
        proven_ = progress_.limit;
        // A larger ellipse may know of waits that a smaller one does not: paths that it finds below are new.
        if (!query_.waits) reported_ = progress_.limit;
        if (progress_.limit >= longest) {
            result_.lower_bound = progress_.limit / 2;
            return;
        }
    }
}

void CrossingSearcher::Search::start_ellipse() {
    labels_.clear();
    sets_.clear();
    waits_.start_ellipse();
    if (query_.waits) further_.start_ellipse();
    Label start;
    start.at = query_.start;
    start.set = sets_.find_or_add(query_.removed);
    start.estimate = estimate(start);
    add(start);
}

CrossingSearcher::Search::Outcome CrossingSearcher::Search::search_ellipse() {
    start_ellipse();
    while (labels_.open_count() > 0) {
        if (const auto outcome = interrupted()) return *outcome;
        const std::uint32_t index = labels_.take_first();
        if (labels_[index].dominated) continue;
        if (query_.waits && !settle(index)) continue;
        ++progress_.expanded;
        // The cost of a wait is a lower bound, and may come out below what was proven before.
        if (query_.waits) proven_ = std::max(proven_, labels_[index].estimate);
        if (labels_[index].group != 0) {
            if (const std::optional<Label> gate = waits_.take_gate(index)) add(*gate);
        } else if (labels_[index].at == query_.goal) {
            if (reach_goal(index)) return Outcome::found;
        } else {
            expand(index);
            // Then it is not all expanded.
            if (progress_.interrupt.cause() != Interrupt::Cause::none) labels_.insert(index);
        }
    }
    return Outcome::exhausted;
}

std::optional<CrossingSearcher::Search::Outcome> CrossingSearcher::Search::interrupted() {
    if (progress_.expanded >= query_.options->limits.expansions) return Outcome::limit_reached;
    if (!progress_.interrupt.due()) return std::nullopt;
    return progress_.interrupt.cause() == Interrupt::Cause::stop ? Outcome::stopped : Outcome::limit_reached;
}

// Raises the estimate of a label in time, once, when its turn comes. False if it costs too much by that, or goes back
// into the open list.
bool CrossingSearcher::Search::settle(std::uint32_t index) {
    Label& label = labels_[index];
    if (label.settled || label.group != 0 || label.at == query_.goal) return true;
    label.settled = true;
    const double least = further_.estimate(label);
    if (least <= label.estimate) return true;
    label.estimate = least;
    if (least <= progress_.limit) labels_.insert(index);
    return false;
}

// Takes the path to the goal, unless a smaller ellipse held it. True if no other is asked for.
bool CrossingSearcher::Search::reach_goal(std::uint32_t index) {
    if (labels_[index].estimate <= reported_) return false;
    const CrossingPath path = path_to(index);
    if (result_.status != SearchStatus::found) result_.best = path;
    result_.status = SearchStatus::found;
    result_.lower_bound = std::max(path.cost / query_.options->weight, proven_ / 2);
    return !query_.enumerates || !(*accept_)(path);
}

void CrossingSearcher::Search::expand(std::uint32_t index) {
    const Label label = labels_[index];
    const Viewpoint from = viewpoint(label);
    const bool alternatives = query_.enumerates || query_.in_time() || !query_.options->prices.empty();
    const std::span<const Reached> all = fan_.look(from, alternatives);
    if (progress_.interrupt.cause() != Interrupt::Cause::none) return;
    for (const Reached& reached : all) push(index, reached);
    if (query_.waits && from.crossings > 0) waits_.add_gates(index);
}

Viewpoint CrossingSearcher::Search::viewpoint(const Label& label) {
    Viewpoint from{.at = label.at,
                   .arriving = std::nullopt,
                   .ahead = labels_.ahead(label),
                   .open = sets_[label.set],
                   .crossings = int(query_.capacity() - sets_[label.set].size()),
                   .range = progress_.limit - label.cost - sets_.paid(label.set) - sets_.added(label.set)};
    // Where it comes from does not matter after a wait.
    if (label.parent != no_label && label.gate == 0) from.arriving = label.at - labels_[label.parent].at;
    if (query_.waits && further_.least_with_more(label.set, progress_.limit) > progress_.limit) from.crossings = 0;
    if (fan_.ray().prices()) {
        // A path can pay no more than what its cost to go leaves of the limit.
        from.weight = from.range - cost_to_go_.from(label.at) + rounding * progress_.limit;
    } else {
        from.weight = query_.options->budget;
        for (const ObstacleId obstacle : query_.removed) from.weight += fan_.ray().weight(obstacle);
        for (const ObstacleId obstacle : from.open) from.weight -= fan_.ray().weight(obstacle);
    }
    return from;
}

void CrossingSearcher::Search::push(std::uint32_t parent, const Reached& reached) {
    const Label& from = labels_[parent];
    if (query_.waits && !waits_.in_time(from, reached)) return;
    const double step = length(reached.at - from.at);
    Label label;
    label.at = reached.at;
    label.cost = from.cost + step;
    if (label.cost + length(query_.goal - label.at) > progress_.limit) return;
    if (label.cost + cost_to_go_.from(label.at, step + cost_to_go_.from(from.at)) > progress_.limit) return;
    label.parent = parent;
    label.since = labels_.last_gate(parent);
    label.set = from.set;
    if (!reached.crossed.empty()) {
        const auto before = sets_[label.set];
        std::vector<ObstacleId> set(before.begin(), before.end());
        set.insert(set.end(), reached.crossed.begin(), reached.crossed.end());
        std::sort(set.begin(), set.end());
        label.set = sets_.find_or_add(set);
    }
    label.estimate = estimate(label);
    if (label.estimate > progress_.limit) return;
    label.estimate += (query_.options->weight - 1) * cost_to_go_.from(label.at);
    if (const auto ahead = fan_.ahead(reached)) labels_.keep_ahead(label, *ahead);
    add(label);
}

CrossingPath CrossingSearcher::Search::path_to(std::uint32_t label) {
    return label == no_label ? CrossingPath{} : trace(label, query_, labels_, sets_, waits_.groups(), fan_.ray());
}

}  // namespace waybreaker
