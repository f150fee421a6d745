// A map with what is known of its obstacles.
#pragma once

#include <cstdint>
#include <vector>

#include "site/obstacle_kinds.hpp"
#include "site/obstacle_names.hpp"
#include "site/obstacle_tags.hpp"
#include "site/sections.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::site {

// Labels of cells, and what they stand for: what label maps are made of.
struct LabelLayer {
    int width = 1;
    int height = 1;
    std::vector<std::uint32_t> labels = {};           // row by row, 0 = free
    std::vector<ObstacleAttributes> attributes = {};  // by label, entry 0 unused
    LabelNames names = {};
    LabelKinds kinds = {};
    LabelTags tags = {};
    std::vector<Structure> structures = {};  // that the parts below are of
    LabelParts parts = {};
};

struct DescribedMap {
    Map map;
    ObstacleNames names = {};
    ObstacleKinds kinds = {};
    ObstacleTags tags = {};
    Sections sections = {};
};

// The map of a label layer: what is known of a label is known of its obstacle. Throws as Map::from_labels.
DescribedMap described(LabelLayer layer);

// The label layer of a map of which that is known; its labels are the obstacles' ids.
LabelLayer label_layer(const Map& map, const ObstacleNames& names, const ObstacleKinds& kinds, const ObstacleTags& tags,
                       const Sections& sections = {});

}  // namespace waybreaker::site
