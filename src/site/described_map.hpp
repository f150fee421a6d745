// A map with its annotations, and as a layer of labels.
#pragma once

#include <cstdint>
#include <vector>

#include "site/annotations.hpp"
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
    Annotations annotations = {};
};

// The map of a label layer: what is known of a label is known of its obstacle, whatever `annotations` say of obstacles;
// of these the rest is kept. Throws as Map::from_labels.
DescribedMap described(LabelLayer layer, Annotations annotations = {});

// The label layer of a map; its labels are the obstacles' ids.
LabelLayer label_layer(const Map& map, const Annotations& annotations);

}  // namespace waybreaker::site
