#include "site/rings.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace waybreaker::site {
namespace {

enum class Heading { east, south, west, north };

constexpr Cell step(Heading heading) {
    constexpr std::array<Cell, 4> steps = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    return steps[std::size_t(heading)];
}

constexpr Heading turned(Heading heading, int quarters) {
    return Heading((int(heading) + quarters + 4) % 4);
}

// Walks along cell sides with the label at its right hand.
class RingTracer {
  public:
    explicit RingTracer(const LabelRaster& raster)
        : raster_(raster), walked_(std::size_t(raster.width) * std::size_t(raster.height)) {}

    void trace_all(const std::function<void(const LabelRing&)>& take) {
        for (int y = 0; y < raster_.height; ++y) {
            for (int x = 0; x < raster_.width; ++x) {
                // Every ring somewhere goes east, along the top of a cell; the first one in scan order is a corner.
                const std::uint32_t label = raster_.labels[index({x, y})];
                if (label == 0 || label_at({x, y - 1}) == label || walked_[index({x, y})]) continue;
                trace({x, y}, label);
                take({label, corners_});
            }
        }
    }

  private:
    std::size_t index(Cell c) const { return std::size_t(c.y) * std::size_t(raster_.width) + std::size_t(c.x); }

    std::uint32_t label_at(Cell c) const {
        const bool inside = c.x >= 0 && c.x < raster_.width && c.y >= 0 && c.y < raster_.height;
        return inside ? raster_.labels[index(c)] : 0;
    }

    // Of the two cells in front of a corner, the one at the left or right hand.
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
        corners_.assign(1, start);
        Cell corner = start;
        Heading heading = Heading::east;
        while (true) {
            if (heading == Heading::east) walked_[index(corner)] = true;
            corner = {corner.x + step(heading).x, corner.y + step(heading).y};
            const int turn = turn_at(corner, heading, label);
            if (turn == 0) continue;
            heading = turned(heading, turn);
            if (corner == start && heading == Heading::east) return;
            corners_.push_back(corner);
        }
    }

    const LabelRaster& raster_;
    std::vector<bool> walked_;  // along the top of each cell
    std::vector<Cell> corners_;
};

}  // namespace

void trace_rings(const LabelRaster& raster, const std::function<void(const LabelRing&)>& take) {
    RingTracer(raster).trace_all(take);
}

}  // namespace waybreaker::site
