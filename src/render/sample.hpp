// Sample: the labels to draw, and a coarser stand-in for maps whose cells are smaller than what a pixel can show.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/outline.hpp"
#include "site/annotations.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::render {

// What each obstacle looks like while it stands, by id; entry 0 is not used.
std::vector<Style> standing_styles(const Map& map, const site::Annotations& known);

// Owns what its raster points to; a sample of step 1 also points into the map, which must outlive it.
class Sample {
  public:
    // One cell of the raster stands for step * step cells of the map (fewer at the right and lower edges). With step 1
    // labels are obstacle ids; with more they are styles, so neighbours merge: a coarse cell is removed if any
    // of its cells is, otherwise blocked if at least half of its cells are. Time O(cells of the map).
    // `known`: what the obstacles are, where that is known.
    Sample(const Map& map, std::span<const Breach> removed, int step, const site::Annotations& known = {});

    site::LabelRaster raster() const;
    // By label of the raster.
    std::span<const Style> styles() const { return styles_; }

  private:
    const Map* map_;
    int step_;
    std::vector<Style> styles_;
    std::vector<std::uint32_t> coarse_labels_;
};

}  // namespace waybreaker::render
