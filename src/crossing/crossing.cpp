// A* over taut paths. A label is a vertex, the set of obstacles crossed on the way there, and what the way costs. It is
// expanded by rays and outlines alone, so that only what stands in the way costs anything: docs/exact.md. What
// obstacles that open late add is in waits.cpp.
#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>

#include "crossing/dominance.hpp"
#include "crossing/search.hpp"

namespace waybreaker {

using namespace crossing;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-9;  // relative

std::vector<ObstacleId> sorted(std::span<const ObstacleId> ids) {
    std::vector<ObstacleId> set(ids.begin(), ids.end());
    std::ranges::sort(set);
    set.erase(std::unique(set.begin(), set.end()), set.end());
    return set;
}

}  // namespace

bool CrossingSearcher::Search::earlier(std::uint32_t a, std::uint32_t b) const {
    const Label& la = labels_[a];
    const Label& lb = labels_[b];
    if (la.estimate != lb.estimate) return la.estimate < lb.estimate;
    if (la.cost != lb.cost) return la.cost > lb.cost;
    return a < b;
}

void CrossingSearcher::Search::push(std::uint32_t parent, const Reached& reached) {
    const std::span<const ObstacleId> crossed = reached.crossed;
    const std::optional<double> cost = cost_of(parent, reached);
    if (!cost) return;
    Label label;
    label.at = reached.at;
    label.cost = *cost;
    if (label.cost + length(goal_ - label.at) > limit_) return;
    const Vertex from = labels_[parent].at;
    if (label.cost + rest(label.at, length(label.at - from) + rest(from)) > limit_) return;
    label.parent = parent;
    label.since = since_of(parent);
    label.set = labels_[parent].set;
    if (!crossed.empty()) {
        const auto before = sets_[label.set];
        std::vector<ObstacleId> set(before.begin(), before.end());
        set.insert(set.end(), crossed.begin(), crossed.end());
        std::sort(set.begin(), set.end());
        label.set = add_set(set);
    }
    label.estimate = estimate(label);
    if (label.estimate > limit_) return;
    label.estimate += (options_->weight - 1) * rest(label.at);
    if (const auto ahead = fan_.ahead(reached)) {
        label.fronts_begin = std::uint32_t(fronts_.size());
        fronts_.insert(fronts_.end(), ahead->begin(), ahead->end());
        label.fronts_end = std::uint32_t(fronts_.size());
    }
    add(label);
}

// Unless another one at its vertex dominates it.
void CrossingSearcher::Search::add(Label label) {
    // What costs the same may still be told of.
    const std::size_t full = accept_ == nullptr ? std::size_t(capacity_) : SIZE_MAX;
    const Dominance dominates{*regions_, convex_, sets_,     groups_, options_->budget < infinity,
                              goal_,     limit_,  by_count_, full,    options_->prices,
                              paid_};
    const std::uint32_t place = places_.find_or_add(label.at);
    for (std::uint32_t other = places_[place].labels; other != no_label; other = labels_[other].next) {
        if (!labels_[other].dominated && dominates(labels_[other], label)) return;
    }
    for (std::uint32_t other = places_[place].labels; other != no_label; other = labels_[other].next) {
        if (!labels_[other].dominated && dominates(label, labels_[other])) labels_[other].dominated = true;
    }
    label.next = places_[place].labels;
    places_[place].labels = std::uint32_t(labels_.size());
    labels_.push_back(label);
    insert(std::uint32_t(labels_.size() - 1));
}

void CrossingSearcher::Search::insert(std::uint32_t label) {
    open_.push_back(label);
    std::push_heap(open_.begin(), open_.end(), [this](auto a, auto b) { return earlier(b, a); });
}

void CrossingSearcher::Search::expand(std::uint32_t index) {
    const Label label = labels_[index];
    Viewpoint from{.at = label.at,
                   .arriving = std::nullopt,
                   .ahead = std::nullopt,
                   .open = sets_[label.set],
                   .crossings = capacity_ - int(sets_[label.set].size()),
                   .weight = weight_capacity_,
                   .range = limit_ - label.cost - paid(label.set) - (options_->adds_both ? done_after_[label.set] : 0)};
    // Where it comes from does not matter after a wait.
    if (label.parent != no_label && label.gate == 0) from.arriving = label.at - labels_[label.parent].at;
    if (waits_ && least_with_more(label.set, limit_) > limit_) from.crossings = 0;
    if (fan_.ray().prices()) {
        // Nobody can pay more than what is left beside the shortest rest of the way.
        from.weight = from.range - rest(label.at) + rounding * limit_;
    } else {
        for (const ObstacleId obstacle : from.open) from.weight -= fan_.ray().weight(obstacle);
    }
    if (label.fronts_begin != 0) {
        from.ahead = std::span(fronts_.data() + label.fronts_begin, fronts_.data() + label.fronts_end);
    }
    const bool alternatives = accept_ != nullptr || in_time() || !options_->prices.empty();
    const std::span<const Reached> all = fan_.look(from, alternatives);
    if (interrupt_.cause() != Interrupt::Cause::none) return;
    for (const Reached& reached : all) push(index, reached);
    if (waits_ && from.crossings > 0) push_gates(index);
}

std::optional<CrossingSearcher::Search::Outcome> CrossingSearcher::Search::interrupted() {
    if (result_.expanded >= options_->limits.expansions) return Outcome::limit_reached;
    if (!interrupt_.due()) return std::nullopt;
    return interrupt_.cause() == Interrupt::Cause::stop ? Outcome::stopped : Outcome::limit_reached;
}

CrossingSearcher::Search::Outcome CrossingSearcher::Search::search_ellipse() {
    labels_.clear();
    open_.clear();
    sets_.clear();
    group_numbers_.clear();
    groups_.resize(1);
    done_after_.clear();
    paid_.clear();
    places_.clear();
    fronts_.resize(1);
    capacity_ = options_->crossings + int(removed_.size());
    weight_capacity_ = options_->budget;
    for (const ObstacleId obstacle : removed_) weight_capacity_ += fan_.ray().weight(obstacle);
    if (waits_) list_openable();
    Label start;
    start.at = start_;
    start.set = add_set(removed_);
    start.estimate = estimate(start);
    labels_.push_back(start);
    places_[places_.find_or_add(start_)].labels = 0;
    open_.push_back(0);
    while (!open_.empty()) {
        const std::uint32_t index = open_.front();
        if (const auto outcome = interrupted()) return *outcome;
        std::pop_heap(open_.begin(), open_.end(), [this](auto a, auto b) { return earlier(b, a); });
        open_.pop_back();
        if (labels_[index].dominated) continue;
        if (waits_ && !settle(index)) continue;
        ++result_.expanded;
        // What a wait costs is a lower limit, and may come out below what was proven before.
        if (waits_) proven_ = std::max(proven_, labels_[index].estimate);
        if (labels_[index].group != 0) {
            expand_group(index);
            continue;
        }
        if (labels_[index].at == goal_) {
            if (labels_[index].estimate <= told_) continue;
            const CrossingPath path = path_of(index);
            if (result_.status != SearchStatus::found) result_.best = path;
            result_.status = SearchStatus::found;
            result_.lower_bound = std::max(path.cost / options_->weight, proven_ / 2);
            if (accept_ == nullptr || !(*accept_)(path)) return Outcome::found;
            continue;
        }
        expand(index);
        if (interrupt_.cause() != Interrupt::Cause::none) insert(index);  // it is not all expanded
    }
    return Outcome::exhausted;
}

// Without what was removed anyway.
std::vector<ObstacleId> CrossingSearcher::Search::ids_of(std::span<const ObstacleId> set) const {
    std::vector<ObstacleId> ids;
    std::ranges::copy_if(set, std::back_inserter(ids),
                         [this](ObstacleId id) { return !std::ranges::binary_search(removed_, id); });
    return ids;
}

CrossingPath CrossingSearcher::Search::path_of(std::uint32_t index) {
    CrossingPath path;
    path.cost = labels_[index].estimate / 2;
    for (std::uint32_t label = index; label != no_label; label = labels_[label].parent) {
        const Label& here = labels_[label];
        path.path.emplace_back(here.at.x / 2.0, here.at.y / 2.0);
        if (here.parent == no_label) break;
        const Label& before = labels_[here.parent];
        path.length += length(here.at - before.at) / 2;
        const auto append = [&](ObstacleId id) {
            if (std::ranges::find(path.crossed, id) == path.crossed.end()) path.crossed.push_back(id);
        };
        if (here.gate != 0) {
            const auto& opened = groups_[here.gate].terms().opened;
            path.gates.push_back({path.path.back(), ids_of(sets_[here.set])});
            std::erase_if(path.gates.back().crossed,
                          [&](ObstacleId id) { return std::ranges::binary_search(opened, id); });
            std::ranges::for_each(ids_of(opened), append);
            std::ranges::for_each(path.gates.back().crossed, append);
            continue;
        }
        if (here.set == before.set) continue;
        // Backwards: what is entered last comes first.
        const auto set = sets_[here.set];
        Ray& ray = fan_.ray();
        ray.set_open(sets_[before.set]);
        ray.cast(before.at, here.at, int(set.size()), infinity);
        std::vector<Hit> hits;
        for (const Hit& hit : ray.hits()) {
            if (regions_->within(hit.region, set)) hits.push_back(hit);
        }
        std::sort(hits.begin(), hits.end(),
                  [](const Hit& a, const Hit& b) { return a.at != b.at ? a.at < b.at : a.region < b.region; });
        std::vector<ObstacleId> entered;
        for (const Hit& hit : hits) ray.add_missing(hit.region, entered);
        std::for_each(entered.rbegin(), entered.rend(), append);
    }
    std::reverse(path.gates.begin(), path.gates.end());
    std::reverse(path.path.begin(), path.path.end());
    std::reverse(path.crossed.begin(), path.crossed.end());
    return path;
}

CrossingResult CrossingSearcher::Search::run(const Map& map, Cell start, Cell goal, const CrossingOptions& options,
                                             const std::function<bool(const CrossingPath&)>* accept) {
    interrupt_ = Interrupt(options.limits.seconds, options.limits.stop);
    const std::shared_ptr<const Regions> regions = regions_for(map, options);
    const std::vector<ObstacleId> removed = sorted(options.removed);
    if (!regions->complete()) {
        CrossingResult unknown;
        const Interrupt::Cause cause = interrupt_.cause();
        unknown.status = cause == Interrupt::Cause::none   ? SearchStatus::not_found
                         : cause == Interrupt::Cause::stop ? SearchStatus::stopped
                                                           : SearchStatus::limit_reached;
        unknown.lower_bound = distance(start, goal);
        return unknown;
    }
    if (stands(*regions, start, removed) && stands(*regions, goal, removed)) {
        return run_between(map, centre(start), centre(goal), options, accept);
    }
    CrossingResult none;
    none.lower_bound = infinity;
    return none;
}

bool CrossingSearcher::Search::stands(const Regions& regions, Cell c, std::span<const ObstacleId> removed) {
    if (!regions.map().grid().contains(c)) return false;
    const RegionId region = region_at(regions.map(), c);
    return !region || regions.within(region, removed);
}

// Grown once for all queries that move the same body on the same map, whatever its obstacles weigh.
std::shared_ptr<const Regions> CrossingSearcher::Search::regions_for(const Map& map, const CrossingOptions& options) {
    std::shared_ptr<const Regions>& known = regions_of_[std::size_t(reach_of(options) - 1)];
    if (known && known->serve(map, options)) return known;
    if (known && known->fit(map, options)) return known = std::make_shared<const Regions>(*known, map);
    auto regions = std::make_shared<const Regions>(map, options, interrupt_);
    // What was interrupted may be done with more time.
    if (interrupt_.cause() == Interrupt::Cause::none) known = regions;
    return regions;
}

std::unique_ptr<CrossingSearcher::Search> CrossingSearcher::Search::another() const {
    auto search = std::make_unique<Search>();
    search->regions_of_ = regions_of_;
    return search;
}

CrossingResult CrossingSearcher::Search::run_between(const Map& map, Vertex start, Vertex goal,
                                                     const CrossingOptions& options,
                                                     const std::function<bool(const CrossingPath&)>* accept) {
    map_ = &map;
    options_ = &options;
    accept_ = accept;
    start_ = start;
    goal_ = goal;
    told_ = -1;
    interrupt_ = Interrupt(options.limits.seconds, options.limits.stop);
    regions_ = regions_for(map, options);
    result_ = {};
    result_.lower_bound = infinity;
    removed_ = sorted(options.removed);
    waits_ = bool(options.opened_after);
    if (waits_) {
        borders_.start_query(*regions_, reach_of(options));
        ways_.start_query(map, options);
    }
    // The square turns and waits at lattice points only; the point is a lower limit for who waits anywhere.
    early_ = reach_of(options) == 1 ? 1 : 0;
    start_parts();
    search_ellipses(2 * options.length_limit);
    result_.generated = result_.expanded + open_.size();
    return result_;
}

void CrossingSearcher::Search::start_parts() {
    const bool alone = !waits_ || options_->opens_each_alone;  // another set may open later
    by_count_ = accept_ == nullptr && alone && !options_->done_after;
    // Gates may be where two cells touch at a corner.
    const bool pinched = regions_->pinched() && !waits_ && !to_gate_;
    Convex* const convex = by_count_ && !in_time() && options_->prices.empty() ? &convex_ : nullptr;
    convex_.start_query(*regions_, reach_of(*options_));
    fan_.start_query(*regions_, goal_, *options_, pinched, convex, interrupt_);
    // Who waits may be half a cell from the place that stands for it.
    const double longest = 2 * options_->length_limit + (waits_ ? 2 * early_ : 0);
    const auto start_rest = [&](Rest& rest, Rest::Passes passes) {
        rest.start_query(*regions_, start_, goal_, longest, *options_, passes, pinched, interrupt_);
    };
    if (waits_) start_rest(without_more_, Rest::Passes::open);
    detours_ = false;
    if (options_->crossings == 0) return;
    start_rest(rest_, Rest::Passes::destructible);
    detours_ = rest_.detours(start_);
    rest_of_.clear();
}

// In ellipses that grow until one holds the path: what lies outside costs nothing, and the last one costs about as much
// as all before it.
void CrossingSearcher::Search::search_ellipses(double longest) {
    Label start;
    start.at = start_;
    done_after_.clear();
    paid_.clear();
    sets_.clear();
    start.set = add_set(removed_);
    const double straight = std::min(estimate(start), longest);
    const bool guessed = 2 * options_->expected > straight;
    const double least = guessed ? 2 * options_->expected : straight;
    proven_ = straight;
    // With nothing to cross detours are long; who takes any good path hardly looks at what is far from it.
    const bool wide = options_->crossings == 0 || options_->weight > 1;
    for (double slack = guessed ? 0.004 : wide ? 0.4 : 0.002;; slack *= slack < 0.02 ? 4 : 2) {
        limit_ = slack > 2 || longest < least * (1 + 1.5 * slack) ? longest : least * (1 + slack);
        const Outcome outcome = search_ellipse();
        if (outcome == Outcome::found) return;
        if (outcome != Outcome::exhausted) {
            result_.status = outcome == Outcome::stopped ? SearchStatus::stopped : SearchStatus::limit_reached;
            if (!open_.empty()) {
                const double least_left = labels_[open_.front()].estimate / options_->weight;
                proven_ = std::max(proven_, std::min(limit_, least_left));
            }
            result_.lower_bound = proven_ / 2;
            if (accept_ == nullptr) result_.best = incumbent();
            return;
        }
        proven_ = limit_;
        // A larger ellipse may know of waits that a smaller one does not: what it tells is new.
        if (!waits_) told_ = limit_;
        if (limit_ >= longest) {
            result_.lower_bound = limit_ / 2;
            return;
        }
    }
}

// The best path to the goal that is known before the search ends; empty if none is.
CrossingPath CrossingSearcher::Search::incumbent() {
    std::uint32_t best = no_label;
    for (std::uint32_t label = places_[places_.find_or_add(goal_)].labels; label != no_label;
         label = labels_[label].next) {
        if (best == no_label || earlier(label, best)) best = label;
    }
    return best == no_label ? CrossingPath{} : path_of(best);
}

}  // namespace waybreaker
