#include "city/cell_runs.hpp"

namespace waybreaker::city {
namespace {

// Adds the cells of a part of a row that count, side by side.
template <class Counts>
void append(Cell first, int length, Counts counts, std::vector<site::CellRun>& runs) {
    bool before = false;
    for (Cell c = first; c.x < first.x + length; ++c.x) {
        const bool now = counts(c);
        if (now && !before) runs.push_back({c, 0});
        if (now) ++runs.back().length;
        before = now;
    }
}

}  // namespace

std::vector<site::CellRun> runs_of(const std::vector<std::uint32_t>& labels, const CellWindow& window) {
    std::vector<site::CellRun> runs;
    for (int y = 0; y < window.height; ++y) {
        const std::uint32_t* const row = labels.data() + std::size_t(y) * std::size_t(window.width);
        append(
            {0, y}, window.width, [row](Cell c) { return row[c.x] != 0; }, runs);
    }
    return runs;
}

std::vector<site::CellRun> open_parts(const std::vector<site::CellRun>& runs, const Map& map) {
    std::vector<site::CellRun> parts;
    for (const auto& [first, length] : runs) {
        append(
            first, length, [&map](Cell c) { return !map.grid().blocked(c); }, parts);
    }
    return parts;
}

}  // namespace waybreaker::city
