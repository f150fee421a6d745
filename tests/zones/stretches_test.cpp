// Where moves are in zones, against many places on them.
#include "zones/stretches.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "zones/cells.hpp"
#include "zones/slow_zones.hpp"

namespace waybreaker::zones {
namespace {

constexpr int size = 12;
constexpr int places = 400;

// How far a place is inside; below 0 outside.
double depth_in_polygon(const Zone& zone, Point p) {
    double least = std::numeric_limits<double>::infinity();
    for_each_edge(zone, [&](Point a, Point b) { least = std::min(least, away_from(p, a, b)); });
    return slowly_inside(zone, p) ? least : -least;
}

// The same of a disc and cells.
double depth_in_cells(const std::vector<Cell>& cells, Point p, double radius) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Cell c : cells) {
        const double x = std::max(std::abs(p.x - c.x) - 0.5, 0.0);
        const double y = std::max(std::abs(p.y - c.y) - 0.5, 0.0);
        nearest = std::min(nearest, std::hypot(x, y));
    }
    return radius - nearest;
}

template <class Depth>
void expect_stretches(const Closed& closed, Point a, Point b, double radius, const Depth& depth) {
    const std::vector<Stretch> stretches = closed.stretches(a, b, radius);
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        RC_ASSERT(0 <= stretches[i].from && stretches[i].from < stretches[i].to && stretches[i].to <= 1);
        if (i > 0) RC_ASSERT(stretches[i - 1].to < stretches[i].from);
    }
    const double slack = 1e-9 + 1e-6 / std::max(distance(a, b), 1e-3);
    for (int i = 0; i <= places; ++i) {
        const double share = double(i) / places;
        const double deep = depth({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
        const auto has = [&](const Stretch& s) { return s.from - slack <= share && share <= s.to + slack; };
        const bool is_in = std::ranges::any_of(stretches, has);
        if (deep > 2 * margin) RC_ASSERT(is_in);
        if (deep < -1e-6)
            RC_ASSERT(!std::ranges::any_of(
                stretches, [&](const Stretch& s) { return s.from + slack < share && share < s.to - slack; }));
    }
}

RC_GTEST_PROP(Stretches, OfFlightsAreInThePolygon, ()) {
    const Zone zone = any_zone(size);
    RC_PRE(is_valid(zone));
    const Point a = any_cell(size);
    const Point b = *rc::gen::inRange(0, 10) == 0 ? a : any_cell(size);
    expect_stretches(Closed(zone, size, size), a, b, 0, [&](Point p) { return depth_in_polygon(zone, p); });
}

RC_GTEST_PROP(Stretches, OfDrivesAreAtTheCells, ()) {
    Zone zone = any_zone(size);
    zone.kind = ZoneKind::keep_out;
    RC_PRE(is_valid(zone));
    const std::vector<Cell> cells = cells_in(zone, size, size);
    const double radius = *rc::gen::element(0.3, 0.5, 1.7);
    const Point a = any_cell(size);
    const Point b = *rc::gen::inRange(0, 10) == 0 ? a : any_cell(size);
    expect_stretches(Closed(zone, size, size), a, b, radius, [&](Point p) { return depth_in_cells(cells, p, radius); });
}

}  // namespace
}  // namespace waybreaker::zones
