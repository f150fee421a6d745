// What an import makes of the ground, as text.
#pragma once

#include <string>
#include <string_view>

#include "geotiff/label_tiff.hpp"

namespace waybreaker::city {

// A letter for each cell: water, cliff, x for forbidden, - off road, Building (Protected), barrier.
inline std::string picture(const geotiff::LabelTiff& tiff) {
    constexpr std::string_view letters = "?Bbwcx-";
    std::string text;
    for (Cell c; c.y < tiff.map.height(); ++c.y) {
        for (c.x = 0; c.x < tiff.map.width(); ++c.x) {
            const ObstacleId id = tiff.map.obstacle_at(c);
            const char letter = id ? letters[std::size_t(tiff.annotations.kinds.at(id.value))] : '.';
            text += letter == 'B' && !tiff.map.obstacle(id).destructible ? 'P' : letter;
        }
        text += '\n';
    }
    return text;
}

}  // namespace waybreaker::city
