// Lines joined and cut: small pictures, and laws on random ones.
#include "city/line_work.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "city/envelope.hpp"

namespace waybreaker::city {
namespace {

double length(const std::vector<Line>& lines) {
    double sum = 0;
    for (const Line& line : lines) {
        for (std::size_t i = 1; i < line.size(); ++i) sum += distance(line[i - 1], line[i]);
    }
    return sum;
}

TEST(JoinedLines, go_on_where_another_begins_or_ends) {
    const std::vector<Line> ways{
        {{2, 0}, {3, 0}}, {{9, 9}, {8, 8}}, {{2, 0}, {1, 0}}, {{0, 0}, {1, 0}}, {{3, 0}, {4, 4}}};
    EXPECT_EQ(joined(ways), (std::vector<Line>{{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 4}}, {{9, 9}, {8, 8}}}));
}

TEST(JoinedLines, close_to_rings) {
    const std::vector<Line> joint = joined({{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {0, 1}, {1, 1}}});
    ASSERT_EQ(joint.size(), 1U);
    EXPECT_EQ(joint.front().size(), 5U);
    EXPECT_EQ(joint.front().front(), joint.front().back());
    const Line ring{{0, 0}, {1, 0}, {1, 1}, {0, 0}};
    EXPECT_EQ(joined({ring}).size(), 1U);
    EXPECT_EQ(length(joined({ring})), length({ring}));
    EXPECT_TRUE(joined({}).empty());
}

RC_GTEST_PROP(JoinedLines, are_as_long_as_their_ways_and_cannot_be_joined_further, ()) {
    std::vector<Line> ways;
    const int count = *rc::gen::inRange(0, 12);
    for (int i = 0; i < count; ++i) {
        const int points = *rc::gen::inRange(2, 4);
        Line way;
        for (int j = 0; j < points; ++j) {
            way.emplace_back(*rc::gen::inRange(0, 3), *rc::gen::inRange(0, 3));
        }
        ways.push_back(way);
    }
    const std::vector<Line> once = joined(ways);
    RC_ASSERT(std::abs(length(once) - length(ways)) < 1e-9);
    std::vector<std::pair<double, double>> ends;
    for (const Line& line : once) {
        if (line.front() == line.back()) continue;
        ends.emplace_back(line.front().x, line.front().y);
        ends.emplace_back(line.back().x, line.back().y);
    }
    std::sort(ends.begin(), ends.end());
    RC_ASSERT(std::adjacent_find(ends.begin(), ends.end()) == ends.end());
}

TEST(ClippedLines, are_the_pieces_inside) {
    const OGREnvelope bounds = envelope(0, 0, 10, 10);
    EXPECT_EQ(clipped({{-5, 5}, {5, 5}, {5, 15}}, bounds), (std::vector<Line>{{{0, 5}, {5, 5}, {5, 10}}}));
    EXPECT_EQ(clipped({{5, 5}, {15, 5}, {15, 6}, {5, 6}}, bounds),
              (std::vector<Line>{{{5, 5}, {10, 5}}, {{10, 6}, {5, 6}}}));
    EXPECT_EQ(clipped({{1, 1}, {2, 2}}, bounds), (std::vector<Line>{{{1, 1}, {2, 2}}}));
    EXPECT_TRUE(clipped({{-1, -1}, {-1, 11}, {11, 11}}, bounds).empty());
    EXPECT_TRUE(clipped({{-1, 1}, {1, -1.5}}, bounds).empty());
}

// Against many small steps along the line.
RC_GTEST_PROP(ClippedLines, are_inside_and_all_that_is, ()) {
    const OGREnvelope bounds = envelope(0, 0, 10, 6);
    Line line;
    const int points = *rc::gen::inRange(2, 6);
    for (int i = 0; i < points; ++i) line.emplace_back(*rc::gen::inRange(-5, 15), *rc::gen::inRange(-5, 11));
    const std::vector<Line> pieces = clipped(line, bounds);
    for (const Line& piece : pieces) {
        RC_ASSERT(piece.size() >= 2);
        for (const Point& p : piece) {
            RC_ASSERT(p.x >= -1e-9 && p.x <= 10 + 1e-9 && p.y >= -1e-9 && p.y <= 6 + 1e-9);
        }
    }
    double inside = 0;
    constexpr int steps = 2000;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double step = distance(line[i - 1], line[i]) / steps;
        for (int k = 0; k < steps; ++k) {
            const double t = (k + 0.5) / steps;
            const double x = line[i - 1].x + t * (line[i].x - line[i - 1].x);
            const double y = line[i - 1].y + t * (line[i].y - line[i - 1].y);
            if (x >= 0 && x <= 10 && y >= 0 && y <= 6) inside += step;
        }
    }
    RC_ASSERT(std::abs(length(pieces) - inside) < 0.1);
}

}  // namespace
}  // namespace waybreaker::city
