#include "site/surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <utility>

#include "site/unknown_ground.hpp"

namespace waybreaker::site {
namespace {

// Whether a cell is one of those that are listed row by row.
bool holds(const std::vector<CellRun>& runs, Cell cell) {
    const auto after = std::ranges::upper_bound(
        runs, cell, [](Cell a, Cell b) { return std::pair(a.y, a.x) < std::pair(b.y, b.x); }, &CellRun::first);
    if (after == runs.begin()) return false;
    const CellRun& run = *std::prev(after);
    return run.first.y == cell.y && cell.x - run.first.x < run.length;
}

// After which shares of the way from one coordinate to another it meets a line between cells.
void add_meetings(double from, double to, std::vector<double>& shares) {
    const int first = int(std::floor(std::min(from, to) + 0.5));
    const int end = int(std::ceil(std::max(from, to) - 0.5));
    for (int cell = first; cell < end; ++cell) shares.push_back((cell + 0.5 - from) / (to - from));
}

// Calls visit(first, second, length) for each piece of a straight way within a cell; these differ where the piece lies
// on the line between two.
template <class Visit>
void for_each_piece(Point from, Point to, Visit visit) {
    std::vector<double> shares{0, 1};
    add_meetings(from.x, to.x, shares);
    add_meetings(from.y, to.y, shares);
    std::ranges::sort(shares);
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    for (std::size_t i = 1; i < shares.size(); ++i) {
        const double middle = (shares[i - 1] + shares[i]) / 2;
        const double x = from.x + middle * (to.x - from.x);
        const double y = from.y + middle * (to.y - from.y);
        visit(Cell{int(std::ceil(x - 0.5)), int(std::ceil(y - 0.5))},
              Cell{int(std::floor(x + 0.5)), int(std::floor(y + 0.5))}, (shares[i] - shares[i - 1]) * length);
    }
}

}  // namespace

Surface& Surface::operator+=(const Surface& other) {
    ways += other.ways;
    off_ways += other.off_ways;
    unknown += other.unknown;
    near_water = near_water && other.near_water ? std::optional(*near_water + *other.near_water) : std::nullopt;
    return *this;
}

std::string surface_text(const Surface& surface, double cell_size) {
    const auto metres = [cell_size](double cells) { return fmt::format("{:.0f} m", cells * cell_size); };
    constexpr double least = 0.5;  // metres; less is shown as none
    const auto shows = [=](double cells) { return cells * cell_size >= least; };
    std::string text = metres(surface.ways) + " on ways, " + metres(surface.off_ways) + " off ways";
    if (shows(surface.unknown)) text += ", " + metres(surface.unknown) + " on unknown ground";
    const double wet = surface.near_water.value_or(0);
    return shows(wet) ? fmt::format("{}; {} within {} m of water", text, metres(wet), near_water_metres) : text;
}

SurfaceMap::SurfaceMap(const Map& map, const Annotations& annotations, double cell_size)
    : map_(map), annotations_(annotations), unknown_obstacles_(unknown_obstacles(map, annotations.tags)) {
    constexpr double finest = 0.05;  // metres; a path over finer ones would look at too many
    const double reach = near_water_metres / cell_size;
    looks_for_water_ = cell_size >= finest;
    const bool has_water = std::ranges::find(annotations.kinds, ObstacleKind::water) != annotations.kinds.end();
    if (!looks_for_water_ || !has_water) return;
    constexpr double hair = 1e-6;  // metres
    const int rows = int(reach + 1);
    const auto aside = [](int cells) { return std::max(std::abs(cells) - 0.5, 0.0); };
    for (Cell step{0, -rows}; step.y <= rows; ++step.y) {
        for (step.x = -rows; step.x <= rows; ++step.x) {
            const double distance = std::hypot(aside(step.x), aside(step.y)) * cell_size;
            if (distance <= near_water_metres + hair) around_.push_back(step);
        }
    }
}

Surface SurfaceMap::along(std::span<const Point> path) const {
    Surface surface;
    double near = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        for_each_piece(path[i - 1], path[i], [&](Cell first, Cell second, double length) {
            if (is_unknown(first) || is_unknown(second)) {
                surface.unknown += length;
            } else if (holds(annotations_.ways, first) || holds(annotations_.ways, second)) {
                surface.ways += length;
            } else {
                surface.off_ways += length;
            }
            if (is_near_water(first) || is_near_water(second)) near += length;
        });
    }
    surface.near_water = looks_for_water_ ? std::optional(near) : std::nullopt;
    return surface;
}

bool SurfaceMap::is_unknown(Cell cell) const {
    if (!map_.grid().contains(cell)) return false;
    return holds(annotations_.unknown, cell) || unknown_obstacles_[map_.obstacle_at(cell).value];
}

bool SurfaceMap::is_near_water(Cell cell) const {
    return map_.grid().contains(cell) && std::ranges::any_of(around_, [&](Cell step) {
               const Cell other{cell.x + step.x, cell.y + step.y};
               return map_.grid().contains(other) &&
                      kind_of(annotations_.kinds, map_.obstacle_at(other)) == ObstacleKind::water;
           });
}

}  // namespace waybreaker::site
