// How the ground agent is shaped and moves (contract, section 2).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "waybreaker/map.hpp"
#include "waybreaker/words.hpp"

namespace waybreaker {

// Which blocked side cells a diagonal step may pass. `none`: neither; `cut`: one; `squeeze`: both.
enum class Corners { none, cut, squeeze };
template <>
inline constexpr std::array<std::string_view, 3> words_of<Corners>{"none", "cut", "squeeze"};

// What an agent is, to the ground it moves on.
struct Body {
    // Of the disc, in cells: 0.001 to 32, rounded to thousandths. 0 is a point that slips between diagonal neighbours.
    double radius = 0.5;
    // Other than `none` the agent is a point, and its radius is left at 0.5.
    Corners corners = Corners::none;

    // What its diagonal steps pass: a point of radius 0 squeezes through.
    constexpr Corners passes() const { return radius == 0 ? Corners::squeeze : corners; }
    constexpr bool is_point() const { return passes() != Corners::none; }
    // The radius of the disc, in thousandths of a cell; 0 for a point.
    constexpr std::int64_t thousandths() const {
        if (is_point()) return 0;
        const auto whole = std::int64_t(radius * 1000);
        return whole + (radius * 1000 - double(whole) >= 0.5 ? 1 : 0);  // std::llround is no constant expression
    }
    // The same in cells.
    constexpr double reach() const { return double(thousandths()) / 1000; }
    friend bool operator==(const Body&, const Body&) = default;
};

inline constexpr Body point_body{.radius = 0};

// Throws InputError, naming what is wrong, if the members contradict each other or are out of range.
void validate(const Body& body);

// Whether the agent can stand on a cell; a point can wherever the cell is free, nobody off the map. Throws as validate
// does.
bool fits(const OpenedMap& map, Cell at, const Body& body = {});

// Whether the agent can move straight from one cell centre to another: exact, in integers. False where it does not fit
// on either end. Throws as validate does. Time O(distance), times the radius for a wide disc.
// Laws: line_of_sight(m, a, b) == line_of_sight(m, b, a); line_of_sight(m, a, a) == fits(m, a).
bool line_of_sight(const OpenedMap& map, Cell from, Cell to, const Body& body = {});

}  // namespace waybreaker
