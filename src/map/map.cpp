#include "waybreaker/map.hpp"

#include <algorithm>
#include <bit>
#include <string>
#include <unordered_map>

#include "core/range.hpp"
#include "map/bit_run.hpp"
#include "map/describe.hpp"
#include "map/label.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {

// The grid is only taken once it is labelled: binding a reference moves nothing.
Map::Map(Grid grid, Connectivity connectivity) : Map(std::move(grid), label_components(grid, connectivity)) {}

Map::Map(Grid&& grid, std::vector<std::uint32_t> labels) : grid_(std::move(grid)), transposed_(grid_.transposed()) {
    together_->labels = new std::vector<std::uint32_t>(std::move(labels));
    const std::span<const std::uint32_t> all = this->labels();
    for (std::size_t y = 0; y < std::size_t(height()); ++y) {
        rows_.emplace_back(together_, all.data() + y * std::size_t(width()));
    }
    obstacles_.reserve(*std::max_element(all.begin(), all.end()));  // they can be most of the map's memory
    for (int y = 0; y < height(); ++y) {
        const std::span<const std::uint32_t> row = this->labels(y);
        for_each_run(grid_.row(y), width(), [&](int first, int last) {
            // A run of blocked cells can hold several obstacles where the labels come from outside.
            while (first <= last) {
                const ObstacleId id{row[std::size_t(first)]};
                int end = first + 1;
                while (end <= last && row[std::size_t(end)] == id.value) ++end;
                const std::uint32_t before = first > 0 ? row[std::size_t(first - 1)] : 0;
                if (before != 0 && before != id.value) ++touching_;
                if (id.value > obstacles_.size()) obstacles_.push_back({.id = id, .bounds = {{first, y}, {first, y}}});
                Obstacle& obstacle = obstacles_[id.value - 1];
                obstacle.cells += std::uint32_t(end - first);
                obstacle.bounds.min.x = std::min(obstacle.bounds.min.x, first);
                obstacle.bounds.max.x = std::max(obstacle.bounds.max.x, end - 1);
                obstacle.bounds.max.y = y;
                first = end;
            }
        });
    }
}

Map Map::from_labels(int width, int height, std::vector<std::uint32_t> labels,
                     std::span<const ObstacleAttributes> attributes) {
    Grid grid(width, height);
    if (labels.size() != grid.cell_count()) {
        throw InputError("a label map of " + std::to_string(width) + " x " + std::to_string(height) + " cells needs " +
                         std::to_string(grid.cell_count()) + " labels, not " + std::to_string(labels.size()));
    }
    std::unordered_map<std::uint32_t, std::uint32_t> id_of_label;
    std::vector<std::uint32_t> label_of_id;
    std::size_t touching = 0;  // one above the other
    std::uint32_t* label = labels.data();
    for (int y = 0; y < height; ++y) {
        std::uint32_t last_label = 0;
        std::uint32_t last_id = 0;
        for (int x = 0; x < width; ++x, ++label) {
            if (*label == 0) continue;
            if (*label != last_label) {
                const auto [known, is_new] = id_of_label.try_emplace(*label, std::uint32_t(label_of_id.size() + 1));
                if (is_new) label_of_id.push_back(*label);
                last_label = *label;
                last_id = known->second;
            }
            *label = last_id;
            const std::uint32_t above = y > 0 ? *(label - width) : 0;
            if (above != 0 && above != last_id) ++touching;
            grid.set_blocked({x, y}, true);
        }
    }
    Map map(std::move(grid), std::move(labels));
    map.touching_ += touching;
    for (Obstacle& obstacle : map.obstacles_) {
        const std::uint32_t source_label = label_of_id[obstacle.id.value - 1];
        if (source_label >= attributes.size()) continue;
        const ObstacleAttributes& given = attributes[source_label];
        describe(obstacle, given, "of label " + std::to_string(source_label));
    }
    return map;
}

Map Map::from_rows(const std::vector<std::string>& rows) {
    if (rows.empty()) throw InputError("a map needs at least one row");
    const std::size_t width = rows.front().size();
    std::vector<std::uint32_t> labels;
    for (std::size_t y = 0; y < rows.size(); ++y) {
        if (rows[y].size() != width) {
            throw InputError("row " + std::to_string(y) + " of the map has " + std::to_string(rows[y].size()) +
                             " cells, and row 0 has " + std::to_string(width));
        }
        for (const char tile : rows[y]) labels.push_back(tile == '.' ? 0U : static_cast<unsigned char>(tile) + 1U);
    }
    std::vector<ObstacleAttributes> tiles(257);  // by label, which is the character's code and 1
    for (std::size_t label = 1; label < tiles.size(); ++label) tiles[label].source_id = std::int64_t(label) - 1;
    constexpr std::size_t too_long = max_side + 1;
    return from_labels(int(std::min(width, too_long)), int(std::min(rows.size(), too_long)), std::move(labels), tiles);
}

Map Map::with_weights(std::span<const double> weights) const {
    if (weights.size() != obstacles_.size() + 1) {
        throw InputError("weights are needed for all " + std::to_string(obstacles_.size()) +
                         " obstacles, by id, not for " + std::to_string(std::max<std::size_t>(weights.size(), 1) - 1));
    }
    Map map = *this;
    for (Obstacle& obstacle : map.obstacles_) {
        if (obstacle.gone()) continue;
        const double weight = weights[obstacle.id.value];
        require_range(weight, least_weight, most_weight, "the weight of obstacle " + std::to_string(obstacle.id.value));
        obstacle.weight = weight;
    }
    return map;
}

// Where two threads make them at once, those of one are kept.
const std::vector<std::uint32_t>& Map::put_together() const {
    auto made = std::make_unique<std::vector<std::uint32_t>>();
    made->reserve(grid_.cell_count());
    for (int y = 0; y < height(); ++y) {
        const std::span<const std::uint32_t> row = labels(y);
        made->insert(made->end(), row.begin(), row.end());
    }
    const std::vector<std::uint32_t>* kept = nullptr;
    return together_->labels.compare_exchange_strong(kept, made.get()) ? *made.release() : *kept;
}

std::vector<Cell> Map::boundary(ObstacleId id) const {
    const Box& bounds = obstacle(id).bounds;
    const Cell first{std::max(bounds.min.x - 1, 0), std::max(bounds.min.y - 1, 0)};
    const Cell last{std::min(bounds.max.x + 1, width() - 1), std::min(bounds.max.y + 1, height() - 1)};

    // The obstacle's cells as rows of bits, a word of 64 at a time: bit x - first.x + 64 of a row is cell x. The first
    // and last word of a row stay empty.
    const std::size_t words = std::size_t(last.x - first.x) / 64 + 3;
    using BitRow = std::vector<std::uint64_t>;
    const auto read = [&](int y, BitRow& row) {
        std::fill(row.begin(), row.end(), 0);
        if (y < bounds.min.y || y > bounds.max.y) return;
        const std::uint32_t* labels = this->labels(y).data();
        for (std::size_t word = 1; word + 1 < words; ++word) {
            const int begin = first.x + int(word - 1) * 64;
            for (int x = std::min(begin + 63, last.x); x >= begin; --x) {
                row[word] = row[word] << 1 | std::uint64_t{labels[x] == id.value};
            }
        }
    };
    BitRow above(words);
    BitRow here(words);
    BitRow below(words);
    read(first.y, below);
    std::vector<Cell> cells;
    for (int y = first.y; y <= last.y; ++y) {
        std::swap(above, here);
        std::swap(here, below);
        read(y + 1, below);
        const auto column = [&](std::size_t word) { return above[word] | here[word] | below[word]; };
        for (std::size_t word = 1; word + 1 < words; ++word) {
            const std::uint64_t near = column(word);
            std::uint64_t touched = near | near << 1 | near >> 1 | column(word - 1) >> 63 | column(word + 1) << 63;
            for (touched &= ~here[word]; touched != 0; touched &= touched - 1) {
                const int x = first.x + int(word - 1) * 64 + std::countr_zero(touched);
                if (x <= last.x) cells.push_back({x, y});
            }
        }
    }
    return cells;
}

}  // namespace waybreaker
