#include "request/map_edits.hpp"

#include <algorithm>
#include <climits>
#include <utility>

#include "io/json_field.hpp"
#include "io/relabel.hpp"
#include "request/plan_request.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::request {
namespace {

using io::JsonField;

constexpr int max_edits_depth = 4;

std::vector<CellRun> runs(const std::optional<JsonField>& field) {
    std::vector<CellRun> result;
    if (!field) return result;
    for (const JsonField& item : field->items()) {
        const std::vector<JsonField> parts = item.items();
        if (parts.size() != 3) item.fail("is not a run of cells, [x, y, length]");
        result.push_back({{int(parts[0].whole_number(0, INT_MAX)), int(parts[1].whole_number(0, INT_MAX))},
                          int(parts[2].whole_number(1, INT_MAX))});
    }
    return result;
}

void require_fit(const std::vector<CellRun>& runs, const Map& map, const std::string& list) {
    std::size_t cells = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const auto& [first, length] = runs[i];
        if (first.y >= map.height() || first.x >= map.width() || length > map.width() - first.x) {
            throw InputError("edits: " + list + "[" + std::to_string(i) + "] does not lie on the map");
        }
        cells += std::size_t(length);
    }
    if (cells > map.grid().cell_count()) throw InputError("edits: " + list + " has more cells than the map");
}

template <class Visit>
void for_each_cell(const std::vector<CellRun>& runs, Visit visit) {
    for (const CellRun& run : runs) {
        for (int x = 0; x < run.length; ++x) visit(Cell{run.first.x + x, run.first.y});
    }
}

Grid edited_grid(const Map& map, const MapEdits& edits) {
    Grid grid = map.grid();
    for_each_cell(edits.free, [&grid](Cell c) { grid.set_blocked(c, false); });
    for_each_cell(edits.block, [&grid](Cell c) { grid.set_blocked(c, true); });
    return grid;
}

// Whether the obstacles carry no information beyond which cells are blocked.
bool are_connected_sets(const io::MapFile& file, Connectivity connectivity) {
    const Map& map = file.map;
    const auto plain = [](const Obstacle& obstacle) {
        return obstacle.destructible && obstacle.source_id == 0 && obstacle.weight == 1 && obstacle.breach_time == 0;
    };
    const auto obstacles = map.obstacles();
    if (!file.annotations.names.empty() || !std::all_of(obstacles.begin(), obstacles.end(), plain)) return false;
    const Map seen(Grid(map.grid()), connectivity);
    return std::equal(seen.labels().begin(), seen.labels().end(), map.labels().begin());
}

// The labels of the edited map; drawn obstacles are numbered from `next` on.
std::vector<std::uint32_t> edited_labels(const Map& map, const MapEdits& edits, std::uint32_t next) {
    std::vector<std::uint32_t> labels(map.labels().begin(), map.labels().end());
    const auto at = [&map, &labels](Cell c) -> std::uint32_t& {
        return labels[std::size_t(c.y) * std::size_t(map.width()) + std::size_t(c.x)];
    };
    for_each_cell(edits.free, [&at](Cell c) { at(c) = 0; });
    Grid drawn(map.width(), map.height());
    for_each_cell(edits.block, [&](Cell c) {
        if (at(c) == 0) drawn.set_blocked(c, true);
    });
    const Map walls(std::move(drawn));
    for_each_cell(edits.block, [&](Cell c) {
        const ObstacleId wall = walls.obstacle_at(c);
        if (wall.value != 0) at(c) = next + wall.value - 1;
    });
    return labels;
}

}  // namespace

MapEdits parse_map_edits(std::string_view bytes, const std::string& name) {
    if (bytes.size() > max_request_bytes) throw InputError(name, 0, "is too large");
    const auto document = io::parse_json(bytes, name, max_edits_depth);
    const JsonField root(document);
    root.allow({"block", "free"});
    return {.block = runs(root.find("block")), .free = runs(root.find("free"))};
}

EditedMap edited_map(const io::MapFile& file, Connectivity connectivity, const MapEdits& edits) {
    const Map& before = file.map;
    require_fit(edits.block, before, "block");
    require_fit(edits.free, before, "free");
    EditedMap result{.file = file, .plain = are_connected_sets(file, connectivity)};
    result.file.digest.clear();
    if (result.plain) {
        result.file.map = Map(edited_grid(before, edits), connectivity);
    } else {
        io::relabel(result.file, edited_labels(before, edits, std::uint32_t(before.obstacles().size()) + 1));
    }
    return result;
}

}  // namespace waybreaker::request
