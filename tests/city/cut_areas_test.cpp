// Rivers, lakes and bays whose outlines end before the edge of the data: drawn ones, and laws on random ones.
#include "city/cut_areas.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "city/edge_faces.hpp"
#include "city/envelope.hpp"
#include "city/vector_source.hpp"

namespace waybreaker::city {
namespace {

using enum ClosedArea::How;

double area_of(const ClosedArea& closed) {
    return closed.shape ? OGR_G_Area(OGRGeometry::ToHandle(closed.shape.get())) : 0;
}

bool holds(const ClosedArea& closed, const Point& point) {
    const OGRPoint at(point.x, point.y);
    return closed.shape && closed.shape->Contains(&at);
}

Line ring(double west, double south, double east, double north) {
    return {{west, south}, {east, south}, {east, north}, {west, north}, {west, south}};
}

CutArea outline(std::vector<Line> outer, std::vector<Line> inner = {}) {
    return {.outer = std::move(outer), .inner = std::move(inner)};
}

// 400 x 300 metres.
const OGRPolygon edge = rectangle(envelope(0, 0, 400, 300));
const Line north_bank{{5, 180}, {200, 180}, {396, 180}};
const Line south_bank{{392, 120}, {5, 120}};
const Evidence stream{.within = {{{5, 150}, {395, 150}}}};

TEST(CutRiver, runs_on_to_the_edge_between_its_banks) {
    const ClosedArea river = closed_along_edge(outline({north_bank, south_bank}), edge, stream);
    EXPECT_EQ(river.how, closed);
    EXPECT_NEAR(area_of(river), 400 * 60, 1e-6);
    EXPECT_TRUE(holds(river, {1, 150}) && holds(river, {399, 150}));
    EXPECT_FALSE(holds(river, {200, 200}) || holds(river, {200, 100}));
}

TEST(CutRiver, is_where_no_streets_are) {
    const Evidence town{.outside = {{{50, 200}, {50, 290}, {350, 290}}, {{60, 20}, {60, 50}}}};
    const ClosedArea river = closed_along_edge(outline({north_bank, south_bank}), edge, town);
    EXPECT_EQ(river.how, closed);
    EXPECT_NEAR(area_of(river), 400 * 60, 1e-6);
}

TEST(CutRiver, goes_around_its_islands) {
    const Line island = ring(100, 140, 150, 160);
    const CutArea area = outline({north_bank, south_bank}, {island});
    // The island's ring says which side is water, if nothing else does.
    for (const Evidence& evidence : {stream, Evidence{}}) {
        const ClosedArea river = closed_along_edge(area, edge, evidence);
        EXPECT_EQ(river.how, closed);
        EXPECT_NEAR(area_of(river), 400 * 60 - 50 * 20, 1e-6);
        EXPECT_FALSE(holds(river, {120, 150}));
    }
    // An island that the edge cuts, too.
    const ClosedArea river =
        closed_along_edge(outline({north_bank, south_bank}, {{{396, 160}, {300, 160}, {300, 140}, {397, 140}}}), edge,
                          {.within = {{{5, 150}, {290, 150}}}});
    EXPECT_EQ(river.how, closed);
    EXPECT_NEAR(area_of(river), 400 * 60 - 100 * 20, 1e-6);
}

TEST(CutRiver, is_not_the_land_that_another_river_crosses) {
    Evidence two = stream;
    two.within.push_back({{100, 5}, {100, 110}});
    two.within.push_back({{300, 5}, {300, 150}});  // a tributary
    const ClosedArea river = closed_along_edge(outline({north_bank, south_bank}), edge, two);
    EXPECT_EQ(river.how, closed);
    EXPECT_NEAR(area_of(river), 400 * 60, 1e-6);
}

TEST(CutRiver, of_two_arms_has_both) {
    const ClosedArea rivers =
        closed_along_edge(outline({north_bank, south_bank, {{5, 50}, {395, 50}}, {{5, 20}, {395, 20}}}), edge,
                          {.within = {{{5, 150}, {395, 150}}, {{5, 35}, {395, 35}}}});
    EXPECT_EQ(rivers.how, closed);
    EXPECT_NEAR(area_of(rivers), 400 * 90, 1e-6);
    EXPECT_FALSE(holds(rivers, {200, 80}));
}

TEST(CutLake, in_a_corner_is_on_the_side_without_streets) {
    const CutArea lake = outline({{{150, 3}, {160, 100}, {120, 140}, {2, 150}}});
    const ClosedArea corner =
        closed_along_edge(lake, edge, {.outside = {{{200, 10}, {200, 290}}, ring(20, 200, 40, 220)}});
    EXPECT_EQ(corner.how, closed);
    EXPECT_TRUE(holds(corner, {1, 1}));
    EXPECT_FALSE(holds(corner, {300, 200}));
    const ClosedArea rest = closed_along_edge(lake, edge, {.outside = {{{20, 20}, {20, 100}, {100, 100}}}});
    EXPECT_EQ(rest.how, closed);
    EXPECT_TRUE(holds(rest, {300, 200}));
    EXPECT_NEAR(area_of(corner) + area_of(rest), 400 * 300, 1e-6);
}

TEST(CutLake, is_unknown_on_its_smaller_side_if_nothing_tells_which) {
    const ClosedArea lake = closed_along_edge(outline({{{4, 100}, {395, 100}}}), edge, {});
    EXPECT_EQ(lake.how, unknown);
    EXPECT_NEAR(area_of(lake), 400 * 100, 1e-6);
}

TEST(CutBay, that_meets_two_sides_of_the_edge_has_two_shores) {
    // A lake around a headland: its shore comes from the south, and goes on in the east.
    const ClosedArea bay =
        closed_along_edge(outline({{{100, 2}, {100, 200}, {398, 200}}, {{200, 4}, {200, 100}, {397, 100}}}), edge,
                          {.outside = {{{20, 20}, {20, 280}, {380, 280}}, {{300, 20}, {380, 20}}}});
    EXPECT_EQ(bay.how, closed);
    EXPECT_NEAR(area_of(bay), 100 * 200 + 200 * 100, 1e-6);
}

TEST(CutOutline, with_a_small_gap_is_closed_straight) {
    const ClosedArea river =
        closed_along_edge(outline({{{5, 180}, {190, 180}}, {{200, 180}, {396, 180}}, south_bank}), edge, stream);
    EXPECT_EQ(river.how, closed);
    EXPECT_NEAR(area_of(river), 400 * 60, 1e-6);
    // Even beside the edge, if the ends head for each other and not for it.
    const ClosedArea beside =
        closed_along_edge(outline({{{5, 280}, {190, 280}}, {{200, 280}, {396, 280}}, {{5, 220}, {395, 220}}}), edge,
                          {.within = {{{5, 250}, {395, 250}}}});
    EXPECT_EQ(beside.how, closed);
    EXPECT_NEAR(area_of(beside), 400 * 60, 1e-6);
}

TEST(CutOutline, with_a_wide_gap_is_unknown) {
    const ClosedArea river =
        closed_along_edge(outline({{{5, 180}, {60, 180}}, {{300, 180}, {396, 180}}, south_bank}), edge, stream);
    EXPECT_EQ(river.how, unknown);
    EXPECT_TRUE(holds(river, {200, 150}));
    // Of one bank alone nothing tells where the other is.
    const ClosedArea stub = closed_along_edge(outline({{{5, 150}, {200, 150}}}), edge, {});
    EXPECT_EQ(stub.how, unknown);
    EXPECT_GT(area_of(stub), 0);
}

TEST(CutOutline, elsewhere_leaves_nothing_here) {
    EXPECT_EQ(closed_along_edge(outline({{{500, 20}, {600, 20}}}), edge, stream).shape, nullptr);
    EXPECT_EQ(closed_along_edge(outline({}), edge, stream).shape, nullptr);
    EXPECT_EQ(closed_along_edge(outline({{{5, 5}}, {}}), edge, stream).shape, nullptr);
}

TEST(CutOutline, may_leave_the_edge_and_come_back) {
    // As extracts have it that keep ways whole.
    const ClosedArea lake = closed_along_edge(outline({{{-50, 100}, {100, 100}, {100, 200}, {-80, 200}}}), edge,
                                              {.outside = {{{200, 10}, {200, 290}}}});
    EXPECT_EQ(lake.how, closed);
    EXPECT_NEAR(area_of(lake), 100 * 100, 1e-6);
}

TEST(EdgeOfData, is_its_bounds_or_the_hull_that_outlines_end_at) {
    const OGREnvelope bounds = envelope(0, 0, 1000, 1000);
    const std::vector<Point> diamond{{500, 0}, {1000, 500}, {500, 1000}, {0, 500}, {500, 500}};
    const auto area = [](const std::unique_ptr<OGRPolygon>& polygon) { return polygon->get_Area(); };
    EXPECT_EQ(edge_of_data({}, {}, {}), nullptr);
    EXPECT_EQ(edge_of_data({}, {{1, 1}, {2, 2}}, {}), nullptr);
    EXPECT_NEAR(area(edge_of_data({}, diamond, {})), 500'000, 1e-6);
    EXPECT_NEAR(area(edge_of_data(bounds, {}, {})), 1'000'000, 1e-6);
    EXPECT_NEAR(area(edge_of_data(bounds, diamond, {})), 1'000'000, 1e-6);
    const CutArea at_the_hull = outline({{{260, 260}, {700, 290}}});
    EXPECT_NEAR(area(edge_of_data(bounds, diamond, {at_the_hull})), 500'000, 1e-6);
    const CutArea at_the_bounds = outline({{{10, 500}, {990, 500}}});
    EXPECT_NEAR(area(edge_of_data(bounds, diamond, {at_the_bounds})), 1'000'000, 1e-6);
    const std::vector<Point> nearly{{10, 10}, {990, 10}, {990, 990}, {10, 990}};
    EXPECT_NEAR(area(edge_of_data(bounds, nearly, {at_the_hull})), 1'000'000, 1e-6);
}

// Around a centre within the edge.
Line drawn_blob(double step) {
    const Point centre{double(*rc::gen::inRange(0, 401)), double(*rc::gen::inRange(0, 301))};
    const double radius = *rc::gen::inRange(60, 251);
    const double wave = *rc::gen::inRange(0, 41) / 100.0;
    const int waves = *rc::gen::inRange(1, 6);
    const auto count = int(2 * std::numbers::pi * radius * (1 + wave) / step) + 4;
    Line blob;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        const double r = radius * (1 + wave * std::sin(waves * angle));
        blob.push_back({centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)});
    }
    return blob;
}

// The runs of a ring's points within the edge; the whole ring if all are.
std::vector<Line> cut_by(const OGRPolygon& polygon, Line blob) {
    const auto out = std::find_if(blob.begin(), blob.end(), [&](const Point& p) { return !lies_within(polygon, p); });
    if (out == blob.end()) {
        blob.push_back(blob.front());
        return {blob};
    }
    std::rotate(blob.begin(), out, blob.end());
    std::vector<Line> runs(1);
    for (const Point& point : blob) {
        if (lies_within(polygon, point)) {
            runs.back().push_back(point);
        } else if (!runs.back().empty()) {
            runs.emplace_back();
        }
    }
    std::erase_if(runs, [](const Line& run) { return run.size() < 2; });
    return runs;
}

// In pieces of any direction and order.
std::vector<Line> in_ways(const std::vector<Line>& runs) {
    std::vector<Line> ways;
    for (const Line& run : runs) {
        for (std::size_t from = 0; from + 1 < run.size();) {
            const std::size_t to = std::min(run.size() - 1, from + std::size_t(*rc::gen::inRange(1, 60)));
            Line way(run.begin() + std::ptrdiff_t(from), run.begin() + std::ptrdiff_t(to) + 1);
            if (*rc::gen::arbitrary<bool>()) std::reverse(way.begin(), way.end());
            const auto at = *rc::gen::inRange<std::size_t>(0, ways.size() + 1);
            ways.insert(ways.begin() + std::ptrdiff_t(at), std::move(way));
            from = to;
        }
    }
    return ways;
}

RC_GTEST_PROP(CutArea, closed_again_is_what_was_cut, ()) {
    constexpr double step = 5;
    std::unique_ptr<OGRGeometry> convex(rectangle(envelope(0, 0, 400, 300)).clone());
    if (*rc::gen::arbitrary<bool>()) {
        OGRMultiPoint corners;
        for (const Point& corner : {Point{0, 80}, {150, 0}, {400, 60}, {370, 280}, {90, 300}}) {
            const OGRPoint point(corner.x, corner.y);
            corners.addGeometry(&point);
        }
        convex.reset(corners.ConvexHull());
    }
    const OGRPolygon& data = *convex->toPolygon();
    const Line blob = drawn_blob(step);
    OGRLinearRing whole;
    for (const Point& point : blob) whole.addPoint(point.x, point.y);
    whole.closeRings();
    OGRPolygon area;
    area.addRing(&whole);
    const std::vector<Line> runs = cut_by(data, blob);
    RC_PRE(!runs.empty());

    // Either streets on the land, or a stream in the water, or both.
    const bool dry = *rc::gen::arbitrary<bool>();
    const bool wet = !dry || *rc::gen::arbitrary<bool>();
    Evidence evidence;
    const std::unique_ptr<OGRGeometry> shore(area.Boundary());
    for (double x = 10; x < 400; x += 20) {
        for (double y = 10; y < 300; y += 20) {
            const OGRPoint middle(x, y);
            if (!lies_within(data, {x, y}) || shore->Distance(&middle) < step) continue;
            const bool water = area.getExteriorRing()->isPointInRing(&middle);
            if (water ? wet : dry) (water ? evidence.within : evidence.outside).push_back({{x - 1, y}, {x + 1, y}});
        }
    }
    RC_PRE(!evidence.within.empty() || !evidence.outside.empty());

    const ClosedArea again = closed_along_edge(outline(in_ways(runs)), data, evidence);
    const std::unique_ptr<OGRGeometry> right(area.Intersection(&data));
    RC_ASSERT(again.shape != nullptr);
    RC_ASSERT(again.how == closed);
    const std::unique_ptr<OGRGeometry> wrong(right->SymDifference(again.shape.get()));
    // At each end, and where a corner of the edge comes between two points, some square of the way's steps.
    const double longest = 2 * step;
    const double ends = 2 * double(runs.size()) + 6;
    RC_ASSERT(OGR_G_Area(OGRGeometry::ToHandle(wrong.get())) < ends * longest * longest);
}

}  // namespace
}  // namespace waybreaker::city
