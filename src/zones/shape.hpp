// Shape: the polygon of a zone on the lattice.
#pragma once

#include <cstddef>
#include <vector>

#include "zones/lattice.hpp"

namespace waybreaker::zones {

using Ring = std::vector<Spot>;

struct Edge {
    Spot from;
    Spot to;
};

struct Shape {
    // Each with the interior on its left (turn above 0), the outline first. No spot twice in a row.
    std::vector<Ring> rings;
    std::vector<Edge> edges;  // of all rings
    Spot least;               // of its box
    Spot most;

    // The edge that a spot lies on, if it lies on one. Of two that meet there, either.
    const Edge* edge_at(Spot at) const;
    // REQUIRES: it lies on no edge.
    bool holds(Spot at) const;
    bool has_inside(Spot at) const { return edge_at(at) == nullptr && holds(at); }
};

// On the lattice; corners that fall together are one. REQUIRES: coordinates in range.
Shape shape_of(const Zone& zone);

}  // namespace waybreaker::zones
