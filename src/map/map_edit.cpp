#include "waybreaker/map_edit.hpp"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>

#include "map/describe.hpp"
#include "map/require_on_map.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {

MapEdit MapEdit::remove(ObstacleId obstacle) {
    return {.kind = Kind::remove, .obstacle = obstacle};
}
MapEdit MapEdit::add(std::vector<Cell> cells, const ObstacleAttributes& attributes) {
    return {.kind = Kind::add, .cells = std::move(cells), .attributes = attributes};
}
MapEdit MapEdit::extend(ObstacleId obstacle, std::vector<Cell> cells) {
    return {.kind = Kind::extend, .obstacle = obstacle, .cells = std::move(cells)};
}
MapEdit MapEdit::free(std::vector<Cell> cells) {
    return {.kind = Kind::free, .cells = std::move(cells)};
}

// Changes a copy that shares its rows until they change.
class Map::Editor {
  public:
    explicit Editor(Map& map) : map_(map) {
        map_.together_ = std::make_shared<Together>();
        map_.identity_ = std::make_shared<char>();
    }

    void apply(const MapEdit& edit) {
        ObstacleId obstacle;
        switch (edit.kind) {
            case MapEdit::Kind::remove:
                return remove(edit.obstacle);
            case MapEdit::Kind::add:
                obstacle = add(edit);
                break;
            case MapEdit::Kind::extend:
                require(edit.obstacle, "extend");
                obstacle = edit.obstacle;
                break;
            case MapEdit::Kind::free:
                break;
        }
        for (const Cell c : edit.cells) {
            require_on_map(map_.grid_, c);
            set(c, obstacle);
        }
        fit_bounds();
    }

  private:
    void require(ObstacleId id, const char* purpose) const {
        const bool there = id && id.value <= map_.obstacles_.size() && !map_.obstacle(id).gone();
        if (there) return;
        throw InputError(ErrorCode::unknown_obstacle, std::to_string(id.value),
                         "there is no obstacle " + std::to_string(id.value) + " to " + purpose);
    }

    void remove(ObstacleId id) {
        require(id, "remove");
        const Box box = map_.obstacle(id).bounds;
        for (Cell c = box.min; c.y <= box.max.y; ++c.y) {
            for (c.x = box.min.x; c.x <= box.max.x; ++c.x) {
                if (map_.obstacle_at(c) == id) set(c, {});
            }
        }
        fit_bounds();
    }

    ObstacleId add(const MapEdit& edit) {
        if (edit.cells.empty()) throw InputError("an obstacle that is added needs at least one cell");
        const ObstacleId id{std::uint32_t(map_.obstacles_.size() + 1)};
        map_.obstacles_.push_back({.id = id, .bounds = {edit.cells.front(), edit.cells.front()}});
        describe(map_.obstacles_.back(), edit.attributes, "of an obstacle that is added");
        return id;
    }

    std::uint32_t& label(Cell c) {
        std::uint32_t*& row = own_rows_[c.y];
        if (row == nullptr) {
            const auto copy = std::make_shared<std::uint32_t[]>(std::size_t(map_.width()));
            row = copy.get();
            std::ranges::copy(map_.labels(c.y), row);
            map_.rows_[std::size_t(c.y)] = copy;
        }
        return row[c.x];
    }

    void set(Cell c, ObstacleId to) {
        const ObstacleId from = map_.obstacle_at(c);
        if (from == to) return;
        for (const Cell beside : {Cell{c.x - 1, c.y}, Cell{c.x + 1, c.y}, Cell{c.x, c.y - 1}, Cell{c.x, c.y + 1}}) {
            const ObstacleId other = map_.grid_.contains(beside) ? map_.obstacle_at(beside) : ObstacleId{};
            if (!other) continue;
            if (from && other != from) --map_.touching_;
            if (to && other != to) ++map_.touching_;
        }
        label(c) = to.value;
        if (!from || !to) {
            map_.grid_.set_blocked(c, bool(to));
            map_.transposed_.set_blocked({c.y, c.x}, bool(to));
        }
        if (from) {
            --map_.obstacles_[from.value - 1].cells;
            shrunk_.push_back(from);
        }
        if (!to) return;
        Obstacle& obstacle = map_.obstacles_[to.value - 1];
        ++obstacle.cells;
        Box& box = obstacle.bounds;
        box = {{std::min(box.min.x, c.x), std::min(box.min.y, c.y)},
               {std::max(box.max.x, c.x), std::max(box.max.y, c.y)}};
    }

    // Of the obstacles that have lost cells.
    void fit_bounds() {
        std::ranges::sort(shrunk_);
        const auto repeated = std::ranges::unique(shrunk_);
        shrunk_.erase(repeated.begin(), repeated.end());
        for (const ObstacleId id : shrunk_) {
            Obstacle& obstacle = map_.obstacles_[id.value - 1];
            if (obstacle.gone()) {
                obstacle = {
                    .id = id, .bounds = {{0, 0}, {-1, -1}}, .destructible = false, .source_id = obstacle.source_id};
            } else {
                obstacle.bounds = fitted(id, obstacle.bounds);
            }
        }
        shrunk_.clear();
    }

    Box fitted(ObstacleId id, const Box& within) const {
        Box box{within.max, within.min};
        for (Cell c = within.min; c.y <= within.max.y; ++c.y) {
            for (c.x = within.min.x; c.x <= within.max.x; ++c.x) {
                if (map_.obstacle_at(c) != id) continue;
                box.min = {std::min(box.min.x, c.x), std::min(box.min.y, c.y)};
                box.max = {std::max(box.max.x, c.x), std::max(box.max.y, c.y)};
            }
        }
        return box;
    }

    Map& map_;
    std::unordered_map<int, std::uint32_t*> own_rows_;  // by y: those that are this map's alone
    std::vector<ObstacleId> shrunk_;
};

Map Map::with(const std::vector<MapEdit>& edits) const {
    Map map = *this;
    Editor editor(map);
    for (const MapEdit& edit : edits) editor.apply(edit);
    return map;
}

}  // namespace waybreaker
