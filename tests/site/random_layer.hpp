// Random label maps with all that can be known of their obstacles.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cstdint>
#include <string>

#include "random_map.hpp"
#include "site/described_map.hpp"

namespace waybreaker::site {

// Rectangles, some of which cannot be destroyed; a later one covers an earlier one.
inline LabelLayer random_layer(bool weighed) {
    LabelLayer layer{.width = *number(1, 30), .height = *number(1, 30)};
    layer.labels.assign(std::size_t(layer.width) * std::size_t(layer.height), 0);
    layer.attributes.resize(1);
    for (std::uint32_t label = 1; label <= std::uint32_t(*number(0, 12)); ++label) {
        const Cell corner{*number(0, layer.width - 1), *number(0, layer.height - 1)};
        const Cell end{std::min(corner.x + *number(1, 12), layer.width),
                       std::min(corner.y + *number(1, 12), layer.height)};
        for (Cell c = corner; c.y < end.y; ++c.y) {
            for (c.x = corner.x; c.x < end.x; ++c.x) {
                layer.labels[std::size_t(c.y) * std::size_t(layer.width) + std::size_t(c.x)] = label;
            }
        }
        layer.attributes.push_back({.destructible = mostly(),
                                    .source_id = *number(-9, 9),
                                    .weight = weighed ? *number(1, 9) / 2.0 : 1,
                                    .breach_time = double(*number(0, 3))});
        if (mostly()) layer.names[label] = "house " + std::to_string(*number(1, 9));
        layer.kinds[label] = *rc::gen::element(ObstacleKind::building, ObstacleKind::barrier);
        for (const char* tag : {"amenity=school", "building=yes", "historic=ruins"}) {
            if (!mostly()) layer.tags[tag].push_back(label);
        }
    }
    return layer;
}

template <class Visit>
void for_each_cell(const Map& map, Visit visit) {
    for (Cell c; c.y < map.height(); ++c.y) {
        for (c.x = 0; c.x < map.width(); ++c.x) visit(c);
    }
}

}  // namespace waybreaker::site
