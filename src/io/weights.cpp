#include "io/weights.hpp"

#include <algorithm>

#include "core/number.hpp"
#include "core/range.hpp"
#include "io/output_file.hpp"
#include "movingai/text_lines.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::io {

std::vector<double> read_weights(const std::string& path, const Map& map) {
    const std::string text = read_whole(path, std::size_t{1} << 28);
    std::vector<double> weights(map.obstacles().size() + 1, 1);
    std::vector<bool> named(weights.size(), false);
    for (TextLines lines(text, path); lines.next();) {
        const std::vector<std::string_view> found = words(lines.line().substr(0, lines.line().find('#')));
        if (found.empty()) continue;
        const std::optional<std::uint32_t> id = waybreaker::number<std::uint32_t>(found.front());
        const std::optional<double> weight = waybreaker::number<double>(found.back());
        if (found.size() != 2 || !id || !weight) {
            throw lines.error("expected an obstacle and its weight, such as \"17 2.5\"");
        }
        if (*id < 1 || *id >= weights.size()) {
            throw lines.error("there is no obstacle " + std::to_string(*id) + "; the map has " +
                              std::to_string(map.obstacles().size()));
        }
        if (!(*weight >= least_weight && *weight <= most_weight)) {
            throw lines.error("a weight must be a number from " + number_text(least_weight) + " to " +
                              number_text(most_weight));
        }
        if (named[*id]) throw lines.error("obstacle " + std::to_string(*id) + " has a weight already");
        named[*id] = true;
        weights[*id] = *weight;
    }
    return weights;
}

std::vector<double> cell_weights(const Map& map) {
    std::vector<double> weights{0};
    for (const Obstacle& obstacle : map.obstacles()) weights.push_back(obstacle.cells);
    return weights;
}

std::vector<double> area_weights(const MapFile& map) {
    if (!map.has_metres()) {
        throw InputError(map.source +
                         ": a budget in square metres needs the size of a cell, which the map does not say");
    }
    return area_weights(map.map, map.cell_size);
}

std::vector<double> area_weights(const Map& map, double cell_size) {
    std::vector<double> weights{0};
    for (const Obstacle& obstacle : map.obstacles()) {
        weights.push_back(std::clamp(square_metres(obstacle.cells, cell_size), least_weight, most_weight));
    }
    return weights;
}

}  // namespace waybreaker::io
