// Cuts what can be destroyed into sections, so that one breach opens a square of it instead of a whole building.
#pragma once

#include "site/described_map.hpp"

namespace waybreaker::site {

// One obstacle for each square of the lattice that holds destructible cells: all of them, whoever they belong to. A
// square with less than a twentieth of its area destructible joins the neighbour that most of these cells touch by a
// side; at most two squares join, so that each section fits in a rectangle of one or two of them. Indestructible
// obstacles stay as they are.
//
// A section has the source id and kind of the structure that has most cells in it, of the first one among equals, and
// the names of all, most cells first. It weighs 1 if all that is destructible does; else weights, and breach times in
// any case, go to the sections of a structure by their share of its cells, and add up. It has the tags of all.
//
// Time O(cells + s log s), s being the parts that the lattice cuts structures into. Throws InputError if the side is
// below 1. REQUIRES: the map has no sections yet.
DescribedMap split(const Map& map, const Annotations& annotations, const Lattice& lattice);

}  // namespace waybreaker::site
