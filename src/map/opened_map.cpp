#include <algorithm>
#include <cassert>

#include "waybreaker/map.hpp"

namespace waybreaker {
namespace {

// Marks the lines (rows or columns) that lie inside a box, one side of it given.
void mark(std::vector<bool>& changed, int first, int last) {
    std::fill(changed.begin() + first, changed.begin() + last + 1, true);
}

}  // namespace

OpenedMap::OpenedMap(const Map& map, std::span<const ObstacleId> removed)
    : map_(&map), removed_(removed.begin(), removed.end()) {
    std::sort(removed_.begin(), removed_.end());
    removed_.erase(std::unique(removed_.begin(), removed_.end()), removed_.end());
    rows_.reserve(std::size_t(height()) + 2);
    columns_.reserve(std::size_t(width()) + 2);
    for (int y = -1; y <= height(); ++y) rows_.push_back(map.grid().row(y));
    for (int x = -1; x <= width(); ++x) columns_.push_back(map.transposed().row(x));
    if (removed_.empty()) return;

    std::vector<bool> changed_row(std::size_t(height()), false);
    std::vector<bool> changed_column(std::size_t(width()), false);
    for (const ObstacleId id : removed_) {
        assert(id.value >= 1 && id.value <= map.obstacles().size());
        const Box& bounds = map.obstacle(id).bounds;
        mark(changed_row, bounds.min.y, bounds.max.y);
        mark(changed_column, bounds.min.x, bounds.max.x);
    }
    const std::size_t row_words = map.grid().words_per_row();
    const std::size_t column_words = map.transposed().words_per_row();
    const auto count = [](const std::vector<bool>& marks) {
        return std::size_t(std::count(marks.begin(), marks.end(), true));
    };
    // One spare word, as at the end of a Grid.
    const std::size_t words = count(changed_row) * row_words + count(changed_column) * column_words + 1;
    const auto lines = std::make_shared<std::uint64_t[]>(words);
    std::uint64_t* next = lines.get();
    const auto copy_changed = [&next](const std::vector<bool>& changed, std::size_t words_per_line, auto& line_of) {
        for (std::size_t i = 0; i < changed.size(); ++i) {
            if (!changed[i]) continue;
            std::copy_n(line_of[i + 1], words_per_line, next);
            line_of[i + 1] = next;
            next += words_per_line;
        }
    };
    copy_changed(changed_row, row_words, rows_);
    copy_changed(changed_column, column_words, columns_);

    const auto clear = [&lines](const std::uint64_t* line, int position) {
        std::uint64_t* writable = lines.get() + (line - lines.get());
        writable[(position + 1) / 64] &= ~(std::uint64_t{1} << ((position + 1) % 64));
    };
    for (const ObstacleId id : removed_) {
        const Box& bounds = map.obstacle(id).bounds;
        for (Cell c = bounds.min; c.y <= bounds.max.y; ++c.y) {
            const auto labels = map.labels(c.y);
            for (c.x = bounds.min.x; c.x <= bounds.max.x; ++c.x) {
                if (labels[std::size_t(c.x)] != id.value) continue;
                clear(row(c.y), c.x);
                clear(column(c.x), c.y);
            }
        }
    }
    opened_lines_ = lines;
}

}  // namespace waybreaker
