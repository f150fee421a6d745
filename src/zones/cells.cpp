#include "zones/cells.hpp"

#include <algorithm>
#include <cstdint>

#include "zones/shape.hpp"

namespace waybreaker::zones {
namespace {

constexpr std::int64_t half = steps / 2;

// The cell in whose column or row a coordinate lies; of a side between two, the later one.
std::int64_t cell_at(std::int64_t coordinate) {
    const std::int64_t shifted = coordinate + half;
    return shifted >= 0 ? shifted / steps : -((-shifted + steps - 1) / steps);
}

// Whether an edge meets the area of a cell, its sides left out. None of the lines that could separate them does.
bool passes(const Edge& edge, std::int64_t x, std::int64_t y) {
    const Spot least{x * steps - half, y * steps - half};
    const Spot most{x * steps + half, y * steps + half};
    if (std::max(edge.from.x, edge.to.x) <= least.x || std::min(edge.from.x, edge.to.x) >= most.x ||
        std::max(edge.from.y, edge.to.y) <= least.y || std::min(edge.from.y, edge.to.y) >= most.y)
        return false;
    const std::int64_t a = turn(edge.from, edge.to, least);
    const std::int64_t b = turn(edge.from, edge.to, most);
    const std::int64_t c = turn(edge.from, edge.to, {least.x, most.y});
    const std::int64_t d = turn(edge.from, edge.to, {most.x, least.y});
    return std::min({a, b, c, d}) < 0 && std::max({a, b, c, d}) > 0;
}

}  // namespace

std::vector<Cell> cells_in(const Zone& zone, int width, int height) {
    const Shape shape = shape_of(zone);
    std::vector<Cell> cells;
    const std::int64_t top = std::max<std::int64_t>(cell_at(shape.least.y), 0);
    const std::int64_t bottom = std::min<std::int64_t>(cell_at(shape.most.y), height - 1);
    const std::int64_t left = std::max<std::int64_t>(cell_at(shape.least.x), 0);
    const std::int64_t right = std::min<std::int64_t>(cell_at(shape.most.x), width - 1);
    for (std::int64_t y = top; y <= bottom; ++y) {
        std::vector<char> met(std::size_t(std::max<std::int64_t>(right - left + 1, 0)), false);
        std::vector<double> crossings;  // of edges with the line through the centres of the row
        const std::int64_t centre = y * steps;
        for (const Edge& edge : shape.edges) {
            const std::int64_t low = std::min(edge.from.y, edge.to.y);
            const std::int64_t high = std::max(edge.from.y, edge.to.y);
            if (high < centre - half || low > centre + half) continue;
            if (low <= centre && centre < high) {
                const double share = double(centre - edge.from.y) / double(edge.to.y - edge.from.y);
                crossings.push_back(double(edge.from.x) + share * double(edge.to.x - edge.from.x));
            }
            const std::int64_t first = std::max(cell_at(std::min(edge.from.x, edge.to.x)), left);
            const std::int64_t last = std::min(cell_at(std::max(edge.from.x, edge.to.x)), right);
            for (std::int64_t x = first; x <= last; ++x) {
                if (passes(edge, x, y)) met[std::size_t(x - left)] = true;
            }
        }
        std::ranges::sort(crossings);
        // A cell that no edge passes is inside or outside as its centre is, and no crossing is near that.
        std::size_t before = 0;
        for (std::int64_t x = left; x <= right; ++x) {
            while (before < crossings.size() && crossings[before] < double(x * steps)) ++before;
            if (met[std::size_t(x - left)] || before % 2 == 1) cells.push_back({int(x), int(y)});
        }
    }
    return cells;
}

}  // namespace waybreaker::zones
