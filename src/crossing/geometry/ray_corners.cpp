// Rays of a body that is too wide to pass between two cells that touch at a corner: docs/exact.md, the relaxed body.
#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <vector>

#include "crossing/geometry/ray.hpp"

namespace waybreaker::crossing {
namespace {

// Calls visit(corner, step, share) for the corners of cells that a segment passes, the one that it ends at included:
// the step from one integer place to the next, and the share of the segment. Until that says false.
template <class Visit>
void for_each_corner(Vertex from, Step step, Visit visit) {
    const int parts = std::gcd(step.x, step.y);
    const Step part{step.x / parts, step.y / parts};
    const bool at_corner = from.x % 2 != 0;
    if (!at_corner && (part.x % 2 == 0 || part.y % 2 == 0)) return;
    for (int k = at_corner ? 2 : 1; k <= parts; k += 2) {
        if (!visit(Vertex{from.x + k * part.x, from.y + k * part.y}, part, double(k) / parts)) return;
    }
}

}  // namespace

void Ray::pass_corners(Vertex from, Step step, Price left) {
    left_at_pinch_ = left;
    counted_.clear();
    to_count_.assign(hits_.begin(), hits_.end());
    std::erase_if(to_count_, [](const Hit& hit) { return !hit.surely; });
    std::ranges::sort(to_count_, [](const Hit& a, const Hit& b) { return comes_first(b, a); });
    for_each_corner(from, step, [&](Vertex corner, Step part, double at) {
        if (stopped_ && at >= stopped_at_) return false;
        constexpr double before = 1 - 1e-10;  // what begins at the corner comes after it
        visit_corner(corner, part, before * at);
        return true;
    });
    constexpr double at_the_corner = 1 + 1e-9;
    if (stopped_) std::erase_if(hits_, [&](const Hit& hit) { return hit.at > stopped_at_ * at_the_corner; });
}

// Counts the obstacles that must go for a region, but for those that may have been counted before.
void Ray::count(RegionId region) {
    regions_->for_each_member(region, [&](ObstacleId obstacle) {
        if (obstacle_marks_[obstacle.value].open == opening_) return;
        if (std::ranges::find(counted_, obstacle) != counted_.end()) return;
        counted_.push_back(obstacle);
        --left_at_pinch_.crossings;
        left_at_pinch_.weight -= weight(obstacle);
    });
}

void Ray::count_hits(double before) {
    for (; !to_count_.empty() && to_count_.back().at < before; to_count_.pop_back()) count(to_count_.back().region);
}

// Counts one obstacle more for a pair of regions of which one must go, the lightest of them, unless they share any with
// what was counted before.
void Ray::count_pinch(const Hit& one, const Hit& other) {
    count_hits(one.at);
    const std::size_t before = counted_.size();
    double least = infinity;
    bool shares = false;
    for (const RegionId region : {one.region, other.region}) {
        regions_->for_each_member(region, [&](ObstacleId obstacle) {
            if (obstacle_marks_[obstacle.value].open == opening_) return;
            const auto known = std::ranges::find(counted_, obstacle);
            shares = shares || known - counted_.begin() < std::ptrdiff_t(before);
            if (known == counted_.end()) counted_.push_back(obstacle);
            least = std::min(least, weight(obstacle));
        });
    }
    if (shares) {
        counted_.resize(before);
    } else {
        --left_at_pinch_.crossings;
        left_at_pinch_.weight -= least;
    }
}

bool Ray::pinched(Vertex from, Vertex to) const {
    bool found = false;
    if (!pinched_) return found;
    for_each_corner(from, to - from, [&](Vertex corner, Step part, double at) {
        if (at == 1) return false;
        Hit hit;
        const int x = sign(part.x);
        const int y = sign(part.y);
        found = look_beside(corner, {x, -y}, {}, hit) && look_beside(corner, {-x, y}, {}, hit);
        return !found;
    });
    return found;
}

// The cell around a corner that the signs point to, and the side of it that the ray comes to. False if nothing stands
// there.
bool Ray::look_beside(Vertex corner, Step cell, Step side, Hit& hit) const {
    hit.cell = {(corner.x + cell.x) / 2, (corner.y + cell.y) / 2};
    hit.side = side;
    if (!map_->grid().blocked(hit.cell) || !map_->grid().contains(hit.cell)) return false;
    hit.region = region_at(*map_, hit.cell);
    return !open(hit.region);
}

void Ray::visit_corner(Vertex corner, Step step, double at) {
    const int x = sign(step.x);
    const int y = sign(step.y);
    Hit one;
    Hit other;
    one.at = other.at = at;
    const auto stand = [&](Step first, Step side_of_first, Step second, Step side_of_second) {
        return look_beside(corner, first, side_of_first, one) && look_beside(corner, second, side_of_second, other);
    };
    if (x != 0 && y != 0) {
        if (stand({x, -y}, {-x, 0}, {-x, y}, {0, -y})) pinch(one, other);
        return;
    }
    for (const int across : {-1, 1}) {  // along an edge: from the one side of it to the other
        const Step behind = x != 0 ? Step{-x, across} : Step{across, -y};
        const Step along = x != 0 ? Step{0, -across} : Step{-across, 0};
        if (stand(behind, along, -behind, {-x, -y})) pinch(one, other);
    }
}

// Counts no more than the cheaper of the two regions, so the ray may get farther than a path.
void Ray::pinch(const Hit& one, const Hit& other) {
    const auto note = [&](Hit hit, bool surely) {
        hit.surely = surely;
        RegionMark& mark = region_marks_[hit.region.value];
        if (mark.ray != ray_ || surely) {
            mark.ray = ray_;
            mark.hit = std::uint32_t(hits_.size());
        }
        hits_.push_back(hit);
    };
    if (one.region != other.region) {
        squeezes_.push_back({one.region, other.region, one.at});
        note(one, false);
        note(other, false);
        count_pinch(one, other);
        const bool too_much = left_at_pinch_.crossings < 0 || left_at_pinch_.weight < 0;
        if (too_much || (solid(one.region) && solid(other.region))) stop(one.at);
        return;
    }
    const RegionMark& mark = region_marks_[one.region.value];
    if (mark.ray == ray_ && hits_[mark.hit].surely) {
        Hit& known = hits_[mark.hit];
        if (known.at <= one.at) return;
        known = one;
    } else {
        note(one, true);
    }
    note(other, false);
    count_hits(one.at);
    count(one.region);
    if (left_at_pinch_.crossings < 0 || left_at_pinch_.weight < 0 || solid(one.region)) stop(one.at);
}

}  // namespace waybreaker::crossing
