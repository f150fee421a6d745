#include "crossing/geometry/fan.hpp"

#include <algorithm>
#include <cstdlib>

#include "crossing/tuning.hpp"

namespace waybreaker::crossing {

void Fan::start_query(const Regions& regions, Vertex goal, const CrossingOptions& options, bool pinched, Convex* convex,
                      Interrupt& interrupt) {
    regions_ = &regions;
    convex_ = convex;
    map_ = &regions.map();
    interrupt_ = &interrupt;
    reach_ = reach_of(options);
    goal_ = goal;
    bends_ = &bends_of_[std::size_t(reach_ - 1)];
    bends_->start_query(*map_);
    ray_.start_query(regions, options, pinched);
    notes_entered_ = bool(options.opened_after);
}

std::span<const Reached> Fan::look(const Viewpoint& from, bool alternatives) {
    from_ = from;
    ellipse_ = Ellipse(from.at, goal_, from.range);
    aims_.clear();  // of a look that was interrupted
    reached_.clear();
    entered_.clear();
    fronts_.resize(1);
    ray_.set_open(from.open);
    if (!from.arriving) {
        sector_ = {};
        begin_look();
        if (!look_at_goal() || alternatives) look_into(sector_);
        return reached_;
    }
    for (const Step quadrant : quadrants) {
        const Step slide = sliding(*from.arriving, quadrant);
        if (slide == Step{}) continue;
        const std::optional<Corner> corner = corner_at(from.at, quadrant);
        if (!corner) continue;
        sector_ = {*from.arriving, slide, sign(cross(*from.arriving, slide)), *corner};
        begin_look();
        if (sector_.holds(goal_ - from.at) && look_at_goal() && !alternatives) return reached_;
        look_into(sector_);
    }
    return reached_;
}

void Fan::begin_look() {
    ++look_;
    visited_.clear();
}

// True if the goal is in reach.
bool Fan::look_at_goal() {
    aims_.clear();
    const Step direction = goal_ - from_.at;
    const std::size_t before = reached_.size();
    if (cast(direction, 1)) reach(goal_, 1);
    for (const Hit& hit : ray_.hits()) scan_from({hit.region, hit.cell, hit.side}, direction, 0);
    return reached_.size() > before;
}

void Fan::look_into(const Sector& sector) {
    if (sector.turn != 0) {
        if (from_.ahead) {
            for (const Front& front : *from_.ahead) scan_from(front, sector.straight, sector.turn);
        } else {
            look_along(sector.straight, sector.turn);
        }
        const Step outward = sector.sliding + -sector.around.quadrant;
        const Outline outline(*map_, reach_, sector.around.region);
        // Along the obstacle's own side. Where that ends at a corner, the ray to it is the sector's border.
        if (!scan(outline, {sector.around.cell, outward, sector.sliding}, -sector.turn))
            look_along(sector.sliding, -sector.turn);
    }
    while (!aims_.empty() && !interrupt_->due()) {
        const Aim aim = aims_.back();
        aims_.pop_back();
        look_at(aim);
    }
}

// Looks along a border of the sector: regions that it hits are followed into the sector only.
void Fan::look_along(Step direction, int into) {
    cast(direction, times_in_range(direction));
    for (const Hit& hit : ray_.hits()) scan_from({hit.region, hit.cell, hit.side}, direction, into);
}

void Fan::look_at(const Aim& aim) {
    if (aim.at == from_.at) return;  // a corner that it stands at
    const Step direction = aim.at - from_.at;
    const int times = times_in_range(direction);
    const double share = 1.0 / times;
    cast(direction, times);
    if (ray_.reaches(share)) {
        const std::size_t before = reached_.size();
        reach(aim.at, share);
        if (reached_.size() > before && ray_.squeezes().empty()) keep_ahead(share);
    }
    // Regions behind the corner are followed to its open side only.
    for (const Hit& hit : ray_.hits())
        scan_from({hit.region, hit.cell, hit.side}, direction, hit.at < share ? 0 : aim.open);
}

// True if nothing stops the ray.
bool Fan::cast(Step direction, int times) {
    const Vertex end{from_.at.x + direction.x * times, from_.at.y + direction.y * times};
    const bool free = ray_.cast(from_.at, end, from_.crossings, from_.weight);
    if (notes_entered_) note_entered(length(end - from_.at));
    return free;
}

void Fan::note_entered(double length) {
    in_order_.assign(ray_.hits().begin(), ray_.hits().end());
    std::ranges::stable_sort(in_order_, {}, &Hit::at);
    passed_.clear();
    bool first = true;
    for (const Hit& hit : in_order_) {
        const std::size_t before = passed_.size();
        ray_.add_missing(hit.region, passed_);
        if (ray_.solid(hit.region) || !affords(passed_)) return;
        entered_.push_back({hit.region, hit.at * length, hit.surely, first});
        first = false;
        if (!hit.surely) passed_.resize(before);
    }
}

// How often the step fits until it has left the ellipse, or the map.
int Fan::times_in_range(Step direction) const {
    const int step = std::max(std::abs(direction.x), std::abs(direction.y));
    const double across_map = 2.0 * std::max(map_->width(), map_->height()) / step;
    return int(std::min(ellipse_.times(direction), across_map)) + 1;
}

// Keeps what the ray met beyond the vertex reached last: a path that goes straight on meets the same.
void Fan::keep_ahead(double share) {
    reached_.back().fronts_begin = std::uint32_t(fronts_.size());
    for (const Hit& hit : ray_.hits()) {
        if (hit.at >= share) fronts_.push_back({hit.region, hit.cell, hit.side});
    }
    reached_.back().fronts_end = std::uint32_t(fronts_.size());
}

std::optional<std::span<const Front>> Fan::ahead(const Reached& reached) const {
    if (reached.fronts_begin == 0) return std::nullopt;
    return std::span(fronts_.data() + reached.fronts_begin, fronts_.data() + reached.fronts_end);
}

// Follows the outline of a region that a ray has hit, both ways or to one side only.
void Fan::scan_from(Front front, Step direction, int only) {
    const Outline outline(*map_, reach_, front.region);
    if (outline.owns(front.cell + front.side)) {  // it was entered at a concave corner, through two boxes at once
        front.cell = front.cell + front.side;
        front.side = front.side.x != 0 ? Step{0, -sign(direction.y)} : Step{-sign(direction.x), 0};
    }
    for (const Step along : {Step{front.side.y, front.side.x}, Step{-front.side.y, -front.side.x}}) {
        const int turn = sign(cross(direction, along));
        if (only != 0 && turn == -only) continue;
        if (turn != 0) {
            scan(outline, {front.cell, front.side, along}, turn);
        } else if (sign(along.x) == -sign(direction.x) && sign(along.y) == -sign(direction.y)) {
            scan(outline, {front.cell, front.side, along},
                 sign(cross(direction, -front.side)));  // it lies along the ray
        }
    }
}

// Follows an outline as seen from the viewpoint, away from the ray that hit it to the side of `turn`, up to the corner
// that ends the visible front, which it notes, or to the border of the sector or the ellipse. Convex corners on the way
// lead into pockets of the front, from which no shortest path comes out again. True if the first bend is a corner.
bool Fan::scan(const Outline& outline, const Side& side, int turn) {
    Bends& bends = *bends_;
    const std::uint32_t first = bends.ahead(outline, side);
    std::uint32_t at = first;
    do {
        Bend& bend = bends[at];
        const Step arriving = bend.at - from_.at;
        if (arriving != Step{}) {
            if (!sector_.holds(arriving) || !ellipse_.holds(bend.at) || bend.seen == look_) break;
            bend.seen = look_;
            if (bend.quadrant != Step{} && sign(cross(arriving, sliding(arriving, bend.quadrant))) == -turn) {
                const std::optional<std::uint32_t> back = behind_notch(outline, at, turn);
                if (!back) {
                    note(bends[at].at, turn);
                    break;
                }
                at = *back;
                continue;
            }
        }
        at = bends.next(outline, at);
    } while (at != first);
    return bends[first].quadrant != Step{};
}

// Finds a corner that the outline hides in a notch of its own as soon as it is passed: a path that bends around it gets
// nowhere. Returns the bend where the outline comes back into view, if it does so soon.
std::optional<std::uint32_t> Fan::behind_notch(const Outline& outline, std::uint32_t corner, int turn) {
    const Vertex start = (*bends_)[corner].at;
    const Step passing = start - from_.at;
    Bounds notch;
    notch.add(start);
    std::uint32_t at = corner;
    for (int bends = 0; bends < tuning::longest_notch; ++bends) {
        at = bends_->next(outline, at);
        const Vertex end = (*bends_)[at].at;
        const Step beyond = end - start;
        if (std::int64_t(beyond.x) * passing.x + std::int64_t(beyond.y) * passing.y < 0) return std::nullopt;
        notch.add(end);
        if (bends > 0 && sign(cross(passing, end - from_.at)) * turn >= 0) {
            if (notch.hold(goal_) || !clear(start, end)) return std::nullopt;
            return at;
        }
    }
    return std::nullopt;
}

// Whether nothing that stands is between two near vertices.
bool Fan::clear(Vertex a, Vertex b) const {
    const int reach = reach_;
    const Step step = b - a;
    if (reach == 1 && (step.x == 0 || step.y == 0)) return false;  // along cell edges: a ray knows
    const auto first = [reach](int low) { return int(floor_divide(low - reach, 2)) + 1; };
    const auto last = [reach](int high) { return int(floor_divide(high + reach - 1, 2)); };
    const Cell min{first(std::min(a.x, b.x)), first(std::min(a.y, b.y))};
    const Cell max{last(std::max(a.x, b.x)), last(std::max(a.y, b.y))};
    if (max.x - min.x > tuning::widest_notch || max.y - min.y > tuning::widest_notch) return false;
    const std::int64_t width = std::int64_t(reach) * (std::abs(step.x) + std::abs(step.y));
    for (Cell c = min; c.y <= max.y; ++c.y) {
        for (c.x = min.x; c.x <= max.x; ++c.x) {
            if (!map_->grid().blocked(c)) continue;
            if (std::abs(cross(step, centre(c) - a)) >= width) continue;
            if (!map_->grid().contains(c) || !ray_.open(region_at(*map_, c))) return false;
        }
    }
    return !ray_.pinched(a, b);
}

void Fan::note(Vertex corner, int open) {
    if (!visited_.before(corner, open > 0 ? 1 : 0)) aims_.push_back({corner, open});
}

// The corner of a standing obstacle that fills that quadrant of the vertex, if there is one to bend around.
std::optional<Corner> Fan::corner_at(Vertex v, Step quadrant) const {
    const bool square = reach_ == 2;
    const Cell cell = square ? Cell{v.x / 2 + quadrant.x, v.y / 2 + quadrant.y}
                             : Cell{(v.x + quadrant.x) / 2, (v.y + quadrant.y) / 2};
    if (!map_->grid().blocked(cell) || !map_->grid().contains(cell)) return std::nullopt;
    const RegionId region = region_at(*map_, cell);
    if (ray_.open(region)) return std::nullopt;
    const Outline outline(*map_, reach_, region);
    if (outline.owns(cell + Step{-quadrant.x, 0}) || outline.owns(cell + Step{0, -quadrant.y})) return std::nullopt;
    if (square && outline.owns(cell + -quadrant)) return std::nullopt;
    return Corner{quadrant, cell, region};
}

bool Fan::bends(Vertex v, std::span<const ObstacleId> crossed) const {
    return std::any_of(quadrants.begin(), quadrants.end(), [&](Step quadrant) {
        if (sliding(v - from_.at, quadrant) == Step{}) return false;
        const std::optional<Corner> corner = corner_at(v, quadrant);
        return corner && !ray_.opens(corner->region, crossed);
    });
}

void Fan::reach(Vertex v, double share) {
    std::vector<ObstacleId> crossed;
    for (const Hit& hit : ray_.hits()) {
        if (hit.surely && hit.at < share) ray_.add_missing(hit.region, crossed);
    }
    choices_.clear();
    for (const Squeeze& pair : ray_.squeezes()) {
        if (pair.at < share) choices_.push_back(pair);
    }
    const auto matters = [&](const Squeeze& pair) { return !left(pair.one, v) || !left(pair.other, v); };
    const auto rest = std::stable_partition(choices_.begin(), choices_.end(), matters);
    choose(v, 0, std::size_t(rest - choices_.begin()), crossed);
}

// Whether a path that goes on from v never meets what stands in the region again.
bool Fan::left(RegionId region, Vertex v) const {
    bool left = convex_ != nullptr;
    if (left && ray_.solid(region)) return true;
    regions_->for_each_member(region, [&](ObstacleId obstacle) { left = left && convex_->left(obstacle, v); });
    return left;
}

// Reaches v once for each choice between the two obstacles of a squeeze. From the choice `rest` on, only how much is
// crossed matters.
void Fan::choose(Vertex v, std::size_t next, std::size_t rest, std::vector<ObstacleId>& crossed) {
    if (!affords(crossed)) return;
    if (next == rest) least_.clear();
    if (next >= rest && is_beaten(next, crossed)) return;
    if (next == choices_.size()) {
        if (v == goal_ || bends(v, crossed)) reached_.push_back({v, crossed});
        if (convex_ != nullptr) least_.push_back(sum_of(crossed));
        return;
    }
    const Squeeze pair = choices_[next];
    if (ray_.opens(pair.one, crossed) || ray_.opens(pair.other, crossed)) {
        choose(v, next + 1, rest, crossed);
        return;
    }
    for (const RegionId region : {pair.one, pair.other}) {
        if (ray_.solid(region)) continue;
        const std::size_t before = crossed.size();
        ray_.add_missing(region, crossed);
        choose(v, next + 1, rest, crossed);
        crossed.resize(before);
    }
}

// Whether some choice crosses no more than any that goes on from this one.
bool Fan::is_beaten(std::size_t next, std::span<const ObstacleId> crossed) {
    if (least_.empty()) return false;
    Sum sum = sum_of(crossed);
    // Each squeeze that shares no obstacle with those before needs one more.
    members_.assign(crossed.begin(), crossed.end());
    for (const Squeeze& pair : std::span(choices_).subspan(next)) {
        if (ray_.opens(pair.one, members_) || ray_.opens(pair.other, members_)) continue;
        ++sum.count;
        if (!ray_.solid(pair.one)) ray_.add_missing(pair.one, members_);
        if (!ray_.solid(pair.other)) ray_.add_missing(pair.other, members_);
    }
    return std::ranges::any_of(
        least_, [&](const Sum& least) { return least.count <= sum.count && least.weight <= sum.weight; });
}

Fan::Sum Fan::sum_of(std::span<const ObstacleId> obstacles) const {
    Sum sum{obstacles.size()};
    for (const ObstacleId obstacle : obstacles) sum.weight += ray_.weight(obstacle);
    return sum;
}

// Whether so much may still be crossed.
bool Fan::affords(std::span<const ObstacleId> obstacles) const {
    const Sum sum = sum_of(obstacles);
    return int(sum.count) <= from_.crossings && sum.weight <= from_.weight;
}

}  // namespace waybreaker::crossing
