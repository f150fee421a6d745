// A* over taut paths. A label is a vertex, the set of obstacles crossed on the way there, and the length of the way.
// It is expanded by rays and outlines alone, so that only what stands in the way costs anything: docs/exact.md.
#include "waybreaker/crossing.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>
#include <string>

#include "crossing/labels.hpp"
#include "crossing/outline.hpp"
#include "crossing/ray.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The directions in which a taut path can leave the corner of an obstacle: from straight on to along the obstacle.
struct Sector {
    Step straight;
    Step sliding;
    std::uint32_t obstacle = 0;  // 0: the start, from which all directions are taut
    Step quadrant;               // where it lies
    int turn = 0;                // sign of cross(straight, sliding)

    bool holds(Step direction) const {
        if (obstacle == 0) return true;
        return sign(cross(straight, direction)) * turn >= 0 && sign(cross(direction, sliding)) * turn >= 0;
    }
};

void validate(const Map& map, const CrossingOptions& options) {
    const auto check_ids = [&map](std::span<const ObstacleId> ids, const char* what) {
        for (const ObstacleId id : ids) {
            if (id.value >= 1 && id.value <= map.obstacles().size()) continue;
            throw InputError("the map has no obstacle " + std::to_string(id.value) + " to " + what + "; it has " +
                             std::to_string(map.obstacles().size()));
        }
    };
    if (options.crossings < 0) throw InputError("the number of crossings cannot be negative");
    check_ids(options.removed, "remove");
    check_ids(options.protect, "protect");
    if (!(options.budget >= 0)) throw InputError("the budget cannot be negative");
    if (options.weights.empty()) return;
    if (options.weights.size() != map.obstacles().size() + 1) {
        throw InputError("there are " + std::to_string(options.weights.size()) + " weights, not one for each of " +
                         std::to_string(map.obstacles().size()) + " obstacles and one for id 0");
    }
    for (std::size_t id = 1; id < options.weights.size(); ++id) {
        if (options.weights[id] > 0 && options.weights[id] < infinity) continue;
        throw InputError("the weight of obstacle " + std::to_string(id) + " must be a positive number");
    }
}

}  // namespace

class CrossingSearcher::Search {
  public:
    CrossingResult run(const Map& map, Cell start, Cell goal, const CrossingOptions& options,
                       const std::function<bool(const CrossingPath&)>* accept);

  private:
    struct Corner {
        Vertex at;
        int open;
    };
    enum class Outcome { found, exhausted, limit_reached, stopped };

    Outcome search_ellipse();
    void expand(std::uint32_t label);
    void walk_on(Vertex from, Step direction);
    void look_at(const Corner& corner);
    void scan_from_hits(Step direction, int open_behind = 0);
    void scan(const Outline& outline, Side side, int turn);
    std::optional<Side> behind_notch(const Outline& outline, Side side, Step corner, int turn) const;
    bool clear(Vertex a, Vertex b) const;
    bool passed(Vertex bend, const Side& side, Outline::Turn kind);
    void note(Vertex corner, int open);
    bool bends(Vertex v, Step arriving, std::span<const std::uint32_t> crossed) const;
    void emit(Vertex v);
    void emit_squeezed(Vertex v, std::size_t squeeze, std::vector<std::uint32_t>& crossed);
    void push(Vertex v, std::span<const std::uint32_t> crossed);
    bool dominates(const Label& better, const Label& worse) const;
    bool lost(std::uint32_t obstacle, const Label& label) const;
    bool inside(Vertex v) const {
        const double x = v.x - middle_x_;
        const double y = v.y - middle_y_;
        const double along = x * axis_x_ + y * axis_y_;
        const double across = x * axis_y_ - y * axis_x_;
        return along * along * along_scale_ + across * across * across_scale_ <= 1;
    }
    void set_ellipse();
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

    Ray ray_;
    ObstacleSets sets_;
    Places places_;
    std::vector<Label> labels_;
    std::vector<std::uint32_t> open_;  // heap

    // The label being expanded.
    std::uint32_t label_ = no_label;
    Vertex at_;
    double length_ = 0;
    int crossings_left_ = 0;
    double weight_left_ = 0;
    double middle_x_, middle_y_, axis_x_, axis_y_, along_scale_, across_scale_;  // the ellipse that is left
    Sector sector_;
    std::vector<Corner> corners_;  // to look at
    Done done_;
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
        more_weight += ray_.weight(obstacle);
    }
    if (more == 0) return true;
    if (accept_ != nullptr) return false;
    j = 0;
    for (const std::uint32_t obstacle : theirs) {
        while (j < mine.size() && mine[j] < obstacle) ++j;
        if (j < mine.size() && mine[j] == obstacle) continue;
        if (!lost(obstacle, worse)) continue;
        --more;
        more_weight -= ray_.weight(obstacle);
    }
    return more <= 0 && more_weight <= 0;
}

void CrossingSearcher::Search::push(Vertex v, std::span<const std::uint32_t> crossed) {
    Label label;
    label.at = v;
    label.length = length_ + length(v - at_);
    label.estimate = label.length + length(goal_ - v);
    if (label.estimate > limit_) return;
    label.parent = label_;
    label.set = labels_[label_].set;
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

// Whether a path that arrives at v along the current ray can bend there, around an obstacle that still stands.
bool CrossingSearcher::Search::bends(Vertex v, Step arriving, std::span<const std::uint32_t> crossed) const {
    const bool square = options_->body == Body::square;
    for (const Step quadrant : quadrants) {
        if (sliding(arriving, quadrant) == Step{}) continue;
        // The three cells that decide: in the quadrant, and beside it.
        const Cell corner = square ? Cell{v.x / 2 + quadrant.x, v.y / 2 + quadrant.y}
                                   : Cell{(v.x + quadrant.x) / 2, (v.y + quadrant.y) / 2};
        if (!map_->grid().contains(corner)) continue;
        const std::uint32_t obstacle = map_->obstacle_at(corner).value;
        if (obstacle == 0 || ray_.open(obstacle)) continue;
        const Outline outline(*map_, options_->body, obstacle);
        if (outline.owns(corner + Step{-quadrant.x, 0}) || outline.owns(corner + Step{0, -quadrant.y})) continue;
        if (square && outline.owns(corner + -quadrant)) continue;
        if (std::find(crossed.begin(), crossed.end(), obstacle) != crossed.end()) continue;
        return true;
    }
    return false;
}

void CrossingSearcher::Search::emit(Vertex v) {
    std::vector<std::uint32_t> crossed;
    for (const Hit& hit : ray_.hits()) {
        if (hit.surely) crossed.push_back(hit.obstacle);
    }
    emit_squeezed(v, 0, crossed);
}

// One way for each choice between the two obstacles of a squeeze.
void CrossingSearcher::Search::emit_squeezed(Vertex v, std::size_t squeeze, std::vector<std::uint32_t>& crossed) {
    double weight = 0;
    for (const std::uint32_t obstacle : crossed) weight += ray_.weight(obstacle);
    if (int(crossed.size()) > crossings_left_ || weight > weight_left_) return;
    if (squeeze == ray_.squeezes().size()) {
        if (v == goal_ || bends(v, v - at_, crossed)) push(v, crossed);
        return;
    }
    const Squeeze& pair = ray_.squeezes()[squeeze];
    const auto has = [&crossed](std::uint32_t obstacle) {
        return std::find(crossed.begin(), crossed.end(), obstacle) != crossed.end();
    };
    if (has(pair.one) || has(pair.other)) {
        emit_squeezed(v, squeeze + 1, crossed);
        return;
    }
    for (const std::uint32_t obstacle : {pair.one, pair.other}) {
        if (ray_.solid(obstacle)) continue;
        crossed.push_back(obstacle);
        emit_squeezed(v, squeeze + 1, crossed);
        crossed.pop_back();
    }
}

// A corner that the outline hides in a notch of its own as soon as it is passed: what bends around it gets nowhere. The
// side where the outline comes back into view, if it does so soon.
std::optional<Side> CrossingSearcher::Search::behind_notch(const Outline& outline, Side side, Step corner,
                                                           int turn) const {
    constexpr int notch = 8;  // bends
    const auto ahead = [corner](Step step) {
        const Step beyond{step.x - corner.x, step.y - corner.y};
        return std::int64_t(beyond.x) * corner.x + std::int64_t(beyond.y) * corner.y >= 0;
    };
    const Step to_goal = goal_ - at_;
    int min_x = corner.x, max_x = corner.x, min_y = corner.y, max_y = corner.y;
    for (int bends = 0; bends < notch;) {
        const Outline::Turn kind = outline.turn(side);
        if (kind != Outline::Turn::straight) {
            const Step bend = outline.bend(side, kind) - at_;
            if (!ahead(bend)) return std::nullopt;
            min_x = std::min(min_x, bend.x);
            max_x = std::max(max_x, bend.x);
            min_y = std::min(min_y, bend.y);
            max_y = std::max(max_y, bend.y);
            if (sign(cross(corner, bend)) * turn >= 0 && bends > 0) {
                const bool holds_goal =
                    to_goal.x >= min_x && to_goal.x <= max_x && to_goal.y >= min_y && to_goal.y <= max_y;
                return !holds_goal && clear(at_ + corner, at_ + bend) ? std::optional(side) : std::nullopt;
            }
            ++bends;
        }
        side = outline.next(side, kind);
    }
    return std::nullopt;
}

// Whether nothing that stands is in the way between two near vertices, this outline's own obstacle included.
bool CrossingSearcher::Search::clear(Vertex a, Vertex b) const {
    const int reach = reach_of(options_->body);
    const Step step = b - a;
    if (reach == 1 && (step.x == 0 || step.y == 0)) return false;  // along cell edges
    const auto first = [reach](int low) { return int(floor_divide(low - reach, 2)) + 1; };
    const auto last = [reach](int high) { return int(floor_divide(high + reach - 1, 2)); };
    const Cell min{first(std::min(a.x, b.x)), first(std::min(a.y, b.y))};
    const Cell max{last(std::max(a.x, b.x)), last(std::max(a.y, b.y))};
    if (max.x - min.x > 16 || max.y - min.y > 16) return false;
    const std::int64_t width = std::int64_t(reach) * (std::abs(step.x) + std::abs(step.y));
    for (Cell c = min; c.y <= max.y; ++c.y) {
        for (c.x = min.x; c.x <= max.x; ++c.x) {
            if (!map_->grid().contains(c)) return false;
            const std::uint32_t obstacle = map_->obstacle_at(c).value;
            if (obstacle != 0 && !ray_.open(obstacle) && std::abs(cross(step, centre(c) - a)) < width) return false;
        }
    }
    return true;
}

// Follows an outline as seen from the label, and notes the corners it could be passed at: up to the first one that ends
// its visible front (a path there turns against `turn`), the sector or the ellipse.
void CrossingSearcher::Search::scan(const Outline& outline, Side side, int turn) {
    const Side first = side;
    do {
        const Outline::Turn kind = outline.turn(side);
        Side next = outline.next(side, kind);
        if (kind != Outline::Turn::straight) {
            const Vertex bend = outline.bend(side, kind);
            const Step arriving = bend - at_;
            if (arriving != Step{}) {
                if (!sector_.holds(arriving) || !inside(bend) || passed(bend, side, kind)) return;
                if (kind == Outline::Turn::away) {
                    const Step slide = sliding(arriving, -(side.along + side.outward));
                    const int bending = sign(cross(arriving, slide));
                    if (bending == -turn) {
                        const std::optional<Side> back = behind_notch(outline, next, arriving, turn);
                        if (!back) {
                            note(bend, turn);
                            return;
                        }
                        next = *back;
                    } else if (bending != 0) {
                        note(bend, -turn);
                    }
                }
            }
        }
        side = next;
    } while (!(side == first));
}

// Whether this expansion has followed the outline from here before; from now on it has.
bool CrossingSearcher::Search::passed(Vertex bend, const Side& side, Outline::Turn kind) {
    // A bend, the side before it and the way the side is followed name one corner of one cell.
    const int outward = side.outward.x != 0 ? side.outward.x + 1 : side.outward.y + 2;  // 0 to 3
    const int along = side.along.x + side.along.y > 0 ? 1 : 0;
    const int concave = kind == Outline::Turn::back ? 1 : 0;
    return done_.before(bend, unsigned(4 * outward + 2 * along + concave));
}

// `open`: on which side of the corner one sees past it.
void CrossingSearcher::Search::note(Vertex corner, int open) {
    if (!done_.before(corner, open > 0 ? 16 : 17)) corners_.push_back({corner, open});
}

void CrossingSearcher::Search::scan_from_hits(Step direction, int open_behind) {
    for (const Hit& hit : ray_.hits()) {
        const Outline outline(*map_, options_->body, hit.obstacle);
        Cell cell = hit.cell;
        Step side = hit.side;
        if (outline.owns(cell + side)) {  // it was entered at a concave corner, through two boxes at once
            cell = cell + side;
            side = side.x != 0 ? Step{0, -sign(direction.y)} : Step{-sign(direction.x), 0};
        }
        for (const Step along : {Step{side.y, side.x}, Step{-side.y, -side.x}}) {
            const int turn = sign(cross(direction, along));
            if (open_behind != 0 && hit.leg > 1 && turn == -open_behind) continue;  // hidden by the corner
            if (turn != 0) {
                scan(outline, {cell, side, along}, turn);
            } else if (sign(along.x) == -sign(direction.x) && sign(along.y) == -sign(direction.y)) {
                scan(outline, {cell, side, along}, sign(cross(direction, -side)));
            }
        }
    }
}

// Goes on to where the ray leaves the ellipse, or the map.
void CrossingSearcher::Search::walk_on(Vertex from, Step direction) {
    double range = 2.0 * (map_->width() + map_->height());
    const double step = length(direction);
    if (limit_ < infinity) {
        const Step to_goal = goal_ - at_;
        const double left = limit_ - length_;
        const double distance = length(to_goal);
        const double along = (double(direction.x) * to_goal.x + double(direction.y) * to_goal.y) / step;
        if (left > distance) range = std::min(range, (left * left - distance * distance) / (2 * (left - along)));
        range -= length(from - at_);
        if (range <= 0) return;
    }
    const int times = int(range / step) + 1;
    ray_.walk(from, {from.x + direction.x * times, from.y + direction.y * times});
}

void CrossingSearcher::Search::look_at(const Corner& corner) {
    const Vertex v = corner.at;
    const Step direction = v - at_;
    if (!sector_.holds(direction)) return;
    ray_.start(crossings_left_, weight_left_);
    if (ray_.walk(at_, v)) {
        emit(v);
        walk_on(v, direction);
    }
    scan_from_hits(direction, corner.open);
}

// Where a path through the label that is short enough can go: foci at the label and the goal.
void CrossingSearcher::Search::set_ellipse() {
    const Step to_goal = goal_ - at_;
    const double distance = length(to_goal);
    middle_x_ = at_.x + to_goal.x / 2.0;
    middle_y_ = at_.y + to_goal.y / 2.0;
    axis_x_ = distance > 0 ? to_goal.x / distance : 1;
    axis_y_ = distance > 0 ? to_goal.y / distance : 0;
    const double half = (limit_ - length_) / 2 * (1 + 1e-9);
    along_scale_ = limit_ < infinity ? 1 / (half * half) : 0;
    across_scale_ = limit_ < infinity ? 1 / std::max(half * half - distance * distance / 4, 1e-9) : 0;
}

void CrossingSearcher::Search::expand(std::uint32_t index) {
    const Label label = labels_[index];
    label_ = index;
    at_ = label.at;
    length_ = label.length;
    set_ellipse();
    const auto set = sets_[label.set];
    ray_.set_open(set);
    crossings_left_ = capacity_ - int(set.size());
    weight_left_ = weight_capacity_;
    for (const std::uint32_t obstacle : set) weight_left_ -= ray_.weight(obstacle);

    std::vector<Sector> sectors;
    if (label.parent == no_label) {
        sectors.push_back({});
    } else {
        const Step straight = label.at - labels_[label.parent].at;
        const bool square = options_->body == Body::square;
        for (const Step quadrant : quadrants) {
            const Step slide = sliding(straight, quadrant);
            if (slide == Step{}) continue;
            const Cell corner = square ? Cell{at_.x / 2 + quadrant.x, at_.y / 2 + quadrant.y}
                                       : Cell{(at_.x + quadrant.x) / 2, (at_.y + quadrant.y) / 2};
            if (!map_->grid().contains(corner)) continue;
            const std::uint32_t obstacle = map_->obstacle_at(corner).value;
            if (obstacle == 0 || ray_.open(obstacle)) continue;
            const Outline outline(*map_, options_->body, obstacle);
            if (outline.owns(corner + Step{-quadrant.x, 0}) || outline.owns(corner + Step{0, -quadrant.y})) continue;
            if (square && outline.owns(corner + -quadrant)) continue;
            sectors.push_back({straight, slide, obstacle, quadrant, sign(cross(straight, slide))});
        }
    }
    for (const Sector& sector : sectors) {
        sector_ = sector;
        done_.clear();
        corners_.clear();
        if (sector.holds(goal_ - at_)) {
            ray_.start(crossings_left_, weight_left_);
            if (ray_.walk(at_, goal_)) {
                emit(goal_);
                if (accept_ == nullptr) return;
            }
            scan_from_hits(goal_ - at_);
        }
        if (sector.obstacle != 0) {
            for (const Step limit : {sector.straight, sector.sliding}) {
                ray_.start(crossings_left_, weight_left_);
                walk_on(at_, limit);
                scan_from_hits(limit);
            }
            const Outline outline(*map_, options_->body, sector.obstacle);
            const bool square = options_->body == Body::square;
            const Step q = sector.quadrant;
            const Cell corner =
                square ? Cell{at_.x / 2 + q.x, at_.y / 2 + q.y} : Cell{(at_.x + q.x) / 2, (at_.y + q.y) / 2};
            scan(outline, {corner, -(q + -sector.sliding), sector.sliding}, -sector.turn);
        }
        while (!corners_.empty()) {
            const Corner corner = corners_.back();
            corners_.pop_back();
            look_at(corner);
        }
    }
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
    for (const std::uint32_t obstacle : removed) weight_capacity_ += ray_.weight(obstacle);
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
        ray_.set_open(sets_[before.set]);
        ray_.start(int(set.size()), infinity);
        ray_.walk(before.at, here.at);
        std::vector<Hit> hits;
        for (const Hit& hit : ray_.hits()) {
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
    ray_.start_query(map, options.body, options.protect, options.weights);
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
