// A* over taut paths. A label is a vertex, the set of obstacles crossed on the way there, and the length of the way.
// It is expanded by rays and outlines alone, so that only what stands in the way costs anything: docs/exact.md.
#include "waybreaker/crossing.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>

#include "crossing/fan.hpp"
#include "crossing/labels.hpp"
#include "crossing/validate.hpp"

namespace waybreaker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

class CrossingSearcher::Search {
  public:
    CrossingResult run(const Map& map, Cell start, Cell goal, const CrossingOptions& options,
                       const std::function<bool(const CrossingPath&)>* accept);

  private:
    enum class Outcome { found, exhausted, limit_reached, stopped };

    Outcome search_ellipse();
    void expand(std::uint32_t label);
    void push(std::uint32_t parent, const Reached& reached);
    bool dominates(const Label& better, const Label& worse) const;
    bool lost(std::uint32_t obstacle, const Label& label) const;
    bool earlier(std::uint32_t a, std::uint32_t b) const;
    std::optional<Outcome> interrupted();
    CrossingPath path_of(std::uint32_t label);

    const Map* map_ = nullptr;
    const CrossingOptions* options_ = nullptr;
    const std::function<bool(const CrossingPath&)>* accept_ = nullptr;
    Vertex start_;
    Vertex goal_;
    int capacity_ = 0;  // members of a set, the removed obstacles included
    double weight_capacity_ = infinity;
    double limit_ = infinity;  // half cells; longer paths are outside the ellipse
    double told_ = 0;          // half cells; shorter paths have been told to `accept`
    std::chrono::steady_clock::time_point began_;
    CrossingResult result_;

    Fan fan_;
    ObstacleSets sets_;
    Places places_;
    std::vector<Label> labels_;
    std::vector<std::uint32_t> open_;  // heap
};

bool CrossingSearcher::Search::earlier(std::uint32_t a, std::uint32_t b) const {
    const Label& la = labels_[a];
    const Label& lb = labels_[b];
    if (la.estimate != lb.estimate) return la.estimate < lb.estimate;
    if (la.length != lb.length) return la.length > lb.length;
    return a < b;
}

// No path within the ellipse can come back to the obstacle.
bool CrossingSearcher::Search::lost(std::uint32_t obstacle, const Label& label) const {
    const Box& box = map_->obstacle(ObstacleId{obstacle}).bounds;
    const auto gap = [&box](Vertex v) {
        const int dx = std::max({2 * box.min.x - 2 - v.x, v.x - 2 * box.max.x - 2, 0});
        const int dy = std::max({2 * box.min.y - 2 - v.y, v.y - 2 * box.max.y - 2, 0});
        return length({dx, dy});
    };
    return label.length + gap(label.at) + gap(goal_) > limit_;
}

// Whatever way goes on from `worse` goes on from `better` as well, is no longer and crosses no more: what only `better`
// has crossed is made up for by what `worse` has and can never use again.
bool CrossingSearcher::Search::dominates(const Label& better, const Label& worse) const {
    if (better.length > worse.length) return false;
    if (better.set == worse.set) return true;
    const auto mine = sets_[better.set];
    const auto theirs = sets_[worse.set];
    int more = 0;
    double more_weight = 0;
    std::size_t j = 0;
    for (const std::uint32_t obstacle : mine) {
        while (j < theirs.size() && theirs[j] < obstacle) ++j;
        if (j < theirs.size() && theirs[j] == obstacle) continue;
        ++more;
        more_weight += fan_.ray().weight(obstacle);
    }
    if (more == 0) return true;
    if (accept_ != nullptr) return false;
    j = 0;
    for (const std::uint32_t obstacle : theirs) {
        while (j < mine.size() && mine[j] < obstacle) ++j;
        if (j < mine.size() && mine[j] == obstacle) continue;
        if (!lost(obstacle, worse)) continue;
        --more;
        more_weight -= fan_.ray().weight(obstacle);
    }
    return more <= 0 && more_weight <= 0;
}

void CrossingSearcher::Search::push(std::uint32_t parent, const Reached& reached) {
    const std::span<const std::uint32_t> crossed = reached.crossed;
    const Vertex v = reached.at;
    Label label;
    label.at = v;
    label.length = labels_[parent].length + length(v - labels_[parent].at);
    label.estimate = label.length + length(goal_ - v);
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
    const std::uint32_t place = places_.find_or_add(v);
    for (std::uint32_t other = places_[place].labels; other != no_label; other = labels_[other].next) {
        if (!labels_[other].dominated && dominates(labels_[other], label)) return;
    }
    for (std::uint32_t other = places_[place].labels; other != no_label; other = labels_[other].next) {
        if (!labels_[other].dominated && dominates(label, labels_[other])) labels_[other].dominated = true;
    }
    label.next = places_[place].labels;
    places_[place].labels = std::uint32_t(labels_.size());
    labels_.push_back(label);
    open_.push_back(std::uint32_t(labels_.size() - 1));
    std::push_heap(open_.begin(), open_.end(), [this](auto a, auto b) { return earlier(b, a); });
}

void CrossingSearcher::Search::expand(std::uint32_t index) {
    const Label label = labels_[index];
    Viewpoint from{.at = label.at,
                   .arriving = std::nullopt,
                   .open = sets_[label.set],
                   .crossings = capacity_ - int(sets_[label.set].size()),
                   .weight = weight_capacity_,
                   .range = limit_ - label.length};
    if (label.parent != no_label) from.arriving = label.at - labels_[label.parent].at;
    for (const std::uint32_t obstacle : from.open) from.weight -= fan_.ray().weight(obstacle);
    for (const Reached& reached : fan_.look(from, accept_ != nullptr)) push(index, reached);
}

std::optional<CrossingSearcher::Search::Outcome> CrossingSearcher::Search::interrupted() {
    if (result_.expanded >= options_->expansion_limit) return Outcome::limit_reached;
    if (result_.expanded % 64 != 0) return std::nullopt;
    if (options_->stop.stop_requested()) return Outcome::stopped;
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - began_;
    if (spent.count() > options_->time_limit) return Outcome::limit_reached;
    return std::nullopt;
}

CrossingSearcher::Search::Outcome CrossingSearcher::Search::search_ellipse() {
    labels_.clear();
    open_.clear();
    sets_.clear();
    places_.clear();
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
            if (labels_[index].length <= told_) continue;
            result_.status = SearchStatus::found;
            result_.best = path_of(index);
            if (accept_ == nullptr || !(*accept_)(result_.best)) return Outcome::found;
            continue;
        }
        expand(index);
    }
    return Outcome::exhausted;
}

CrossingPath CrossingSearcher::Search::path_of(std::uint32_t index) {
    CrossingPath path;
    path.length = labels_[index].length / 2;
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
        ray.start(int(set.size()), infinity);
        ray.walk(before.at, here.at);
        std::vector<Hit> hits;
        for (const Hit& hit : ray.hits()) {
            if (std::binary_search(set.begin(), set.end(), hit.obstacle)) hits.push_back(hit);
        }
        std::sort(hits.begin(), hits.end(),
                  [](const Hit& a, const Hit& b) { return a.at != b.at ? a.at > b.at : a.obstacle > b.obstacle; });
        for (const Hit& hit : hits) path.crossed.push_back(ObstacleId{hit.obstacle});
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
    began_ = std::chrono::steady_clock::now();
    result_ = {};
    result_.lower_bound = infinity;
    const auto stands = [&](Cell c) {
        if (!map.grid().contains(c)) return false;
        const ObstacleId id = map.obstacle_at(c);
        return !id || std::find(options.removed.begin(), options.removed.end(), id) != options.removed.end();
    };
    if (!stands(start) || !stands(goal)) return result_;
    fan_.start_query(map, options.body, goal_, options.protect, options.weights);
    const double straight = length(goal_ - start_);
    const double most = 2 * options.length_limit;
    double proven = straight;
    for (double slack = 0.002;; slack *= 4) {
        limit_ = slack > 2 ? infinity : straight * (1 + slack);
        limit_ = std::min(limit_, most);
        const Outcome outcome = search_ellipse();
        if (outcome == Outcome::found) {
            result_.status = SearchStatus::found;
            result_.lower_bound = result_.best.length;
            break;
        }
        if (outcome != Outcome::exhausted) {
            result_.status = outcome == Outcome::stopped ? SearchStatus::stopped : SearchStatus::limit_reached;
            if (!open_.empty()) proven = std::max(proven, std::min(limit_, labels_[open_.front()].estimate));
            result_.lower_bound = proven / 2;
            break;
        }
        proven = limit_;
        told_ = limit_;
        if (limit_ >= most) {
            result_.lower_bound = limit_ / 2;
            break;
        }
    }
    result_.generated = result_.expanded + open_.size();
    return result_;
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
