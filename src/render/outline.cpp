#include "render/outline.hpp"

#include <vector>

#include "waybreaker/cell.hpp"

namespace waybreaker::render {
namespace {

enum class Heading { east, south, west, north };

constexpr Cell step(Heading heading) {
    constexpr std::array<Cell, 4> steps = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    return steps[std::size_t(heading)];
}

constexpr Heading turned(Heading heading, int quarters) {
    return Heading((int(heading) + quarters + 4) % 4);
}

// A number of path data: a sign separates numbers as well as a space does.
void append(std::string& path, int number) {
    if (number >= 0 && !path.empty() && path.back() >= '0' && path.back() <= '9') path += ' ';
    path += std::to_string(number);
}

// Walks along cell sides with the label at its right hand.
class RingTracer {
  public:
    explicit RingTracer(const LabelRaster& raster)
        : raster_(raster), walked_(std::size_t(raster.width) * std::size_t(raster.height)) {}

    std::array<std::string, look_count> trace_all() {
        for (int y = 0; y < raster_.height; ++y) {
            for (int x = 0; x < raster_.width; ++x) {
                // Every ring somewhere goes east, along the top of a cell; the first one in scan order is a corner.
                const std::uint32_t label = raster_.labels[index({x, y})];
                if (label == 0 || label_at({x, y - 1}) == label || walked_[index({x, y})]) continue;
                trace({x, y}, label);
            }
        }
        return std::move(paths_);
    }

  private:
    std::size_t index(Cell c) const { return std::size_t(c.y) * std::size_t(raster_.width) + std::size_t(c.x); }

    std::uint32_t label_at(Cell c) const {
        const bool inside = c.x >= 0 && c.x < raster_.width && c.y >= 0 && c.y < raster_.height;
        return inside ? raster_.labels[index(c)] : 0;
    }

    // Of the two cells in front of a corner, the one at the left or right hand. Corner (x, y) is the upper-left one of
    // cell (x, y).
    static constexpr Cell left_ahead(Cell corner, Heading heading) {
        constexpr std::array<Cell, 4> offsets = {{{0, -1}, {0, 0}, {-1, 0}, {-1, -1}}};
        const Cell offset = offsets[std::size_t(heading)];
        return {corner.x + offset.x, corner.y + offset.y};
    }
    static constexpr Cell right_ahead(Cell corner, Heading heading) { return left_ahead(corner, turned(heading, 1)); }

    // Where cells of the label meet at a corner only, the ring stays with its own: it turns right.
    int turn_at(Cell corner, Heading heading, std::uint32_t label) const {
        if (label_at(right_ahead(corner, heading)) != label) return 1;
        return label_at(left_ahead(corner, heading)) == label ? -1 : 0;
    }

    void trace(Cell start, std::uint32_t label) {
        const std::size_t look = std::size_t(raster_.looks[label]);
        std::string& path = paths_[look];
        path += 'm';
        append(path, start.x - ring_starts_[look].x);
        append(path, start.y - ring_starts_[look].y);
        ring_starts_[look] = start;

        Cell corner = start;
        Heading heading = Heading::east;
        int run = 0;
        do {
            if (heading == Heading::east) walked_[index(corner)] = true;
            corner = {corner.x + step(heading).x, corner.y + step(heading).y};
            ++run;
            const int turn = turn_at(corner, heading, label);
            if (turn == 0) continue;
            if (corner != start || turned(heading, turn) != Heading::east) write_side(path, heading, run);
            heading = turned(heading, turn);
            run = 0;
        } while (corner != start || heading != Heading::east);
        path += 'z';  // draws the last side
    }

    static void write_side(std::string& path, Heading heading, int run) {
        path += heading == Heading::east || heading == Heading::west ? 'h' : 'v';
        append(path, heading == Heading::east || heading == Heading::south ? run : -run);
    }

    const LabelRaster& raster_;
    std::vector<bool> walked_;  // along the top of each cell
    std::array<std::string, look_count> paths_;
    std::array<Cell, look_count> ring_starts_{};  // where relative coordinates start
};

}  // namespace

std::array<std::string, look_count> outlines(const LabelRaster& raster) {
    return RingTracer(raster).trace_all();
}

}  // namespace waybreaker::render
