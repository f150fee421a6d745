// Sections: what one breach opens where obstacles are cut along a lattice of squares, and of what each is a part.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "site/obstacle_kinds.hpp"
#include "waybreaker/cell.hpp"

namespace waybreaker::site {

// Squares of side x side cells; a corner of one is the upper-left corner of cell `origin`.
struct Lattice {
    int side = 1;
    Cell origin = {};
};

// What stands on the ground and was an obstacle before it was cut: a building, a wall.
struct Structure {
    ObstacleKind kind = ObstacleKind::unknown;
    std::int64_t source_id = 0;
    std::string name = {};  // empty where unknown
    friend bool operator==(const Structure&, const Structure&) = default;
};

// Of which structures each section has parts. Nothing in here: the map has no sections.
struct Sections {
    std::vector<Structure> structures = {};
    // By obstacle id, entry 0 unused: positions in the list above, ascending; none of an obstacle that was not cut.
    std::vector<std::vector<std::uint32_t>> parts = {};

    bool empty() const { return parts.empty(); }
    friend bool operator==(const Sections&, const Sections&) = default;
};

// How many obstacles are sections.
std::size_t section_count(const Sections& sections);

// Positions of the structures that these obstacles have parts of, ascending, each once; or of all that have sections.
std::vector<std::uint32_t> structures_of(const Sections& sections, std::span<const ObstacleId> obstacles);
std::vector<std::uint32_t> cut_structures(const Sections& sections);

// "14 sections of 3 buildings": all that there are.
std::string sections_summary(const Sections& sections);

// "2 buildings, 1 barrier": those at these positions. What is neither is called a structure.
std::string structures_text(const Sections& sections, std::span<const std::uint32_t> positions);

// By the number in a label layer, before the map renumbers its obstacles.
using LabelParts = std::unordered_map<std::uint32_t, std::vector<std::uint32_t>>;

}  // namespace waybreaker::site
