#include "geotiff/bridges_item.hpp"

#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "geotiff/take_until.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/grid.hpp"

namespace waybreaker::geotiff {
namespace {

// Three numbers with blanks between.
template <class Number>
std::optional<std::array<Number, 3>> three(std::string_view line) {
    std::array<Number, 3> numbers{};
    for (Number& number : numbers) {
        const std::string_view word = take_until(' ', line);
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
        if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    }
    return line.empty() ? std::optional(numbers) : std::nullopt;
}

// How many whole cells lie between two edges; empty if there is a rest.
std::optional<int> whole_cells(double length, double cell) {
    constexpr double hair = 1e-3;  // of a cell
    const double cells = length / cell;
    if (!(std::abs(cells) <= max_side) || std::abs(cells - std::round(cells)) > hair) return std::nullopt;
    return int(std::round(cells));
}

// The part of a run on a map of that size, if any.
std::optional<site::CellRun> within(std::int64_t x, std::int64_t y, std::int64_t length, int width, int height) {
    const std::int64_t first = std::max<std::int64_t>(x, 0);
    const std::int64_t end = std::min<std::int64_t>(x + length, width);
    if (y < 0 || y >= height || first >= end) return std::nullopt;
    return site::CellRun{{int(first), int(y)}, int(end - first)};
}

}  // namespace

std::string bridges_text(const std::vector<site::CellRun>& bridges, const std::array<double, 6>& transform) {
    if (bridges.empty()) return "";
    std::string text = fmt::format("{} {} {}", transform[0], transform[3], transform[1]);
    for (const auto& [first, length] : bridges) text += fmt::format("\n{} {} {}", first.x, first.y, length);
    return text;
}

std::vector<site::CellRun> read_bridges(GDALDataset& file, const std::array<double, 6>& transform, int width,
                                        int height, const std::string& name) {
    const char* const item = file.GetMetadataItem(bridges_item);
    std::string_view text = item ? item : "";
    std::vector<site::CellRun> bridges;
    if (text.empty()) return bridges;
    const auto refusal = [&name](const char* what) {
        return InputError(
            fmt::format("{}: its metadata item {} {}; drop the item with 'gdal_edit.py -mo {}=' or import "
                        "the map anew",
                        name, bridges_item, what, bridges_item));
    };
    const auto place = three<double>(take_until('\n', text));
    if (!place || !((*place)[2] > 0)) throw refusal("does not begin with the map's edges and the side of a cell");
    const auto [west, north, cell] = *place;
    const auto right = whole_cells(west - transform[0], cell);
    const auto down = whole_cells(transform[3] - north, cell);
    const bool same_cells = right && down && std::abs(cell - transform[1]) <= 1e-9 * cell;
    while (!text.empty()) {
        const auto run = three<std::int32_t>(take_until('\n', text));
        if (!run || std::min((*run)[0], (*run)[1]) < 0 || std::max((*run)[0], (*run)[1]) >= max_side || (*run)[2] < 1 ||
            (*run)[2] > max_side) {
            throw refusal("has a line that is no run of cells");
        }
        if (!same_cells) continue;
        if (const auto seen = within((*run)[0] + *right, (*run)[1] + *down, (*run)[2], width, height)) {
            bridges.push_back(*seen);
        }
    }
    return bridges;
}

}  // namespace waybreaker::geotiff
