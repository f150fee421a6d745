#include "crossing/geometry/border.hpp"

#include <algorithm>
#include <climits>

namespace waybreaker::crossing {

void Borders::start_query(const Regions& regions, int reach) {
    regions_ = &regions;
    map_ = &regions.map();
    if (identity_ == map_->identity() && reach_ == reach) return;
    identity_ = map_->identity();
    reach_ = reach;
    borders_.clear();
}

const Border& Borders::of(RegionId region) {
    const auto [found, added] = borders_.try_emplace(region.value);
    if (added) found->second = trace(region);
    return found->second;
}

// Lattice points for the square: cells beside a cell of the region, diagonals included. For the point: corners of its
// cells, but for those with the region all around.
std::vector<Vertex> Borders::points_of(RegionId region) const {
    const Box& box = map_->obstacle(ObstacleId{region.value}).bounds;
    const auto owns = [&](int x, int y) {
        const Cell c{x, y};
        return map_->grid().contains(c) && region_at(*map_, c) == region;
    };
    std::vector<Vertex> border;
    const int from = reach_ == 2 ? 1 : 0;
    for (int y = box.min.y - from; y <= box.max.y + 1; ++y) {
        for (int x = box.min.x - from; x <= box.max.x + 1; ++x) {
            if (reach_ == 2) {
                if (owns(x, y) || !map_->grid().contains({x, y})) continue;
                bool touches = false;
                for (int dy = -1; dy <= 1; ++dy) {
                    for (int dx = -1; dx <= 1; ++dx) touches = touches || owns(x + dx, y + dy);
                }
                if (touches) border.push_back({2 * x, 2 * y});
            } else {
                // The corner at the upper left of cell (x, y).
                const int around = owns(x - 1, y - 1) + owns(x, y - 1) + owns(x - 1, y) + owns(x, y);
                if (around > 0 && around < 4) border.push_back({2 * x - 1, 2 * y - 1});
            }
        }
    }
    return border;
}

Border Borders::trace(RegionId region) const {
    Border border{points_of(region), {}, {INT_MAX, INT_MAX}, {INT_MIN, INT_MIN}};
    std::unordered_map<std::uint64_t, std::uint32_t> index;
    const auto key = [](Vertex v) { return std::uint64_t(std::uint32_t(v.x)) << 32U | std::uint32_t(v.y); };
    for (const Vertex v : border.points) {
        index.emplace(key(v), std::uint32_t(index.size()));
        border.min = {std::min(border.min.x, v.x), std::min(border.min.y, v.y)};
        border.max = {std::max(border.max.x, v.x), std::max(border.max.y, v.y)};
    }
    for (const Vertex v : border.points) {
        std::array<std::uint32_t, 4>& neighbours = border.neighbours.emplace_back();
        neighbours.fill(no_neighbour);
        std::size_t count = 0;
        for (const Step step : {Step{2, 0}, Step{0, 2}, Step{-2, 0}, Step{0, -2}}) {
            const auto found = index.find(key(v + step));
            if (found != index.end() && free_between(v, v + step)) neighbours[count++] = found->second;
        }
    }
    return border;
}

// Whether nothing at all is in the way from a lattice point to the next.
bool Borders::free_between(Vertex a, Vertex b) const {
    if (reach_ == 2) return !map_->grid().blocked({a.x / 2, a.y / 2}) && !map_->grid().blocked({b.x / 2, b.y / 2});
    // The cells on both sides of an edge: one is the region's, as it is on its border.
    const Vertex middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
    const Step across = a.x == b.x ? Step{1, 0} : Step{0, 1};
    const Vertex one = middle + across;
    const Vertex other = middle + -across;
    return !map_->grid().blocked({one.x / 2, one.y / 2}) || !map_->grid().blocked({other.x / 2, other.y / 2});
}

bool Borders::stands(Vertex v, std::span<const ObstacleId> open) const {
    if (reach_ == 1) return true;  // corners of cells are in no cell
    const Cell c{v.x / 2, v.y / 2};
    if (!map_->grid().blocked(c)) return true;
    return regions_->within(region_at(*map_, c), open);
}

}  // namespace waybreaker::crossing
