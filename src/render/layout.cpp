#include "render/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/note_lines.hpp"
#include "render/palette.hpp"

namespace waybreaker::render {
namespace {

// In thousandths of the picture's width.
constexpr double header_height = 92;
constexpr double least_window_height = 110;
constexpr double most_window_height = 1400;
constexpr double largest_cell = 200;  // tiny maps stay small
constexpr double scale_bar_height = 52;
constexpr double attribution_height = 44;

// The largest of 1, 2, 5, 10, 20, ... that is not above `most`.
double round_number_below(double most) {
    const double power = std::pow(10, std::floor(std::log10(most)));
    for (const double digit : {5.0, 2.0}) {
        if (digit * power <= most) return digit * power;
    }
    return power;
}

}  // namespace

Layout lay_out(const Map& map, const PictureOptions& options, std::size_t legend_rows) {
    const double width = options.width;
    const double unit = width / 1000;
    const double window_width = width - 2 * size::margin * unit;
    const double cell =
        std::min({window_width / map.width(), most_window_height * unit / map.height(), largest_cell * unit});
    const double map_width = cell * map.width();
    const double map_height = cell * map.height();
    const double window_height = std::max(map_height, least_window_height * unit);
    const double top = header_height * unit;
    const double notes = double(note_lines(options.annotations.notes).size()) * size::note_row;
    const double footer = scale_bar_height + double(legend_rows) * size::row + notes + attribution_height;
    return {.width = width,
            .height = std::ceil(top + window_height + footer * unit),
            .unit = unit,
            .cell = cell,
            .sample_step = std::max(1, int(std::ceil(0.5 / cell))),
            .window = {size::margin * unit, top, window_width, window_height},
            .map = {(width - map_width) / 2, top + (window_height - map_height) / 2, map_width, map_height}};
}

ScaleBar scale_bar(const Layout& layout, const PictureOptions& options) {
    const double cells = std::max(1.0, 0.2 * layout.window.width / layout.cell);
    if (!options.metres) {
        const double length = round_number_below(cells);
        return {length * layout.cell, fmt::format("{:.0f} cell{}", length, length == 1 ? "" : "s")};
    }
    const double metres = round_number_below(cells * options.cell_size);
    const double length = metres / options.cell_size * layout.cell;
    return {length, metres >= 1000 ? fmt::format("{:g} km", metres / 1000) : fmt::format("{:g} m", metres)};
}

std::vector<Point> spread_labels(const std::vector<Point>& points, const std::vector<Point>& taken, double radius,
                                 Rectangle window) {
    std::vector<Point> discs = taken;
    const auto is_free = [&](Point p) {
        const bool visible =
            p.x >= window.x && p.x <= window.x + window.width && p.y >= window.y && p.y <= window.y + window.height;
        return visible && std::none_of(discs.begin(), discs.end(),
                                       [&](Point q) { return std::hypot(p.x - q.x, p.y - q.y) < 2.2 * radius; });
    };
    for (const Point& point : points) {
        Point place = point;
        for (int attempt = 0; attempt < 36 && !is_free(place); ++attempt) {  // twelve directions, three distances
            const double angle = std::numbers::pi / 6 * (attempt % 12) - std::numbers::pi / 3;
            const int ring = attempt / 12;
            const double distance = radius * (2.5 + 1.5 * ring);
            place = {point.x + distance * std::cos(angle), point.y + distance * std::sin(angle)};
        }
        discs.push_back(place);
    }
    return {discs.begin() + std::ptrdiff_t(taken.size()), discs.end()};
}

}  // namespace waybreaker::render
