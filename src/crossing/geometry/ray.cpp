#include "crossing/geometry/ray.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdlib>
#include <new>

#include "crossing/geometry/stairs.hpp"
#include "map/bit_run.hpp"

namespace waybreaker::crossing {
void Ray::Free::operator()(void* memory) const {
    std::free(memory);
}

void Ray::start_query(const Regions& regions, const CrossingOptions& options, bool pinched) {
    regions_ = &regions;
    map_ = &regions.map();
    touching_ = map_->obstacles_touch();
    pinched_ = pinched;
    reach_ = reach_of(options);
    weighs_ = options.budget < infinity;
    prices_ = weighs_ ? std::span<const double>() : options.prices;
    allows_some_ = !options.only.empty();
    passes_destructible_ = false;
    rows_ = &map_->grid();
    columns_ = &map_->transposed();
    const std::size_t region_limit = regions.count() + 1;
    const std::size_t obstacle_limit = regions.obstacle_limit();
    // Fresh pages are zero and cost nothing until used: a big map costs no more than what the rays see of it.
    if (region_limit > region_limit_ || obstacle_limit > obstacle_limit_ || query_ > UINT32_MAX / 2 ||
        opening_ > UINT32_MAX / 2 || ray_ > UINT32_MAX / 2) {
        region_marks_.reset(static_cast<RegionMark*>(std::calloc(region_limit, sizeof(RegionMark))));
        obstacle_marks_.reset(static_cast<ObstacleMark*>(std::calloc(obstacle_limit, sizeof(ObstacleMark))));
        if (!region_marks_ || !obstacle_marks_) throw std::bad_alloc();
        region_limit_ = region_limit;
        obstacle_limit_ = obstacle_limit;
        query_ = opening_ = ray_ = 0;
    }
    ++query_;
    for (const ObstacleId id : options.protect) obstacle_marks_[id.value].protect = query_;
    for (const ObstacleId id : options.only) obstacle_marks_[id.value].allow = query_;
}

void Ray::pass_destructible() {
    passes_destructible_ = true;
    rows_ = &regions_->permanent().rows;
    columns_ = &regions_->permanent().columns;
}

void Ray::set_open(std::span<const ObstacleId> obstacles) {
    ++opening_;
    for (const ObstacleId obstacle : obstacles) obstacle_marks_[obstacle.value].open = opening_;
    for (const ObstacleId obstacle : obstacles) {
        regions_->for_each_region_of(obstacle, [&](RegionId region) {
            bool open = true;
            regions_->for_each_member(region,
                                      [&](ObstacleId o) { open = open && obstacle_marks_[o.value].open == opening_; });
            if (open) region_marks_[region.value].open = opening_;
        });
    }
}

bool Ray::cast(Vertex from, Vertex to, int crossings, double weight) {
    ++ray_;
    hits_.clear();
    squeezes_.clear();
    crossings_left_ = crossings;
    weight_left_ = weight;
    stopped_ = false;
    stopped_at_ = infinity;
    const int dx = to.x - from.x;
    const int dy = to.y - from.y;
    const Frame frame = std::abs(dx) >= std::abs(dy) ? Frame{rows_, false, from.x, from.y, dx, dy}
                                                     : Frame{columns_, true, from.y, from.x, dy, dx};
    const bool along_edge = frame.dy == 0 && reach_ == 1 && frame.y % 2 != 0;
    if (along_edge) {
        walk_edge(frame);
    } else {
        walk_line(frame);
    }
    if (pinched_) pass_corners(from, to - from, {crossings, weight});
    return !stopped_;
}

// The segment enters the open box around cell (c, row) iff it does so while |y - 2 row| < reach, and in that part of it
// x comes nearer than reach to 2c: one interval of c for each row.
void Ray::walk_line(const Frame& f) {
    const int down = f.dy < 0 ? -1 : 1;
    const std::int64_t y = std::int64_t(down) * f.y;  // rows are counted in the direction of travel
    const std::int64_t dy = std::int64_t(down) * f.dy;
    const std::int64_t low_x = std::min(f.x, f.x + f.dx);
    const std::int64_t high_x = std::max(f.x, f.x + f.dx);
    // Up to the frame, which stops every ray.
    const std::int64_t first = std::max<std::int64_t>(floor_divide(low_x - reach_, 2) + 1, -1);
    const std::int64_t last = std::min<std::int64_t>(floor_divide(high_x + reach_ - 1, 2), f.grid->width());
    const std::int64_t first_row = floor_divide(y - reach_, 2) + 1;
    const std::int64_t last_row = floor_divide(y + dy + reach_ - 1, 2);
    if (dy == 0) {
        visit_run(f, int(first_row), first, last);
        return;
    }
    // Where the segment crosses the row's near and far border.
    const std::int64_t near_y = 2 * first_row - reach_ - y;
    const std::int64_t far_y = 2 * first_row + reach_ - y;
    const std::int64_t low_y = f.dx > 0 ? near_y : far_y;
    const std::int64_t high_y = f.dx > 0 ? far_y : near_y;
    Stairs low((f.x - reach_) * dy + low_y * f.dx, 2 * std::int64_t(f.dx), 2 * dy);
    Stairs high((f.x + reach_) * dy + high_y * f.dx - 1, 2 * std::int64_t(f.dx), 2 * dy);
    const std::uint64_t* words = f.grid->row(int(down * first_row));
    const std::ptrdiff_t next_row = down * std::ptrdiff_t(f.grid->words_per_row());
    bool stopped = stopped_;
    for (std::int64_t row = first_row; row <= last_row; ++row, low.next(), high.next(), words += next_row) {
        const std::int64_t from = std::max(first, low.value() + 1);
        const std::int64_t to = std::min(last, high.value());
        if (!stopped && (from > to || !any_bit(words, unsigned(from + 1), unsigned(to + 1)))) continue;
        visit_run(f, int(down * row), from, to);
        // Boxes of the next row can begin before the end of this row's: one row more settles what was entered first.
        if (stopped_ && (stopped || reach_ == 1)) return;
        stopped = stopped_;
    }
}

// The blocked cells among first..last of a row, in the direction of travel; of cells that are known to belong together
// the first alone.
void Ray::visit_run(const Frame& f, int row, std::int64_t first, std::int64_t last) {
    if (first > last || row < -1 || row > f.grid->height()) return;  // nothing, or behind the map's edge
    const bool leaves = first < 0 || last >= f.grid->width();
    first = std::max<std::int64_t>(first, 0);
    last = std::min<std::int64_t>(last, f.grid->width() - 1);
    if (first <= last) {
        if (f.dx >= 0) {
            visit_rightwards(f, row, std::size_t(first + 1), std::size_t(last + 1));
        } else {
            visit_leftwards(f, row, std::size_t(first + 1), std::size_t(last + 1));
        }
    }
    if (leaves) visit_cell(f, f.dx >= 0 ? f.grid->width() : -1, row);
}

void Ray::visit_rightwards(const Frame& f, int row, std::size_t from, std::size_t to) {
    const std::uint64_t* words = f.grid->row(row);
    const bool was_stopped = stopped_;
    for (std::size_t word = from / 64; word <= to / 64; ++word) {
        std::uint64_t bits = words[word];
        if (word == from / 64) bits &= ~std::uint64_t{0} << (from % 64);
        if (word == to / 64) bits &= ~std::uint64_t{0} >> (63 - to % 64);
        while (bits != 0) {
            visit_cell(f, int(word * 64) + std::countr_zero(bits) - 1, row);
            if (stopped_ && !was_stopped) return;
            bits &= touching_ ? bits - 1 : bits + (bits & (~bits + 1));  // without the lowest bit, or the lowest run
        }
    }
}

void Ray::visit_leftwards(const Frame& f, int row, std::size_t from, std::size_t to) {
    const std::uint64_t* words = f.grid->row(row);
    const bool was_stopped = stopped_;
    for (std::size_t word = to / 64 + 1; word-- > from / 64;) {
        std::uint64_t bits = words[word];
        if (word == from / 64) bits &= ~std::uint64_t{0} << (from % 64);
        if (word == to / 64) bits &= ~std::uint64_t{0} >> (63 - to % 64);
        while (bits != 0) {
            const int highest = 63 - std::countl_zero(bits);
            visit_cell(f, int(word * 64) + highest - 1, row);
            if (stopped_ && !was_stopped) return;
            const int run = touching_ ? 1 : std::countl_one(bits << (63 - highest));
            bits &= run > highest ? 0 : ~std::uint64_t{0} >> (63 - highest + run);
        }
    }
}

bool Ray::outside(const Frame& f, int x, int row) {
    return x < 0 || row < 0 || x >= f.grid->width() || row >= f.grid->height();
}

RegionId Ray::region_of(const Frame& f, int x, int row) const {
    return region_at(*map_, f.steep ? Cell{row, x} : Cell{x, row});
}

// Doubles settle which box comes first: the shares of two boxes are equal or differ by more than their rounding.
Hit Ray::entry(const Frame& f, int x, int row) const {
    const double along = f.dx == 0 ? -1 : double(2 * x - sign(f.dx) * reach_ - f.x) / f.dx;
    const double across = f.dy == 0 ? -1 : double(2 * row - sign(f.dy) * reach_ - f.y) / f.dy;
    const Step side = along >= across ? Step{-sign(f.dx), 0} : Step{0, -sign(f.dy)};
    return {.region = outside(f, x, row) ? RegionId{} : region_of(f, x, row),
            .cell = f.steep ? Cell{row, x} : Cell{x, row},
            .side = f.steep ? Step{side.y, side.x} : side,
            .row = row,
            .at = std::max(along, across)};
}

void Ray::visit_cell(const Frame& f, int x, int row) {
    if (outside(f, x, row)) {
        stop(entry(f, x, row).at);
        return;
    }
    const RegionId region = region_of(f, x, row);
    if (open(region)) return;
    const RegionMark& mark = region_marks_[region.value];
    // Boxes of the row behind the first can begin earlier; those of later rows cannot.
    const bool known = mark.ray == ray_ && std::abs(row - hits_[mark.hit].row) != 1;
    if (!known || !hits_[mark.hit].surely) meet(entry(f, x, row));
}

void Ray::meet(const Hit& hit) {
    RegionMark& mark = region_marks_[hit.region.value];
    if (mark.ray == ray_) {
        Hit& known = hits_[mark.hit];
        if (known.surely || !hit.surely) {
            if (hit.at < known.at && hit.surely) known = hit;
            return;
        }
        // It is crossed for certain now, perhaps in another of its parts: a hit of its own, already counted.
        if (stopped_ && hit.at >= stopped_at_) return;
        mark.hit = std::uint32_t(hits_.size());
        hits_.push_back(hit);
        if (solid(hit.region)) stop(hit.at);
        return;
    }
    if (stopped_ && hit.at >= stopped_at_) return;
    mark.ray = ray_;
    mark.hit = std::uint32_t(hits_.size());
    hits_.push_back(hit);
    if (stopped_) return;
    pay(hit.region);
    if (crossings_left_ < 0 || weight_left_ < 0 || solid(hit.region)) stop(hit.at);
}

// For the obstacles that are neither open nor paid for by this ray.
Ray::Price Ray::price(RegionId region) const {
    Price price;
    regions_->for_each_member(region, [&](ObstacleId obstacle) {
        const ObstacleMark& mark = obstacle_marks_[obstacle.value];
        if (mark.open == opening_ || mark.ray == ray_) return;
        ++price.crossings;
        price.weight += weight(obstacle);
    });
    return price;
}

void Ray::pay(RegionId region) {
    const Price due = price(region);
    crossings_left_ -= due.crossings;
    weight_left_ -= due.weight;
    regions_->for_each_member(region, [&](ObstacleId obstacle) { obstacle_marks_[obstacle.value].ray = ray_; });
}

void Ray::stop(double at) {
    stopped_at_ = stopped_ ? std::min(stopped_at_, at) : at;
    stopped_ = true;
}

bool Ray::solid(RegionId region) const {
    bool solid = false;
    regions_->for_each_member(region, [&](ObstacleId obstacle) {
        solid = solid || (obstacle_marks_[obstacle.value].open != opening_ && stays(obstacle));
    });
    return solid;
}

// A point that slides along cell edges crosses what fills both sides.
void Ray::walk_edge(const Frame& f) {
    const int upper = int(floor_divide(f.y, 2));
    const std::int64_t first = floor_divide(std::min(f.x, f.x + f.dx) - 1, 2) + 1;
    const std::int64_t last = floor_divide(std::max(f.x, f.x + f.dx), 2);
    const int step = sign(f.dx);
    const std::uint64_t* above = f.grid->row(upper);
    const std::uint64_t* below = f.grid->row(upper + 1);
    const std::int64_t from = std::clamp<std::int64_t>(step > 0 ? first : last, -1, f.grid->width());
    const std::int64_t to = std::clamp<std::int64_t>(step > 0 ? last : first, -1, f.grid->width());
    for (std::int64_t x = from; !stopped_ && (to - x) * step >= 0; x += step) {
        const auto bit = std::size_t(x + 1);
        if (((above[bit / 64] & below[bit / 64]) >> (bit % 64)) & 1U) visit_pair(f, int(x), upper);
    }
}

// A cell beside the edge is met where it faces the ray. Where the obstacle lies along the ray already, the front that
// stops the ray goes on there, back towards where the ray came from.
Hit Ray::edge_entry(const Frame& f, int x, int row, int across) const {
    Hit hit = entry(f, x, row);
    const int back = x - sign(f.dx);
    const bool along = !outside(f, back, row) && region_of(f, back, row) == hit.region;
    const Step side = along ? Step{0, across - row} : Step{-sign(f.dx), 0};
    hit.side = f.steep ? Step{side.y, side.x} : side;
    return hit;
}

// A ray can squeeze past a region in several places: where each begins is a hit of its own.
void Ray::meet_beside(const Hit& hit, bool begins) {
    if (!met(hit.region)) {
        meet(hit);
    } else if (begins) {
        hits_.push_back(hit);
    }
}

void Ray::visit_pair(const Frame& f, int x, int upper) {
    const bool no_upper = outside(f, x, upper);
    const bool no_lower = outside(f, x, upper + 1);
    if (no_upper && no_lower) {
        stop(entry(f, x, upper).at);
        return;
    }
    Hit one = edge_entry(f, x, no_upper ? upper + 1 : upper, no_upper ? upper : upper + 1);
    Hit other = edge_entry(f, x, no_lower ? upper : upper + 1, no_lower ? upper + 1 : upper);
    if (open(one.region) || open(other.region)) return;
    if (one.region == other.region) {
        meet((f.steep ? one.side.y : one.side.x) != 0 ? one : other);
        return;
    }
    squeezes_.push_back({one.region, other.region, one.at});
    const int back = x - sign(f.dx);
    const bool begins = outside(f, back, upper) || outside(f, back, upper + 1) ||
                        region_of(f, back, upper) != region_of(f, x, upper) ||
                        region_of(f, back, upper + 1) != region_of(f, x, upper + 1);
    one.surely = other.surely = false;
    const Price price_of_one = price(one.region);
    const Price price_of_other = price(other.region);
    const int crossings = crossings_left_ - std::min(price_of_one.crossings, price_of_other.crossings);
    const double weight_left = weight_left_ - std::min(price_of_one.weight, price_of_other.weight);
    meet_beside(one, begins);
    stopped_ = false;  // both are hit, whichever stops the ray
    meet_beside(other, begins);
    crossings_left_ = crossings;
    weight_left_ = weight_left;
    stopped_ = crossings_left_ < 0 || weight_left_ < 0 || (solid(one.region) && solid(other.region));
    stopped_at_ = stopped_ ? one.at : infinity;
}

}  // namespace waybreaker::crossing
