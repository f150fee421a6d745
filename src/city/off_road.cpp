#include "city/off_road.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace waybreaker::city {
namespace {

// Distances, in cells, from the centre of each cell to that of the nearest marked one, as far as `most`; beyond, more
// than that.
template <class Marked>
std::vector<float> distances(const CellWindow& window, int most, Marked marked) {
    const auto at = [&](int x, int y) { return std::size_t(y) * std::size_t(window.width) + std::size_t(x); };
    std::vector<int> across(std::size_t(window.width) * std::size_t(window.height), most + 1);  // within a row
    const auto sweep = [&](int y, int first, int step) {
        int away = most + 1;
        for (int x = first; x >= 0 && x < window.width; x += step) {
            away = marked(at(x, y)) ? 0 : std::min(away + 1, most + 1);
            across[at(x, y)] = std::min(across[at(x, y)], away);
        }
    };
    for (int y = 0; y < window.height; ++y) {
        sweep(y, 0, 1);
        sweep(y, window.width - 1, -1);
    }
    std::vector<float> result(across.size());
    for (int y = 0; y < window.height; ++y) {
        for (int x = 0; x < window.width; ++x) {
            int least = (most + 1) * (most + 1);
            for (int row = std::max(y - most, 0); row <= std::min(y + most, window.height - 1); ++row) {
                const int aside = across[at(x, row)];
                least = std::min(least, aside * aside + (row - y) * (row - y));
            }
            result[at(x, y)] = std::sqrt(float(least));
        }
    }
    return result;
}

}  // namespace

void append_off_road(const GroundMap& ground, const CellWindow& window, double cell, site::LabelLayer& cells) {
    if (ground.roads.empty()) return;
    // From edge to edge: half a cell less at either end than between centres.
    const auto most = float(yard / cell + 1);
    const std::vector<float> to_road =
        distances(window, int(most), [&](std::size_t i) { return ground.roads[i] != 0; });
    const std::vector<float> to_house = distances(window, int(most), [&](std::size_t i) {
        const std::uint32_t label = cells.labels[i];
        return label != 0 && cells.attributes[label].destructible;
    });
    const auto label = std::uint32_t(cells.attributes.size());
    cells.kinds.emplace(label, site::ObstacleKind::off_road);
    cells.attributes.push_back({.destructible = false});
    for (std::size_t i = 0; i < cells.labels.size(); ++i) {
        const bool in_yard = to_road[i] + to_house[i] <= most;
        if (cells.labels[i] == 0 && ground.roads[i] == 0 && !in_yard) cells.labels[i] = label;
    }
}

}  // namespace waybreaker::city
