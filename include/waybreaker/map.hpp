// Map: the immutable world of a mission, and OpenedMap: the same world with some obstacles gone.
//
// Paper, section 3: "a grid pre-processing is needed in order to assign the unique identifiers to all the obstacles".
#pragma once

#include <array>
#include <atomic>
#include <cassert>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "waybreaker/cell.hpp"
#include "waybreaker/grid.hpp"
#include "waybreaker/words.hpp"

namespace waybreaker {

enum class Connectivity { four, eight };
template <>
inline constexpr std::array<std::string_view, 2> words_of<Connectivity>{"4", "8"};

// What an obstacle can weigh, and the longest that its breach can take.
inline constexpr double least_weight = 1e-9;
inline constexpr double most_weight = 1e12;
inline constexpr double most_breach_time = 1e9;

// One obstacle: a connected set of blocked cells, or what a label layer or edits say.
struct Obstacle {
    ObstacleId id;
    std::uint32_t cells = 0;
    Box bounds;
    bool destructible = true;
    std::int64_t source_id = 0;  // who it is in the source, e.g. its OpenStreetMap id; 0 = unknown
    double weight = 1;           // what its removal counts for against a budget, least_weight to most_weight
    double breach_time = 0;      // how long its breach takes, beside what the mission says; 0 to most_breach_time

    // Whether edits took all its cells (Map::with). It keeps its id and source_id, its bounds are empty, and no plan
    // can remove it.
    bool gone() const { return cells == 0; }
};

// What a label layer knows of one of its labels; index it by label, entry 0 is not used.
struct ObstacleAttributes {
    bool destructible = true;
    std::int64_t source_id = 0;
    double weight = 1;
    double breach_time = 0;
};

struct MapEdit;  // map_edit.hpp

class Map {
  public:
    // Obstacles are the maximal connected sets of blocked cells (contract: 4-connected by default).
    // Time O(cells / 64 + runs); memory 4.3 bytes a cell and 56 an obstacle.
    explicit Map(Grid grid, Connectivity connectivity = Connectivity::four);

    // Obstacles are what the label layer says: width * height labels, row by row, 0 = free. Labels may be any numbers;
    // obstacles are numbered anew in scan order. `attributes[label]`, where given, describes the obstacle of that
    // label. Throws InputError if there are not width * height labels, or a size, weight or time is out of range.
    [[nodiscard]] static Map from_labels(int width, int height, std::vector<std::uint32_t> labels,
                                         std::span<const ObstacleAttributes> attributes = {});

    // From pictures of the rows, of one length: `.` is free, any other character a cell of the obstacle of that
    // character, whether its cells lie together or not. The obstacle's source_id is the character's code, 1 to 255;
    // ids are given in scan order, as always. Throws InputError for rows of different length, or none.
    [[nodiscard]] static Map from_rows(const std::vector<std::string>& rows);

    int width() const { return grid_.width(); }
    int height() const { return grid_.height(); }
    const Grid& grid() const { return grid_; }
    const Grid& transposed() const { return transposed_; }

    // All obstacles, in id order: obstacles()[0] has id 1.
    std::span<const Obstacle> obstacles() const { return obstacles_; }
    // Precondition: 1 <= id.value <= obstacles().size(), which builds with assertions check.
    const Obstacle& obstacle(ObstacleId id) const {
        assert(id.value >= 1 && id.value <= obstacles_.size());
        return obstacles_[id.value - 1];
    }
    // The obstacle at a cell; id 0 where it is free. Precondition: the cell is on the map (grid().contains(c)), which
    // builds with assertions check.
    ObstacleId obstacle_at(Cell c) const {
        assert(grid_.contains(c));
        return ObstacleId{rows_[std::size_t(c.y)].get()[c.x]};
    }
    // Whether cells of different obstacles lie side by side, as they can in a label layer.
    bool obstacles_touch() const { return touching_ > 0; }
    // Labels of a row, as obstacle_at gives them. Precondition: 0 <= y < height().
    std::span<const std::uint32_t> labels(int y) const { return {rows_[std::size_t(y)].get(), std::size_t(width())}; }
    // All of them, row by row. A map that edits made puts them together when first asked, in 4 bytes a cell.
    std::span<const std::uint32_t> labels() const {
        const std::vector<std::uint32_t>* all = together_->labels.load(std::memory_order_acquire);
        return all != nullptr ? *all : put_together();
    }

    // Equal for copies of one map, and for no others as long as somebody holds it: what is known of the map can be
    // kept.
    const std::shared_ptr<const void>& identity() const { return identity_; }

    // The map with its obstacles changed, in the order of the edits; this one stays as it is. All other obstacles keep
    // their ids. Time and memory: the rows of the cells that change, a quarter of a byte for each cell of the map and a
    // copy of the list of obstacles; rows that stay the same are shared. Throws InputError for cells off the map, for
    // obstacles that are not there, and for attributes out of range.
    [[nodiscard]] Map with(const std::vector<MapEdit>& edits) const;

    // The same map, its obstacles weighing that: weights[id], of every obstacle; entry 0 is not used. Throws InputError
    // unless there are obstacles().size() + 1 of them, from least_weight to most_weight where the obstacle is not gone.
    [[nodiscard]] Map with_weights(std::span<const double> weights) const;

    // Cells of the map outside the obstacle and 8-adjacent to one of its cells, in scan order. They may be free or
    // belong to other obstacles. Precondition: as of obstacle(id). Time O(bounding box).
    [[nodiscard]] std::vector<Cell> boundary(ObstacleId id) const;

  private:
    class Editor;
    // All labels in one piece; none before they are asked for.
    struct Together {
        std::atomic<const std::vector<std::uint32_t>*> labels = nullptr;
        Together() = default;
        Together(const Together&) = delete;
        Together& operator=(const Together&) = delete;
        ~Together() { delete labels.load(); }
    };

    Map(Grid&& grid, std::vector<std::uint32_t> labels);
    const std::vector<std::uint32_t>& put_together() const;

    Grid grid_;
    Grid transposed_;
    std::shared_ptr<Together> together_ = std::make_shared<Together>();
    std::vector<std::shared_ptr<const std::uint32_t[]>> rows_;  // of labels, shared with maps that have the same
    std::vector<Obstacle> obstacles_;
    std::size_t touching_ = 0;  // sides between cells of different obstacles
    std::shared_ptr<const void> identity_ = std::make_shared<char>();
};

// A view of a map with some obstacles removed: a value, cheap to make (it copies only the rows and columns that change)
// and to copy. The map must outlive it and does not move meanwhile.
class OpenedMap {
  public:
    // Precondition: every id names an obstacle of the map; repetitions are allowed.
    explicit OpenedMap(const Map& map, std::span<const ObstacleId> removed = {});
    // It would look at a map that is gone.
    explicit OpenedMap(const Map&& map, std::span<const ObstacleId> removed = {}) = delete;

    const Map& map() const { return *map_; }
    int width() const { return map_->width(); }
    int height() const { return map_->height(); }
    // In id order, each once.
    std::span<const ObstacleId> removed() const { return removed_; }

    // Cells up to one step outside the map may be asked for; they are blocked.
    bool blocked(Cell c) const {
        const std::size_t bit = std::size_t(c.x + 1);
        return (row(c.y)[bit / 64] >> (bit % 64)) & 1U;
    }
    // Bit x + 1 of row(y) and bit y + 1 of column(x) say whether cell (x, y) is blocked; as Grid::row.
    const std::uint64_t* row(int y) const { return rows_[std::size_t(y + 1)]; }
    const std::uint64_t* column(int x) const { return columns_[std::size_t(x + 1)]; }

  private:
    const Map* map_;
    std::vector<ObstacleId> removed_;
    std::vector<const std::uint64_t*> rows_;
    std::vector<const std::uint64_t*> columns_;
    std::shared_ptr<const std::uint64_t[]> opened_lines_;  // the rows and columns that differ from the map's
};

}  // namespace waybreaker
