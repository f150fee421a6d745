#include "site/described_map.hpp"

#include <string_view>
#include <utility>

#include "site/first_cells.hpp"

namespace waybreaker::site {
namespace {

struct PartsOfCell {
    std::size_t cell;  // row by row
    std::vector<std::uint32_t> parts;
};

Sections sections_of(const Map& map, std::vector<Structure> structures, std::vector<PartsOfCell> cells) {
    if (cells.empty()) return {};
    Sections sections{std::move(structures), {}};
    sections.parts.resize(map.obstacles().size() + 1);
    for (PartsOfCell& at : cells) sections.parts[map.labels()[at.cell]] = std::move(at.parts);
    return sections;
}

}  // namespace

DescribedMap described(LabelLayer layer, Annotations annotations) {
    std::vector<NamedCell> named = named_cells(std::move(layer.names), layer.labels);
    const std::vector<KindOfCell> kinds = kinds_of_cells(std::move(layer.kinds), layer.labels);
    const std::vector<LabelOfCell> tagged = tagged_cells(layer.tags, layer.labels);
    std::vector<PartsOfCell> parts = first_cells<PartsOfCell>(std::move(layer.parts), layer.labels);
    Map map = Map::from_labels(layer.width, layer.height, std::move(layer.labels), layer.attributes);
    annotations.names = obstacle_names(map, std::move(named));
    annotations.kinds = obstacle_kinds(map, kinds);
    annotations.tags = obstacle_tags(map, layer.tags, tagged);
    annotations.sections = sections_of(map, std::move(layer.structures), std::move(parts));
    return {std::move(map), std::move(annotations)};
}

LabelLayer label_layer(const Map& map, const Annotations& annotations) {
    const Sections& sections = annotations.sections;
    LabelLayer layer{.width = map.width(),
                     .height = map.height(),
                     .labels = {map.labels().begin(), map.labels().end()},
                     .attributes = std::vector<ObstacleAttributes>(1),
                     .structures = sections.structures};
    for (const Obstacle& o : map.obstacles()) {
        const std::uint32_t id = o.id.value;
        layer.attributes.push_back({o.destructible, o.source_id, o.weight, o.breach_time});
        if (const std::string_view name = annotations.name_of(o.id); !name.empty()) layer.names.emplace(id, name);
        if (!annotations.kinds.empty()) layer.kinds.emplace(id, annotations.kinds[id]);
        if (!sections.empty() && !sections.parts[id].empty()) layer.parts.emplace(id, sections.parts[id]);
    }
    for (const auto& [tag, obstacles] : annotations.tags) {
        std::vector<std::uint32_t>& labels = layer.tags[tag];
        for (const ObstacleId id : obstacles) labels.push_back(id.value);
    }
    return layer;
}

}  // namespace waybreaker::site
