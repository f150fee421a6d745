// Zones: areas of the map that agents keep out of, as polygons.
//
//     Zone airport{.kind = ZoneKind::no_fly, .polygon = {{{40, 10}, {90, 10}, {90, 60}, {40, 60}}}, .name = "airport"};
//     mission.rules.zones.push_back(airport);
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "waybreaker/cell.hpp"
#include "waybreaker/words.hpp"

namespace waybreaker {

// `no_fly`: aircraft fly round it. `keep_out`: vehicles drive round it.
enum class ZoneKind { no_fly, keep_out };
template <>
inline constexpr std::array<std::string_view, 2> words_of<ZoneKind>{"no_fly", "keep_out"};

// Corners of polygons count to 1 / zone_steps of a cell, to which planning rounds them; what follows is exact.
inline constexpr int zone_steps = 4096;
inline constexpr double most_zone_coordinate = 65536;   // cells, and as far below 0
inline constexpr std::size_t most_zone_corners = 2000;  // of all zones of a mission

// Its interior is forbidden while it holds; its outline is not.
struct Zone {
    ZoneKind kind = ZoneKind::no_fly;
    // The outline, then holes if it has any, each as its corners in either direction; the first one is not repeated at
    // the end. In cell units, on the map or off it.
    std::vector<std::vector<Point>> polygon = {};
    std::string name = {};                 // for people; may be empty
    std::vector<std::string> agents = {};  // whom it holds for; empty: every agent of its kind
    // It holds between these times of the mission, in units of time: 0 <= from < until. By default all the time.
    double from = 0;
    double until = std::numeric_limits<double>::infinity();

    // Whether it holds for a time only: it has a window.
    bool has_window() const { return from > 0 || until < std::numeric_limits<double>::infinity(); }
    bool holds_at(double time) const { return !has_window() || (from < time && time < until); }

    friend bool operator==(const Zone&, const Zone&) = default;
};

// Throws InputError, naming the zone and what is wrong, if its polygon is none: fewer than three corners in a ring, a
// ring that crosses or touches itself or another, a hole outside the outline, corners too far away; or its window is
// none. `number`: which zone of a mission it is, from 1.
void validate(const Zone& zone, std::size_t number);

// "the zone 'airport'", or by its number where it has no name; with its window, if it has one: "zone 2 (from 10 until
// 20)".
[[nodiscard]] std::string name_of(const Zone& zone, std::size_t number);

}  // namespace waybreaker
