#include "model/nearest_place.hpp"

#include <algorithm>
#include <cstdlib>

namespace waybreaker {

std::optional<Cell> nearest_place(const OpenedMap& map, Cell at, const Body& body) {
    if (fits(map, at, body)) return at;
    const int rings = std::max(map.width(), map.height());
    for (int ring = 1; ring <= rings; ++ring) {
        std::optional<Cell> best;
        for (int dy = -ring; dy <= ring; ++dy) {
            const int stride = std::abs(dy) == ring ? 1 : 2 * ring;
            for (int dx = -ring; dx <= ring; dx += stride) {
                const Cell c{at.x + dx, at.y + dy};
                if (!fits(map, c, body)) continue;
                if (!best || distance(c, at) < distance(*best, at)) best = c;
            }
        }
        if (best) return best;
    }
    return std::nullopt;
}

}  // namespace waybreaker
