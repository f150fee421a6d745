// A* over taut paths. A label is a vertex, the set of obstacles crossed on the way there, and the length of the way.
// It is expanded by rays and outlines alone, so that only what stands in the way costs anything: docs/exact.md.
#include "waybreaker/crossing.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "crossing/dominance.hpp"
#include "crossing/fan.hpp"
#include "crossing/interrupt.hpp"
#include "crossing/labels.hpp"
#include "crossing/validate.hpp"

namespace waybreaker {

using namespace crossing;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

class CrossingSearcher::Search {
  public:
    CrossingResult run(const Map& map, Cell start, Cell goal, const CrossingOptions& options,
                       const std::function<bool(const CrossingPath&)>* accept);

  private:
    enum class Outcome { found, exhausted, limit_reached, stopped };

    void search_ellipses(double longest);
    Outcome search_ellipse();
    void expand(std::uint32_t index);
    double least_cost(std::uint32_t parent, const Reached& reached) const;
    void push(std::uint32_t parent, const Reached& reached);
    void insert(std::uint32_t label);
    bool earlier(std::uint32_t a, std::uint32_t b) const;
    std::optional<Outcome> interrupted();
    CrossingPath path_of(std::uint32_t index);
    CrossingPath incumbent();

    const Map* map_ = nullptr;
    const CrossingOptions* options_ = nullptr;
    const std::function<bool(const CrossingPath&)>* accept_ = nullptr;
    Vertex start_;
    Vertex goal_;
    int capacity_ = 0;  // members of a set, the removed obstacles included
    double weight_capacity_ = infinity;
    double limit_ = infinity;  // half cells; dearer paths are left out
    double told_ = 0;          // half cells; cheaper paths have been told to `accept`
    CrossingResult result_;

    Interrupt interrupt_;
    Fan fan_;
    ObstacleSets sets_;
    Places places_;
    std::vector<Label> labels_;
    std::vector<Front> fronts_;        // straight on from labels; the first is none
    std::vector<std::uint32_t> open_;  // heap
};

bool CrossingSearcher::Search::earlier(std::uint32_t a, std::uint32_t b) const {
    const Label& la = labels_[a];
    const Label& lb = labels_[b];
    if (la.estimate != lb.estimate) return la.estimate < lb.estimate;
    if (la.length != lb.length) return la.length > lb.length;
    return a < b;
}

// Half cells.
double CrossingSearcher::Search::least_cost(std::uint32_t parent, const Reached& reached) const {
    double least = labels_[parent].least;
    if (!options_->least_cost) return least;
    for (const std::uint32_t id : reached.crossed) least = std::max(least, 2 * options_->least_cost(ObstacleId{id}));
    return least;
}

void CrossingSearcher::Search::push(std::uint32_t parent, const Reached& reached) {
    const std::span<const std::uint32_t> crossed = reached.crossed;
    const Vertex v = reached.at;
    Label label;
    label.at = v;
    label.length = labels_[parent].length + length(v - labels_[parent].at);
    label.least = least_cost(parent, reached);
    label.estimate = std::max(label.length + length(goal_ - v), label.least);
    if (label.estimate > limit_) return;
    label.parent = parent;
    label.set = labels_[parent].set;
    if (!crossed.empty()) {
        const auto before = sets_[label.set];
        std::vector<std::uint32_t> set(before.begin(), before.end());
        set.insert(set.end(), crossed.begin(), crossed.end());
        std::sort(set.begin(), set.end());
        label.set = sets_.add(set);
    }
    const Dominance dominates{*map_, sets_, options_->budget < infinity, goal_, limit_, accept_ == nullptr};
    const std::uint32_t place = places_.find_or_add(v);
    for (std::uint32_t other = places_[place].labels; other != no_label; other = labels_[other].next) {
        if (!labels_[other].dominated && dominates(labels_[other], label)) return;
    }
    for (std::uint32_t other = places_[place].labels; other != no_label; other = labels_[other].next) {
        if (!labels_[other].dominated && dominates(label, labels_[other])) labels_[other].dominated = true;
    }
    if (const auto ahead = fan_.ahead(reached)) {
        label.fronts_begin = std::uint32_t(fronts_.size());
        fronts_.insert(fronts_.end(), ahead->begin(), ahead->end());
        label.fronts_end = std::uint32_t(fronts_.size());
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
                   .range = limit_ - label.length};
    if (label.parent != no_label) from.arriving = label.at - labels_[label.parent].at;
    for (const std::uint32_t obstacle : from.open) from.weight -= fan_.ray().weight(obstacle);
    for (bool alternatives = accept_ != nullptr;; alternatives = true) {
        bool dear = false;  // the straight way to the goal costs more than its length: a detour can cost less
        // What is pushed moves them.
        from.open = sets_[label.set];
        if (label.fronts_begin != 0) {
            from.ahead = std::span(fronts_.data() + label.fronts_begin, fronts_.data() + label.fronts_end);
        }
        const std::span<const Reached> all = fan_.look(from, alternatives);
        if (interrupt_.cause() != Interrupt::Cause::none) return;
        for (const Reached& reached : all) {
            push(index, reached);
            if (reached.at == goal_)
                dear = dear || least_cost(index, reached) > label.length + length(goal_ - label.at);
        }
        if (alternatives || !dear) return;
    }
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
    places_.clear();
    fronts_.resize(1);
    std::vector<std::uint32_t> removed;
    for (const ObstacleId id : options_->removed) removed.push_back(id.value);
    std::sort(removed.begin(), removed.end());
    removed.erase(std::unique(removed.begin(), removed.end()), removed.end());
    capacity_ = options_->crossings + int(removed.size());
    weight_capacity_ = options_->budget;
    for (const std::uint32_t obstacle : removed) weight_capacity_ += fan_.ray().weight(obstacle);
    Label start;
    start.at = start_;
    start.estimate = length(goal_ - start_);
    start.set = sets_.add(removed);
    labels_.push_back(start);
    places_[places_.find_or_add(start_)].labels = 0;
    open_.push_back(0);
    while (!open_.empty()) {
        const std::uint32_t index = open_.front();
        if (const auto outcome = interrupted()) return *outcome;
        std::pop_heap(open_.begin(), open_.end(), [this](auto a, auto b) { return earlier(b, a); });
        open_.pop_back();
        if (labels_[index].dominated) continue;
        ++result_.expanded;
        if (labels_[index].at == goal_) {
            if (labels_[index].estimate <= told_) continue;
            const CrossingPath path = path_of(index);
            if (result_.status != SearchStatus::found) result_.best = path;
            result_.status = SearchStatus::found;
            result_.lower_bound = path.cost;
            if (accept_ == nullptr || !(*accept_)(path)) return Outcome::found;
            continue;
        }
        expand(index);
        if (interrupt_.cause() != Interrupt::Cause::none) insert(index);  // it is not all expanded
    }
    return Outcome::exhausted;
}

CrossingPath CrossingSearcher::Search::path_of(std::uint32_t index) {
    CrossingPath path;
    path.length = labels_[index].length / 2;
    path.cost = labels_[index].estimate / 2;
    for (std::uint32_t label = index; label != no_label; label = labels_[label].parent) {
        const Label& here = labels_[label];
        path.path.emplace_back(here.at.x / 2.0, here.at.y / 2.0);
        if (here.parent == no_label) break;
        const Label& before = labels_[here.parent];
        if (here.set == before.set) continue;
        // Backwards: what is entered last comes first.
        const auto set = sets_[here.set];
        Ray& ray = fan_.ray();
        ray.set_open(sets_[before.set]);
        ray.cast(before.at, here.at, int(set.size()), infinity);
        std::vector<Hit> hits;
        for (const Hit& hit : ray.hits()) {
            if (std::binary_search(set.begin(), set.end(), hit.obstacle)) hits.push_back(hit);
        }
        std::sort(hits.begin(), hits.end(),
                  [](const Hit& a, const Hit& b) { return a.at != b.at ? a.at > b.at : a.obstacle > b.obstacle; });
        for (const Hit& hit : hits) {
            const ObstacleId id{hit.obstacle};
            if (std::find(path.crossed.begin(), path.crossed.end(), id) == path.crossed.end())
                path.crossed.push_back(id);
        }
    }
    std::reverse(path.path.begin(), path.path.end());
    std::reverse(path.crossed.begin(), path.crossed.end());
    return path;
}

CrossingResult CrossingSearcher::Search::run(const Map& map, Cell start, Cell goal, const CrossingOptions& options,
                                             const std::function<bool(const CrossingPath&)>* accept) {
    map_ = &map;
    options_ = &options;
    accept_ = accept;
    start_ = centre(start);
    goal_ = centre(goal);
    told_ = -1;
    interrupt_ = Interrupt(options.limits.seconds, options.limits.stop);
    result_ = {};
    result_.lower_bound = infinity;
    const auto stands = [&](Cell c) {
        if (!map.grid().contains(c)) return false;
        const ObstacleId id = map.obstacle_at(c);
        return !id || std::find(options.removed.begin(), options.removed.end(), id) != options.removed.end();
    };
    if (!stands(start) || !stands(goal)) return result_;
    fan_.start_query(map, goal_, options, interrupt_);
    search_ellipses(2 * options.length_limit);
    result_.generated = result_.expanded + open_.size();
    return result_;
}

// In ellipses that grow until one holds the path: what lies outside costs nothing, and the last one costs about as much
// as all before it.
void CrossingSearcher::Search::search_ellipses(double longest) {
    const double straight = length(goal_ - start_);
    const bool guessed = 2 * options_->expected > straight;
    const double least = guessed ? 2 * options_->expected : straight;
    double proven = straight;
    // With nothing to cross detours are long.
    for (double slack = guessed ? 0.004 : options_->crossings == 0 ? 0.4 : 0.002;; slack *= slack < 0.02 ? 4 : 2) {
        limit_ = slack > 2 || longest < least * (1 + 1.5 * slack) ? longest : least * (1 + slack);
        const Outcome outcome = search_ellipse();
        if (outcome == Outcome::found) return;
        if (outcome != Outcome::exhausted) {
            result_.status = outcome == Outcome::stopped ? SearchStatus::stopped : SearchStatus::limit_reached;
            if (!open_.empty()) proven = std::max(proven, std::min(limit_, labels_[open_.front()].estimate));
            result_.lower_bound = proven / 2;
            if (accept_ == nullptr) result_.best = incumbent();
            return;
        }
        proven = limit_;
        told_ = limit_;
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

CrossingSearcher::CrossingSearcher() : search_(std::make_unique<Search>()) {}
CrossingSearcher::~CrossingSearcher() = default;
CrossingSearcher::CrossingSearcher(CrossingSearcher&&) noexcept = default;
CrossingSearcher& CrossingSearcher::operator=(CrossingSearcher&&) noexcept = default;

CrossingResult CrossingSearcher::find(const Map& map, Cell start, Cell goal, const CrossingOptions& options) {
    validate(map, options);
    return search_->run(map, start, goal, options, nullptr);
}

CrossingResult CrossingSearcher::enumerate(const Map& map, Cell start, Cell goal, const CrossingOptions& options,
                                           const std::function<bool(const CrossingPath&)>& accept) {
    validate(map, options);
    return search_->run(map, start, goal, options, &accept);
}

}  // namespace waybreaker
