#include "io/relabel.hpp"

#include <utility>

#include "site/described_map.hpp"

namespace waybreaker::io {

void relabel(MapFile& file, std::vector<std::uint32_t> labels) {
    site::LabelLayer layer = site::label_layer(file.map, file.annotations);
    layer.labels = std::move(labels);
    site::DescribedMap described = site::described(std::move(layer), std::move(file.annotations));
    file.map = std::move(described.map);
    file.annotations = std::move(described.annotations);
}

}  // namespace waybreaker::io
