// Outlines: an independent reader of the path data colours the cells again.
#include "render/outline.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <charconv>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "ascii_map.hpp"
#include "render/sample.hpp"

namespace waybreaker::render {
namespace {

// Reads path data of m, h, v, z.
class PathReader {
  public:
    explicit PathReader(std::string_view path) : path_(path) {}

    // The corners of the next ring; empty at the end.
    std::vector<Cell> next_ring() {
        if (at_ == path_.size()) return {};
        EXPECT_EQ(command(), 'm');
        ring_start_.x += number();
        ring_start_.y += number();
        std::vector<Cell> ring = {ring_start_};
        for (char c = command(); c != 'z'; c = command()) {
            Cell corner = ring.back();
            (c == 'h' ? corner.x : corner.y) += number();
            EXPECT_TRUE(c == 'h' || c == 'v');
            ring.push_back(corner);
        }
        return ring;
    }

  private:
    char command() { return path_.at(at_++); }
    int number() {
        if (path_.at(at_) == ' ') ++at_;
        int value = 0;
        const auto end = std::from_chars(path_.data() + at_, path_.data() + path_.size(), value);
        EXPECT_EQ(end.ec, std::errc());
        at_ = std::size_t(end.ptr - path_.data());
        return value;
    }

    std::string_view path_;
    std::size_t at_ = 0;
    Cell ring_start_;
};

// Which cells the even-odd rule fills: a vertical side flips every cell at its right. Also checks that rings turn at
// every corner.
std::vector<bool> filled_cells(std::string_view path, int width, int height) {
    std::vector<bool> filled(std::size_t(width * height));
    PathReader reader(path);
    for (auto ring = reader.next_ring(); !ring.empty(); ring = reader.next_ring()) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Cell a = ring[i];
            const Cell b = ring[(i + 1) % ring.size()];
            const Cell c = ring[(i + 2) % ring.size()];
            EXPECT_NE(a.x == b.x, b.x == c.x) << "sides of a ring alternate";
            EXPECT_NE(a.x == b.x, a.y == b.y) << "sides are straight and not empty";
            if (a.x != b.x) continue;
            for (int y = std::min(a.y, b.y); y < std::max(a.y, b.y); ++y) {
                for (int x = a.x; x < width; ++x) filled[std::size_t(y * width + x)].flip();
            }
        }
    }
    return filled;
}

// Twice the shoelace sum of all rings: holes count negative.
long signed_area(std::string_view path) {
    long twice = 0;
    PathReader reader(path);
    for (auto ring = reader.next_ring(); !ring.empty(); ring = reader.next_ring()) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Cell a = ring[i];
            const Cell b = ring[(i + 1) % ring.size()];
            twice += long(a.x) * b.y - long(b.x) * a.y;
        }
    }
    return twice / 2;
}

std::array<std::string, style_count> outlines_of(const Sample& sample) {
    return outlines(sample.raster(), sample.styles());
}

std::string outline_of(std::string_view picture) {
    const Map map = map_from_ascii(picture);
    return outlines_of(Sample(map, {}, 1))[std::size_t(Style::obstacle)];
}

TEST(Outline, OneRingForARectangle) {
    EXPECT_EQ(outline_of(R"(
        .....
        ..###
        ..###)"),
              "m2 1h3v2h-3z");
}

TEST(Outline, AHoleIsARingOfItsOwn) {
    EXPECT_EQ(outline_of(R"(
        ###
        #.#
        ###)"),
              "m0 0h3v3h-3zm1 2h1v-1h-1z");
}

TEST(Outline, NeighboursHaveRingsOfTheirOwn) {
    EXPECT_EQ(outline_of(R"(
        aab
        abb)"),
              "m0 0h2v1h-1v1h-1zm2 0h1v2h-2v-1h1z");
}

TEST(Outline, CellsThatTouchAtACornerAreNotJoined) {
    const Map map = map_from_ascii(R"(
        #.
        .#)",
                                   Connectivity::eight);
    EXPECT_EQ(outlines_of(Sample(map, {}, 1))[0], "m0 0h1v1h-1zm1 1h1v1h-1z");
}

TEST(Outline, NothingForAFreeMap) {
    EXPECT_EQ(outline_of("...."), "");
}

struct RandomMap {
    Map map;
    std::vector<Breach> removed;
};

// Few labels on few cells: touching, nested, torn obstacles; every third one fixed, some removed.
RandomMap random_map() {
    const int width = *rc::gen::inRange(1, 14);
    const int height = *rc::gen::inRange(1, 14);
    const auto labels = *rc::gen::container<std::vector<std::uint32_t>>(
        std::size_t(width * height), rc::gen::weightedElement<std::uint32_t>({{4, 0}, {4, 1}, {2, 2}, {2, 3}, {1, 4}}));
    const std::vector<ObstacleAttributes> attributes = {{}, {}, {}, {.destructible = false, .source_id = 0}, {}};
    RandomMap result{Map::from_labels(width, height, labels, attributes), {}};
    for (const Obstacle& obstacle : result.map.obstacles()) {
        if (obstacle.destructible && *rc::gen::arbitrary<bool>())
            result.removed.push_back({.obstacle = obstacle.id, .at = {}, .entered_at = {}});
    }
    return result;
}

Style style_of(const RandomMap& world, ObstacleId id) {
    for (const Breach& breach : world.removed) {
        if (breach.obstacle == id) return Style::removed;
    }
    return world.map.obstacle(id).destructible ? Style::obstacle : Style::fixed_obstacle;
}

RC_GTEST_PROP(Outline, FillsExactlyTheCellsOfItsStyle, ()) {
    const RandomMap world = random_map();
    const auto paths = outlines_of(Sample(world.map, world.removed, 1));
    for (const Style style : {Style::obstacle, Style::fixed_obstacle, Style::removed}) {
        const std::string& path = paths[std::size_t(style)];
        const auto filled = filled_cells(path, world.map.width(), world.map.height());
        long count = 0;
        for (int y = 0; y < world.map.height(); ++y) {
            for (int x = 0; x < world.map.width(); ++x) {
                const ObstacleId id = world.map.obstacle_at({x, y});
                const bool expected = id && style_of(world, id) == style;
                RC_ASSERT(filled[std::size_t(y * world.map.width() + x)] == expected);
                count += expected;
            }
        }
        RC_ASSERT(signed_area(path) == count);
    }
}

RC_GTEST_PROP(Sample, CoarseCellsFollowTheirCells, ()) {
    const RandomMap world = random_map();
    const int step = *rc::gen::inRange(2, 6);
    const Sample sample(world.map, world.removed, step);
    const site::LabelRaster raster = sample.raster();
    for (int row = 0; row < raster.height; ++row) {
        for (int column = 0; column < raster.width; ++column) {
            int cells = 0, blocked = 0, removed = 0;
            for (int y = row * step; y < std::min((row + 1) * step, world.map.height()); ++y) {
                for (int x = column * step; x < std::min((column + 1) * step, world.map.width()); ++x) {
                    const ObstacleId id = world.map.obstacle_at({x, y});
                    const bool gone = id && style_of(world, id) == Style::removed;
                    ++cells;
                    removed += gone;
                    blocked += id && !gone;
                }
            }
            const std::uint32_t label = raster.labels[std::size_t(row * raster.width + column)];
            RC_ASSERT((label != 0) == (removed > 0 || 2 * blocked >= cells));
            if (label != 0) RC_ASSERT((sample.styles()[label] == Style::removed) == (removed > 0));
        }
    }
}

}  // namespace
}  // namespace waybreaker::render
