// What the removal of obstacles destroys.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "site/sections.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::site {

struct Demolition {
    std::size_t removals = 0;
    std::uint64_t cells = 0;
    std::vector<std::uint32_t> structures = {};  // that lose something: positions in Sections::structures
};

// REQUIRES: the map has these obstacles.
Demolition demolition(const Map& map, const Sections& sections, std::span<const ObstacleId> removed);

// "3 openings", or for whole obstacles "3 obstacles removed"; and with where they are: "3 openings in 2 buildings".
std::string removals_text(const Demolition& demolition);
std::string removals_text(const Demolition& demolition, const Sections& sections);

// With a unit, of an area in square metres: "640 m²", "3.25 m²".
std::string area_text(double square_metres);

}  // namespace waybreaker::site
