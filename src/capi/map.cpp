#include <algorithm>
#include <utility>
#include <vector>

#include "capi/handles.hpp"
#include "core/range.hpp"
#include "io/labels_digest.hpp"
#include "io/map_with_edits.hpp"
#include "io/sha256.hpp"
#include "map/map_size.hpp"
#include "waybreaker/movingai.hpp"

namespace waybreaker::capi {
namespace {

using MapHandle = std::unique_ptr<waybreaker_map>;

Connectivity connectivity_of(int neighbours) {
    if (neighbours == 4) return Connectivity::four;
    if (neighbours == 8) return Connectivity::eight;
    throw InputError("the connectivity must be 4 or 8, not " + std::to_string(neighbours));
}

void require_cell_size(double cell_size) {
    if (cell_size == 0) return;  // nobody knows it
    require_range(cell_size, io::least_cell_size, io::most_cell_size, "the side of a cell, in metres,");
}

std::string source_of(const char* name) {
    return name == nullptr ? "map" : name;
}

MapHandle handle(Map map, Connectivity connectivity, const char* name, std::string digest, double cell_size) {
    auto result = std::make_unique<waybreaker_map>(waybreaker_map{{.map = std::move(map)}, connectivity});
    io::MapFile& file = result->file;
    file.source = source_of(name);
    file.digest = std::move(digest);
    file.cell_size_given = cell_size != 0;
    if (file.cell_size_given) file.cell_size = cell_size;
    return result;
}

MapHandle from_movingai(const char* name, std::string_view bytes, int neighbours, double cell_size) {
    const Connectivity connectivity = connectivity_of(neighbours);
    require_cell_size(cell_size);
    Grid grid = read_movingai_map(bytes, source_of(name));
    return handle(Map(std::move(grid), connectivity), connectivity, name, io::sha256_digest(bytes), cell_size);
}

MapHandle from_grid(const char* name, const std::uint8_t* blocked, int width, int height, int neighbours,
                    double cell_size) {
    const Connectivity connectivity = connectivity_of(neighbours);
    require_cell_size(cell_size);
    Grid grid(width, height);
    const std::uint8_t* next = &required(blocked, "the array of blocked cells");
    for (Cell c; c.y < height; ++c.y) {
        for (c.x = 0; c.x < width; ++c.x) {
            if (*next++ != 0) grid.set_blocked(c, true);
        }
    }
    std::string digest = io::sha256_digest(movingai_map(grid));
    return handle(Map(std::move(grid), connectivity), connectivity, name, std::move(digest), cell_size);
}

ObstacleAttributes attributes_of(const waybreaker_attributes& a) {
    return {.destructible = a.destructible, .source_id = a.source_id, .weight = a.weight, .breach_time = a.breach_time};
}

std::vector<ObstacleAttributes> attributes_of(const waybreaker_attributes* attributes, std::size_t count) {
    std::vector<ObstacleAttributes> result;
    if (count == 0) return result;
    std::transform(&required(attributes, "the array of attributes"), attributes + count, std::back_inserter(result),
                   [](const waybreaker_attributes& a) { return attributes_of(a); });
    return result;
}

MapHandle from_labels(const char* name, const std::uint32_t* labels, int width, int height,
                      const waybreaker_attributes* attributes, std::size_t attribute_count, double cell_size) {
    require_cell_size(cell_size);
    require_size(width, height);
    const std::uint32_t* first = &required(labels, "the array of labels");
    Map map = Map::from_labels(width, height, {first, first + std::size_t(width) * std::size_t(height)},
                               attributes_of(attributes, attribute_count));
    std::string digest = io::labels_digest(map);
    return handle(std::move(map), Connectivity::four, name, std::move(digest), cell_size);
}

std::vector<Cell> cells_of(const waybreaker_edit& edit) {
    std::vector<Cell> cells;
    if (edit.cell_count == 0) return cells;
    std::transform(&required(edit.cells, "the array of an edit's cells"), edit.cells + edit.cell_count,
                   std::back_inserter(cells), [](const waybreaker_cell& c) {
                       return Cell{c.x, c.y};
                   });
    return cells;
}

MapEdit edit_of(const waybreaker_edit& edit) {
    switch (edit.kind) {
        case WAYBREAKER_EDIT_REMOVE:
            return MapEdit::remove({edit.obstacle});
        case WAYBREAKER_EDIT_ADD:
            return MapEdit::add(cells_of(edit), attributes_of(edit.attributes));
        case WAYBREAKER_EDIT_EXTEND:
            return MapEdit::extend({edit.obstacle}, cells_of(edit));
        case WAYBREAKER_EDIT_FREE:
            return MapEdit::free(cells_of(edit));
    }
    throw InputError("there is no kind of edit " + std::to_string(edit.kind));
}

MapHandle with(const waybreaker_map& map, const waybreaker_edit* edits, std::size_t count) {
    std::vector<MapEdit> all;
    if (count > 0)
        std::transform(&required(edits, "the array of edits"), edits + count, std::back_inserter(all), edit_of);
    return std::make_unique<waybreaker_map>(waybreaker_map{io::with_edits(map.file, all), map.connectivity});
}

}  // namespace
}  // namespace waybreaker::capi

using waybreaker::capi::give;

waybreaker_status waybreaker_map_from_movingai(const char* name, const char* bytes, size_t size, int connectivity,
                                               double cell_size, waybreaker_map** map, waybreaker_text** error) {
    return give(map, error, [&] {
        const std::string_view file = waybreaker::capi::bytes_of(bytes, size, "the map file");
        return waybreaker::capi::from_movingai(name, file, connectivity, cell_size);
    });
}

waybreaker_status waybreaker_map_from_grid(const char* name, const uint8_t* blocked, int32_t width, int32_t height,
                                           int connectivity, double cell_size, waybreaker_map** map,
                                           waybreaker_text** error) {
    return give(map, error,
                [&] { return waybreaker::capi::from_grid(name, blocked, width, height, connectivity, cell_size); });
}

waybreaker_status waybreaker_map_from_labels(const char* name, const uint32_t* labels, int32_t width, int32_t height,
                                             const waybreaker_attributes* attributes, size_t attribute_count,
                                             double cell_size, waybreaker_map** map, waybreaker_text** error) {
    return give(map, error, [&] {
        return waybreaker::capi::from_labels(name, labels, width, height, attributes, attribute_count, cell_size);
    });
}

waybreaker_status waybreaker_map_with(const waybreaker_map* map, const waybreaker_edit* edits, size_t edit_count,
                                      waybreaker_map** edited, waybreaker_text** error) {
    return give(edited, error,
                [&] { return waybreaker::capi::with(waybreaker::capi::required(map, "the map"), edits, edit_count); });
}

void waybreaker_map_free(waybreaker_map* map) {
    delete map;
}

int32_t waybreaker_map_width(const waybreaker_map* map) {
    return map == nullptr ? 0 : map->file.map.width();
}

int32_t waybreaker_map_height(const waybreaker_map* map) {
    return map == nullptr ? 0 : map->file.map.height();
}

uint32_t waybreaker_map_obstacle_count(const waybreaker_map* map) {
    return map == nullptr ? 0 : uint32_t(map->file.map.obstacles().size());
}

const uint32_t* waybreaker_map_labels(const waybreaker_map* map) {
    return map == nullptr ? nullptr : map->file.map.labels().data();
}

const char* waybreaker_map_digest(const waybreaker_map* map) {
    return map == nullptr ? nullptr : map->file.digest.c_str();
}

bool waybreaker_map_obstacle(const waybreaker_map* map, uint32_t id, waybreaker_obstacle* obstacle) {
    if (map == nullptr || obstacle == nullptr || id == 0 || id > map->file.map.obstacles().size()) return false;
    const waybreaker::Obstacle& found = map->file.map.obstacle({id});
    *obstacle = {.id = id,
                 .cells = found.cells,
                 .min_x = found.bounds.min.x,
                 .min_y = found.bounds.min.y,
                 .max_x = found.bounds.max.x,
                 .max_y = found.bounds.max.y,
                 .attributes = {.source_id = found.source_id,
                                .weight = found.weight,
                                .breach_time = found.breach_time,
                                .destructible = found.destructible}};
    return true;
}
