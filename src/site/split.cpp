#include "site/split.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "waybreaker/error.hpp"

namespace waybreaker::site {
namespace {

constexpr std::int64_t least_share = 20;  // a square that clears less than one in so many of its cells joins another

// The squares of a lattice that a map touches, row by row.
class Squares {
  public:
    Squares(const Map& map, const Lattice& lattice)
        : side_(lattice.side),
          left_(first_corner(lattice.origin.x)),
          top_(first_corner(lattice.origin.y)),
          columns_(std::size_t(map.width() - 1 - left_) / std::size_t(side_) + 1),
          rows_(std::size_t(map.height() - 1 - top_) / std::size_t(side_) + 1) {}

    std::int64_t area() const { return std::int64_t{side_} * side_; }  // of each, in cells
    std::size_t count() const { return columns_ * rows_; }
    std::size_t columns() const { return columns_; }
    std::size_t rows() const { return rows_; }
    std::size_t at(Cell c) const {
        return std::size_t(c.y - top_) / std::size_t(side_) * columns_ + std::size_t(c.x - left_) / std::size_t(side_);
    }
    // May reach beyond the map.
    Box box(std::size_t square) const {
        const Cell min{left_ + int(square % columns_) * side_, top_ + int(square / columns_) * side_};
        return {min, {min.x + side_ - 1, min.y + side_ - 1}};
    }
    // The last column of the square that column x is in.
    int last_in_square(int x) const { return x + side_ - 1 - (x - left_) % side_; }

  private:
    // The last corner of a lattice that is not behind cell 0: -side < corner <= 0.
    int first_corner(int origin) const {
        const int rest = origin % side_;
        return rest > 0 ? rest - side_ : rest;
    }

    int side_;
    int left_;
    int top_;
    std::size_t columns_;
    std::size_t rows_;
};

bool is_destructible(const Map& map, Cell c) {
    const ObstacleId id = map.obstacle_at(c);
    return id.value != 0 && map.obstacle(id).destructible;
}

// Calls `visit(square, id, cells)` for runs of cells of one destructible obstacle in one row of a square.
template <class Visit>
void for_each_run_in_square(const Map& map, const Squares& squares, Visit visit) {
    for (Cell c; c.y < map.height(); ++c.y) {
        for (c.x = 0; c.x < map.width();) {
            const Cell first = c;
            const ObstacleId id = map.obstacle_at(c);
            const int end = std::min(squares.last_in_square(c.x) + 1, map.width());
            while (++c.x < end && map.obstacle_at(c) == id) {
            }
            if (id.value == 0 || !map.obstacle(id).destructible) continue;
            visit(squares.at(first), id, std::uint32_t(c.x - first.x));
        }
    }
}

// How many destructible cells of a square lie beside one of the square that is one step away.
int contact(const Map& map, const Squares& squares, std::size_t square, Cell step) {
    const Box box = squares.box(square);
    // The row or column of the square along its neighbour.
    const Cell from{step.x > 0 ? box.max.x : box.min.x, step.y > 0 ? box.max.y : box.min.y};
    const Cell to{step.x < 0 ? box.min.x : box.max.x, step.y < 0 ? box.min.y : box.max.y};
    int count = 0;
    for (Cell c = from; c.y <= to.y; ++c.y) {
        for (c.x = from.x; c.x <= to.x; ++c.x) {
            const Cell beyond{c.x + step.x, c.y + step.y};
            if (!map.grid().contains(c) || !map.grid().contains(beyond)) continue;
            count += is_destructible(map, c) && is_destructible(map, beyond) ? 1 : 0;
        }
    }
    return count;
}

// For each square the one that its cells go to: itself, or a neighbour.
std::vector<std::uint32_t> joined(const Map& map, const Squares& squares) {
    std::vector<std::uint32_t> cells(squares.count(), 0);
    for_each_run_in_square(map, squares, [&](std::size_t square, ObstacleId, std::uint32_t n) { cells[square] += n; });
    std::vector<std::uint32_t> goes_to(squares.count());
    std::iota(goes_to.begin(), goes_to.end(), 0U);
    std::vector<bool> paired(squares.count(), false);
    for (std::size_t i = 0; i < squares.count(); ++i) {
        if (cells[i] == 0 || least_share * cells[i] >= squares.area() || paired[i]) continue;
        const std::size_t column = i % squares.columns();
        const std::size_t row = i / squares.columns();
        int most = 0;
        const auto consider = [&](bool exists, std::size_t neighbour, Cell step) {
            if (!exists || paired[neighbour]) return;
            const int count = contact(map, squares, i, step);
            if (count <= most) return;
            most = count;
            goes_to[i] = std::uint32_t(neighbour);
        };
        consider(row > 0, i - squares.columns(), {0, -1});
        consider(column > 0, i - 1, {-1, 0});
        consider(column + 1 < squares.columns(), i + 1, {1, 0});
        consider(row + 1 < squares.rows(), i + squares.columns(), {0, 1});
        if (most > 0) paired[i] = paired[goes_to[i]] = true;
    }
    return goes_to;
}

// The cells that a section has of an obstacle.
struct Part {
    std::size_t square;
    ObstacleId of;
    std::uint32_t cells;
};

// By square, most cells first.
std::vector<Part> parts_of(const Map& map, const Squares& squares, const std::vector<std::uint32_t>& goes_to) {
    std::unordered_map<std::uint64_t, std::uint32_t> cells;  // by square and obstacle
    const std::uint64_t ids = map.obstacles().size() + 1;
    for_each_run_in_square(map, squares, [&](std::size_t square, ObstacleId id, std::uint32_t count) {
        cells[std::uint64_t{goes_to[square]} * ids + id.value] += count;
    });
    std::vector<Part> parts;
    parts.reserve(cells.size());
    for (const auto& [key, count] : cells) parts.push_back({std::size_t(key / ids), {std::uint32_t(key % ids)}, count});
    std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
        return std::tuple(a.square, b.cells, a.of.value) < std::tuple(b.square, a.cells, b.of.value);
    });
    return parts;
}

ObstacleAttributes attributes_of(const Map& map, std::span<const Part> parts, bool weighed) {
    ObstacleAttributes section{.source_id = map.obstacle(parts.front().of).source_id};
    double weight = 0;
    for (const Part& part : parts) {
        const Obstacle& whole = map.obstacle(part.of);
        const double share = double(part.cells) / whole.cells;
        weight += share * whole.weight;
        section.breach_time += share * whole.breach_time;
    }
    if (weighed) section.weight = std::clamp(weight, least_weight, most_weight);
    section.breach_time = std::min(section.breach_time, most_breach_time);
    return section;
}

// All names, each once.
std::string name_of(const Annotations& annotations, std::span<const Part> parts) {
    std::vector<std::string_view> called;
    for (const Part& part : parts) {
        const std::string_view name = annotations.name_of(part.of);
        if (!name.empty() && std::find(called.begin(), called.end(), name) == called.end()) called.push_back(name);
    }
    std::string text;
    for (const std::string_view name : called) text.append(text.empty() ? "" : ", ").append(name);
    return text;
}

// Makes structures of what is destructible; gives their positions, by obstacle id.
std::vector<std::uint32_t> append_structures(const Map& map, const Annotations& annotations, LabelLayer& layer) {
    std::vector<std::uint32_t> positions(map.obstacles().size() + 1, 0);
    for (const Obstacle& o : map.obstacles()) {
        if (!o.destructible) continue;
        positions[o.id.value] = std::uint32_t(layer.structures.size());
        layer.structures.push_back(
            {kind_of(annotations.kinds, o.id), o.source_id, std::string(annotations.name_of(o.id))});
    }
    return positions;
}

}  // namespace

DescribedMap split(const Map& map, const Annotations& annotations, const Lattice& lattice) {
    if (lattice.side < 1) throw InputError("a section needs a side of at least one cell");
    const Squares squares(map, {std::min(lattice.side, max_side), lattice.origin});
    const std::vector<std::uint32_t> goes_to = joined(map, squares);
    const std::vector<Part> parts = parts_of(map, squares, goes_to);
    const bool weighed = std::any_of(map.obstacles().begin(), map.obstacles().end(),
                                     [](const Obstacle& o) { return o.destructible && o.weight != 1; });
    LabelLayer layer = label_layer(map, annotations);
    const LabelTags tags_of_whole = layer.tags;
    const auto tags_of = by_label(tags_of_whole);
    const std::vector<std::uint32_t> structures = append_structures(map, annotations, layer);
    std::vector<std::uint32_t> label_of(squares.count(), 0);
    for (auto first = parts.begin(); first != parts.end();) {
        const auto end =
            std::find_if(first, parts.end(), [&](const Part& part) { return part.square != first->square; });
        const std::span<const Part> section(first, end);
        const auto label = std::uint32_t(layer.attributes.size());
        label_of[first->square] = label;
        layer.attributes.push_back(attributes_of(map, section, weighed));
        if (std::string name = name_of(annotations, section); !name.empty()) {
            layer.names.emplace(label, std::move(name));
        }
        if (!annotations.kinds.empty()) layer.kinds.emplace(label, kind_of(annotations.kinds, first->of));
        std::vector<std::uint32_t>& of = layer.parts[label];
        for (const Part& part : section) {
            of.push_back(structures[part.of.value]);
            const auto said = tags_of.find(part.of.value);
            if (said == tags_of.end()) continue;
            for (const std::string* tag : said->second) layer.tags[*tag].push_back(label);
        }
        std::sort(of.begin(), of.end());
        first = end;
    }
    std::uint32_t* cell = layer.labels.data();
    for (Cell c; c.y < map.height(); ++c.y) {
        for (c.x = 0; c.x < map.width(); ++c.x, ++cell) {
            if (is_destructible(map, c)) *cell = label_of[goes_to[squares.at(c)]];
        }
    }
    return described(std::move(layer), annotations);
}

}  // namespace waybreaker::site
