// Legend: the signs that a picture uses, with what they mean.
#pragma once

#include <string>
#include <vector>

#include "render/scene.hpp"

namespace waybreaker::render {

struct LegendEntry {
    std::string sign;  // drawn at the origin: 46 thousandths wide, centred vertically
    std::string name;
};

std::vector<LegendEntry> legend(const Scene& scene);

// In two columns.
std::size_t rows_of(const std::vector<LegendEntry>& entries);
std::string draw_legend(const Scene& scene, const std::vector<LegendEntry>& entries, double top);

}  // namespace waybreaker::render
