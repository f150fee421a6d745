#include "crossing/fan.hpp"

#include <algorithm>
#include <cstdlib>

namespace waybreaker {

void Fan::start_query(const Map& map, Body body, Vertex goal, std::span<const ObstacleId> protect,
                      std::span<const double> weights) {
    map_ = &map;
    body_ = body;
    goal_ = goal;
    ray_.start_query(map, body, protect, weights);
}

std::span<const Reached> Fan::look(const Viewpoint& from, bool alternatives) {
    from_ = from;
    ellipse_ = Ellipse(from.at, goal_, from.range);
    reached_.clear();
    ray_.set_open(from.open);
    if (!from.arriving) {
        sector_ = {};
        done_.clear();
        if (!look_at_goal() || alternatives) look_into(sector_);
        return reached_;
    }
    for (const Step quadrant : quadrants) {
        const Step slide = sliding(*from.arriving, quadrant);
        if (slide == Step{}) continue;
        const std::optional<Corner> corner = corner_at(from.at, quadrant);
        if (!corner) continue;
        sector_ = {*from.arriving, slide, sign(cross(*from.arriving, slide)), *corner};
        done_.clear();
        if (sector_.holds(goal_ - from.at) && look_at_goal() && !alternatives) return reached_;
        look_into(sector_);
    }
    return reached_;
}

// True if the goal is in reach.
bool Fan::look_at_goal() {
    aims_.clear();
    const Step direction = goal_ - from_.at;
    ray_.start(from_.crossings, from_.weight);
    const std::size_t before = reached_.size();
    if (ray_.walk(from_.at, goal_)) reach(goal_);
    scan_from_hits(direction);
    return reached_.size() > before;
}

void Fan::look_into(const Sector& sector) {
    if (sector.turn != 0) {
        look_along(sector.straight, sector.turn);
        const Step outward = sector.sliding + -sector.around.quadrant;
        const Outline outline(*map_, body_, sector.around.obstacle);
        // Along the obstacle's own side. Where that ends at a corner, the ray to it is the sector's border.
        if (!scan(outline, {sector.around.cell, outward, sector.sliding}, -sector.turn))
            look_along(sector.sliding, -sector.turn);
    }
    while (!aims_.empty()) {
        const Aim aim = aims_.back();
        aims_.pop_back();
        look_at(aim);
    }
}

// A border of the sector: what it hits is followed into the sector only.
void Fan::look_along(Step direction, int into) {
    ray_.start(from_.crossings, from_.weight);
    walk_on(from_.at, direction);
    scan_from_hits(direction, into);
}

void Fan::look_at(const Aim& aim) {
    if (aim.at == from_.at) return;  // a corner that it stands at
    const Step direction = aim.at - from_.at;
    ray_.start(from_.crossings, from_.weight);
    if (ray_.walk(from_.at, aim.at)) {
        reach(aim.at);
        walk_on(aim.at, direction);
    }
    scan_from_hits(direction, aim.open, 1);
}

// On to where the ray leaves the ellipse, or the map.
void Fan::walk_on(Vertex from, Step direction) {
    const double step = length(direction);
    const double across_map = 2.0 * (map_->width() + map_->height());
    const double range = std::min(ellipse_.range(direction), across_map) - length(from - from_.at);
    if (range <= 0) return;
    const int steps = int(range / step) + 1;
    ray_.walk(from, {from.x + direction.x * steps, from.y + direction.y * steps});
}

// Both ways along the outline of all that the ray has hit; to one side only, if so, of what it hit after some legs.
void Fan::scan_from_hits(Step direction, int only, int only_behind) {
    for (const Hit& hit : ray_.hits()) {
        const Outline outline(*map_, body_, hit.obstacle);
        Cell cell = hit.cell;
        Step side = hit.side;
        if (outline.owns(cell + side)) {  // it was entered at a concave corner, through two boxes at once
            cell = cell + side;
            side = side.x != 0 ? Step{0, -sign(direction.y)} : Step{-sign(direction.x), 0};
        }
        for (const Step along : {Step{side.y, side.x}, Step{-side.y, -side.x}}) {
            const int turn = sign(cross(direction, along));
            if (turn == -only && (only_behind == 0 || hit.leg > only_behind)) continue;
            if (turn != 0) {
                scan(outline, {cell, side, along}, turn);
            } else if (sign(along.x) == -sign(direction.x) && sign(along.y) == -sign(direction.y)) {
                scan(outline, {cell, side, along}, sign(cross(direction, -side)));  // it lies along the ray
            }
        }
    }
}

// Follows an outline as seen from the viewpoint, away from the ray that hit it to the side of `turn`, and notes the
// corners it could be passed at: up to the first one that ends the visible front, the sector or the ellipse. True if
// the first bend is such a corner.
bool Fan::scan(const Outline& outline, Side side, int turn) {
    const Side first = side;
    bool first_is_corner = false;
    bool first_bend = true;
    do {
        const Outline::Turn kind = outline.turn(side);
        Side next = outline.next(side, kind);
        if (kind != Outline::Turn::straight) {
            const Vertex bend = outline.bend(side, kind);
            const Step arriving = bend - from_.at;
            if (first_bend) first_is_corner = kind == Outline::Turn::away;
            first_bend = false;
            if (arriving != Step{}) {
                if (!sector_.holds(arriving) || !ellipse_.holds(bend) || passed(bend, side, kind)) break;
                if (kind == Outline::Turn::away) {
                    const Step slide = sliding(arriving, -(side.along + side.outward));
                    const int bending = sign(cross(arriving, slide));
                    if (bending == -turn) {
                        const std::optional<Side> back = behind_notch(outline, next, arriving, turn);
                        if (!back) {
                            note(bend, turn);
                            break;
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
    return first_is_corner;
}

// A corner that the outline hides in a notch of its own as soon as it is passed: what bends around it gets nowhere. The
// side where the outline comes back into view, if it does so soon.
std::optional<Side> Fan::behind_notch(const Outline& outline, Side side, Step corner, int turn) const {
    constexpr int longest = 8;  // bends
    const auto ahead = [corner](Step step) {
        const Step beyond = step + -corner;
        return std::int64_t(beyond.x) * corner.x + std::int64_t(beyond.y) * corner.y >= 0;
    };
    Step min = corner;
    Step max = corner;
    for (int bends = 0; bends < longest;) {
        const Outline::Turn kind = outline.turn(side);
        if (kind != Outline::Turn::straight) {
            const Step bend = outline.bend(side, kind) - from_.at;
            if (!ahead(bend)) return std::nullopt;
            min = {std::min(min.x, bend.x), std::min(min.y, bend.y)};
            max = {std::max(max.x, bend.x), std::max(max.y, bend.y)};
            if (bends > 0 && sign(cross(corner, bend)) * turn >= 0) {
                const Step goal = goal_ - from_.at;
                const bool holds_goal = goal.x >= min.x && goal.x <= max.x && goal.y >= min.y && goal.y <= max.y;
                if (holds_goal || !clear(from_.at + corner, from_.at + bend)) return std::nullopt;
                return side;
            }
            ++bends;
        }
        side = outline.next(side, kind);
    }
    return std::nullopt;
}

// Whether nothing that stands is between two near vertices.
bool Fan::clear(Vertex a, Vertex b) const {
    constexpr int near = 16;  // cells
    const int reach = reach_of(body_);
    const Step step = b - a;
    if (reach == 1 && (step.x == 0 || step.y == 0)) return false;  // along cell edges: a ray knows
    const auto first = [reach](int low) { return int(floor_divide(low - reach, 2)) + 1; };
    const auto last = [reach](int high) { return int(floor_divide(high + reach - 1, 2)); };
    const Cell min{first(std::min(a.x, b.x)), first(std::min(a.y, b.y))};
    const Cell max{last(std::max(a.x, b.x)), last(std::max(a.y, b.y))};
    if (max.x - min.x > near || max.y - min.y > near) return false;
    const std::int64_t width = std::int64_t(reach) * (std::abs(step.x) + std::abs(step.y));
    for (Cell c = min; c.y <= max.y; ++c.y) {
        for (c.x = min.x; c.x <= max.x; ++c.x) {
            if (!map_->grid().blocked(c)) continue;
            if (std::abs(cross(step, centre(c) - a)) >= width) continue;
            if (!map_->grid().contains(c) || !ray_.open(map_->obstacle_at(c).value)) return false;
        }
    }
    return true;
}

// Whether this look has followed the outline from here before; from now on it has.
bool Fan::passed(Vertex bend, const Side& side, Outline::Turn kind) {
    // A bend, the side before it and the way the side is followed name one corner of one cell.
    const int outward = side.outward.x != 0 ? side.outward.x + 1 : side.outward.y + 2;  // 0 to 3
    const int along = side.along.x + side.along.y > 0 ? 1 : 0;
    const int concave = kind == Outline::Turn::back ? 1 : 0;
    return done_.before(bend, unsigned(4 * outward + 2 * along + concave));
}

void Fan::note(Vertex corner, int open) {
    if (!done_.before(corner, open > 0 ? 16 : 17)) aims_.push_back({corner, open});
}

// The corner of a standing obstacle that fills that quadrant of the vertex, if there is one to bend around.
std::optional<Corner> Fan::corner_at(Vertex v, Step quadrant) const {
    const bool square = body_ == Body::square;
    const Cell cell = square ? Cell{v.x / 2 + quadrant.x, v.y / 2 + quadrant.y}
                             : Cell{(v.x + quadrant.x) / 2, (v.y + quadrant.y) / 2};
    if (!map_->grid().blocked(cell) || !map_->grid().contains(cell)) return std::nullopt;
    const std::uint32_t obstacle = map_->obstacle_at(cell).value;
    if (ray_.open(obstacle)) return std::nullopt;
    const Outline outline(*map_, body_, obstacle);
    if (outline.owns(cell + Step{-quadrant.x, 0}) || outline.owns(cell + Step{0, -quadrant.y})) return std::nullopt;
    if (square && outline.owns(cell + -quadrant)) return std::nullopt;
    return Corner{quadrant, cell, obstacle};
}

bool Fan::bends(Vertex v, std::span<const std::uint32_t> crossed) const {
    return std::any_of(quadrants.begin(), quadrants.end(), [&](Step quadrant) {
        if (sliding(v - from_.at, quadrant) == Step{}) return false;
        const std::optional<Corner> corner = corner_at(v, quadrant);
        return corner && std::find(crossed.begin(), crossed.end(), corner->obstacle) == crossed.end();
    });
}

void Fan::reach(Vertex v) {
    std::vector<std::uint32_t> crossed;
    for (const Hit& hit : ray_.hits()) {
        if (hit.surely) crossed.push_back(hit.obstacle);
    }
    reach(v, 0, crossed);
}

// Once for each choice between the two obstacles of a squeeze.
void Fan::reach(Vertex v, std::size_t squeeze, std::vector<std::uint32_t>& crossed) {
    double weight = 0;
    for (const std::uint32_t obstacle : crossed) weight += ray_.weight(obstacle);
    if (int(crossed.size()) > from_.crossings || weight > from_.weight) return;
    if (squeeze == ray_.squeezes().size()) {
        if (v == goal_ || bends(v, crossed)) reached_.push_back({v, crossed});
        return;
    }
    const auto has = [&crossed](std::uint32_t obstacle) {
        return std::find(crossed.begin(), crossed.end(), obstacle) != crossed.end();
    };
    const Squeeze pair = ray_.squeezes()[squeeze];
    if (has(pair.one) || has(pair.other)) {
        reach(v, squeeze + 1, crossed);
        return;
    }
    for (const std::uint32_t obstacle : {pair.one, pair.other}) {
        if (ray_.solid(obstacle)) continue;
        crossed.push_back(obstacle);
        reach(v, squeeze + 1, crossed);
        crossed.pop_back();
    }
}

}  // namespace waybreaker
