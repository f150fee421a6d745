#include "labels/cells_item.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "labels/take_until.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/grid.hpp"

namespace waybreaker::labels {
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

void append(std::uint32_t number, std::vector<std::uint8_t>& bytes) {
    constexpr std::uint32_t more = 0x80;
    for (; number >= more; number /= more) bytes.push_back(std::uint8_t(number % more | more));
    bytes.push_back(std::uint8_t(number));
}

// The next number, which goes; empty if there is none below `max_side` + 1.
std::optional<std::uint32_t> take_number(std::span<const std::uint8_t>& bytes) {
    std::uint32_t number = 0;
    for (std::uint32_t unit = 1; !bytes.empty() && unit <= max_side; unit *= 0x80) {
        const std::uint32_t byte = bytes.front();
        bytes = bytes.subspan(1);
        number += byte % 0x80 * unit;
        if (byte < 0x80) return number <= max_side ? std::optional(number) : std::nullopt;
    }
    return std::nullopt;
}

using Run = std::array<std::int32_t, 3>;  // column, row, length

// Nothing if that is no list of runs.
std::vector<Run> packed_runs(std::string_view digits, const Inflate& inflate) {
    constexpr std::size_t most = std::size_t{1} << 26;
    const std::vector<std::uint8_t> bytes = inflate(digits, most);
    std::vector<Run> runs;
    std::int32_t end = 0;
    std::int32_t row = 0;
    for (std::span<const std::uint8_t> rest = bytes; !rest.empty();) {
        const auto down = take_number(rest);
        const auto right = take_number(rest);
        const auto length = take_number(rest);
        if (!down || !right || !length) return {};
        if (*down > 0) end = 0;
        row += std::int32_t(*down);
        runs.push_back({end + std::int32_t(*right), row, std::int32_t(*length)});
        end = runs.back()[0] + runs.back()[2];
        if (row >= max_side || end > max_side) return {};
    }
    return runs;
}

// Likewise, of a line for each run.
std::vector<Run> listed_runs(std::string_view text) {
    std::vector<Run> runs;
    while (!text.empty()) {
        const auto run = three<std::int32_t>(take_until('\n', text));
        if (!run || std::min((*run)[0], (*run)[1]) < 0 || std::max((*run)[0], (*run)[1]) >= max_side ||
            (*run)[2] > max_side) {
            return {};
        }
        runs.push_back(*run);
    }
    return runs;
}

}  // namespace

std::string cells_text(const std::vector<site::CellRun>& runs, const std::array<double, 6>& transform,
                       const Deflate& deflate) {
    if (runs.empty()) return "";
    std::vector<std::uint8_t> bytes;
    Cell after;  // the end of the run before
    for (const auto& [first, length] : runs) {
        append(std::uint32_t(first.y - after.y), bytes);
        append(std::uint32_t(first.y == after.y ? first.x - after.x : first.x), bytes);
        append(std::uint32_t(length), bytes);
        after = {first.x + length, first.y};
    }
    return fmt::format("{} {} {}\n{}", transform[0], transform[3], transform[1], deflate(bytes));
}

std::vector<site::CellRun> read_cells(std::string_view text, const char* item, const std::array<double, 6>& transform,
                                      int width, int height, const Inflate& inflate, const std::string& name) {
    std::vector<site::CellRun> cells;
    if (text.empty()) return cells;
    const auto refusal = [&](const char* what) {
        return InputError(
            fmt::format("{}: its metadata item {} {}; drop the item with 'gdal_edit.py -mo {}=' or import "
                        "the map anew",
                        name, item, what, item));
    };
    const auto place = three<double>(take_until('\n', text));
    if (!place || !((*place)[2] > 0)) throw refusal("does not begin with the map's edges and the side of a cell");
    const auto [west, north, cell] = *place;
    const auto right = whole_cells(west - transform[0], cell);
    const auto down = whole_cells(transform[3] - north, cell);
    const std::vector<Run> runs =
        text.find(' ') == std::string_view::npos ? packed_runs(text, inflate) : listed_runs(text);
    if (runs.empty() || std::ranges::any_of(runs, [](const Run& run) { return run[2] < 1; })) {
        throw refusal("lists no runs of cells");
    }
    if (!right || !down || std::abs(cell - transform[1]) > 1e-9 * cell) return cells;
    for (const auto& [x, y, length] : runs) {
        if (const auto seen = within(x + *right, y + *down, length, width, height)) cells.push_back(*seen);
    }
    return cells;
}

}  // namespace waybreaker::labels
