#include "check/contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace waybreaker::checker {
namespace {

// Squares of products of two coordinates, times a million, need more than 64 bits on large maps.
__extension__ using Wide = __int128;

std::int64_t cross(Vertex a, Vertex b) {
    return a.x * b.y - a.y * b.x;
}
std::int64_t dot(Vertex a, Vertex b) {
    return a.x * b.x + a.y * b.y;
}
Vertex operator-(Vertex a, Vertex b) {
    return {a.x - b.x, a.y - b.y};
}
Vertex centre(Cell c) {
    return {2 * std::int64_t(c.x), 2 * std::int64_t(c.y)};
}

// The square of a cell, seen from its centre.
constexpr std::array<Vertex, 4> square{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

// Whether the segment a-b meets the square, its sides included or not. Convex shapes are apart if a line along a side
// of one of them parts them.
bool segment_meets_square(Vertex a, Vertex b, bool with_sides) {
    const std::int64_t reach = with_sides ? 1 : 0;  // coordinates are integers: below 1 is at most 0
    if (std::min(a.x, b.x) > reach || std::max(a.x, b.x) < -reach) return false;
    if (std::min(a.y, b.y) > reach || std::max(a.y, b.y) < -reach) return false;
    if (a == b) return true;
    int left = 0;
    int right = 0;
    for (const Vertex corner : square) {
        const std::int64_t side = cross(b - a, corner - a);
        left += side > 0 ? 1 : 0;
        right += side < 0 ? 1 : 0;
    }
    return with_sides ? left < 4 && right < 4 : left > 0 && right > 0;
}

// Whether segment and square are nearer than `radius`. Convex shapes that are apart are nearest at an end of the
// segment or at a corner of the square.
bool disc_meets_square(Vertex a, Vertex b, std::int64_t radius) {
    if (segment_meets_square(a, b, true)) return true;
    constexpr Wide million = 1'000'000;
    const Wide limit = 4 * Wide(radius) * radius;  // squared, in half cells, times a million
    const auto end_is_near = [&](Vertex end) {
        const std::int64_t x = std::max<std::int64_t>(std::abs(end.x) - 1, 0);
        const std::int64_t y = std::max<std::int64_t>(std::abs(end.y) - 1, 0);
        return million * (x * x + y * y) < limit;
    };
    const Vertex way = b - a;
    const auto corner_is_near = [&](Vertex corner) {
        const std::int64_t along = dot(corner - a, way);
        if (along <= 0 || along >= dot(way, way)) return false;  // an end is nearer
        const Wide aside = cross(way, corner - a);
        return million * aside * aside < limit * dot(way, way);
    };
    return end_is_near(a) || end_is_near(b) || std::any_of(square.begin(), square.end(), corner_is_near);
}

bool meets(const Leg& leg, Cell cell, std::int64_t radius) {
    const Vertex a = leg.from - centre(cell);
    const Vertex b = leg.to - centre(cell);
    return radius == 0 ? segment_meets_square(a, b, false) : disc_meets_square(a, b, radius);
}

// After which share of the leg the agent meets the cell first. Precondition: it does. The room between them is a convex
// function of the share: find where it is least, then the moment before at which it is used up.
double first_share(const Leg& leg, Cell cell, std::int64_t radius) {
    const auto room = [&](double share) {
        const Point at = leg.place(share);
        const double x = std::abs(at.x - cell.x) - 0.5;
        const double y = std::abs(at.y - cell.y) - 0.5;
        return radius == 0 ? std::max(x, y) : std::hypot(std::max(x, 0.0), std::max(y, 0.0)) - double(radius) / 1000;
    };
    if (room(0) < 0) return 0;
    double low = 0;
    double high = 1;
    for (int i = 0; i < 100; ++i) {
        const double third = (high - low) / 3;
        if (room(low + third) <= room(high - third)) {
            high -= third;
        } else {
            low += third;
        }
    }
    double before = 0;
    double met = high;
    for (int i = 0; i < 60; ++i) {
        const double middle = (before + met) / 2;
        (room(middle) < 0 ? met : before) = middle;
    }
    return met;
}

// Calls visit(cell, obstacle) for every blocked cell whose centre is nearer to the leg than `reach`, and for some more.
template <class Visit>
void for_each_blocked_cell_near(const Map& map, const Leg& leg, double reach, Visit visit) {
    const Point a = leg.place(0);
    const Point b = leg.place(1);
    const auto first = [](double low) { return int(std::max(std::floor(low), 0.0)); };
    const auto last = [](double high, int size) { return int(std::min(std::ceil(high), size - 1.0)); };
    const int bottom = last(std::max(a.y, b.y) + reach, map.height());
    for (int y = first(std::min(a.y, b.y) - reach); y <= bottom; ++y) {
        // From where to where the leg is that near to the row.
        double x1 = a.x;
        double x2 = b.x;
        if (a.y != b.y) {
            const double s1 = std::clamp((y - reach - a.y) / (b.y - a.y), 0.0, 1.0);
            const double s2 = std::clamp((y + reach - a.y) / (b.y - a.y), 0.0, 1.0);
            x1 = leg.place(s1).x;
            x2 = leg.place(s2).x;
        }
        const int right = last(std::max(x1, x2) + reach, map.width());
        for (int x = first(std::min(x1, x2) - reach); x <= right; ++x) {
            if (const ObstacleId obstacle = map.obstacle_at({x, y})) visit(Cell{x, y}, obstacle);
        }
    }
}

// What blocks a cell; nothing if it is free. The outside of the map is blocked by obstacle 0.
std::optional<ObstacleId> blocker(const Map& map, Cell c) {
    if (c.x < 0 || c.y < 0 || c.x >= map.width() || c.y >= map.height()) return ObstacleId{0};
    const ObstacleId obstacle = map.obstacle_at(c);
    return obstacle ? std::optional(obstacle) : std::nullopt;
}

}  // namespace

Point Leg::place(double share) const {
    return {(double(from.x) + share * double(to.x - from.x)) / 2, (double(from.y) + share * double(to.y - from.y)) / 2};
}

std::vector<Contact> contacts(const Map& map, const Leg& leg, std::int64_t radius) {
    std::map<ObstacleId, double> first;
    for_each_blocked_cell_near(map, leg, double(radius) / 1000 + 1, [&](Cell cell, ObstacleId obstacle) {
        if (!meets(leg, cell, radius)) return;
        const double share = first_share(leg, cell, radius);
        const auto [known, is_new] = first.emplace(obstacle, share);
        if (!is_new) known->second = std::min(known->second, share);
    });
    std::vector<Contact> found;
    for (const auto& [obstacle, share] : first) found.push_back({obstacle, leg.time(share), leg.place(share)});
    return found;
}

std::vector<Passage> side_passages(const Map& map, const Leg& leg) {
    const bool upright = leg.from.x == leg.to.x;
    const bool level = leg.from.y == leg.to.y;
    const std::int64_t line = upright ? leg.from.x : leg.from.y;
    if (upright == level || line % 2 == 0) return {};  // a wait, or not between rows or columns of cells
    const std::int64_t from = upright ? leg.from.y : leg.from.x;
    const std::int64_t to = upright ? leg.to.y : leg.to.x;
    const std::int64_t step = to > from ? 2 : -2;
    const int before = int((line - 1) / 2);
    std::vector<Passage> found;
    for (std::int64_t at = from; at != to; at += step) {
        const int along = int((at + step / 2) / 2);
        const auto cell = [&](int beside) { return upright ? Cell{beside, along} : Cell{along, beside}; };
        const std::optional<ObstacleId> first = blocker(map, cell(before));
        const std::optional<ObstacleId> second = blocker(map, cell(before + 1));
        const double share = double(at - from) / double(to - from);
        if (first && second) found.push_back({*first, *second, leg.time(share), leg.place(share)});
    }
    return found;
}

std::vector<Passage> corner_passages(const Map& map, const Leg& leg) {
    const Vertex way = leg.to - leg.from;
    std::vector<Passage> found;
    for_each_blocked_cell_near(map, leg, 1, [&](Cell cell, ObstacleId obstacle) {
        for (const int down : {-1, 1}) {  // its two corners to the right; the other cell cares for the left ones
            const Vertex corner = Vertex{2 * cell.x + 1, 2 * cell.y + down} - leg.from;
            const std::int64_t along = dot(corner, way);
            if (cross(corner, way) != 0 || along <= 0 || along >= dot(way, way)) continue;
            const std::optional<ObstacleId> other = blocker(map, {cell.x + 1, cell.y + down});
            const double share = double(along) / double(dot(way, way));
            if (other) found.push_back({obstacle, *other, leg.time(share), leg.place(share)});
        }
    });
    return found;
}

}  // namespace waybreaker::checker
