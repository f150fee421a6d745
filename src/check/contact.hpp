// Contact: what the ground agent touches on its way, and when. Whether it touches is decided in integers, when by
// halving.
#pragma once

#include <cstdint>
#include <vector>

#include "waybreaker/map.hpp"

namespace waybreaker::checker {

// A place in half cells, so that centres of cells (both even) and corners of cells (both odd) are integers.
struct Vertex {
    std::int64_t x = 0;
    std::int64_t y = 0;
    friend constexpr bool operator==(Vertex, Vertex) = default;
};

// A straight move from one vertex to another, or a wait where they are one.
struct Leg {
    Vertex from;
    Vertex to;
    double start = 0;  // times
    double end = 0;

    Point place(double share) const;
    double time(double share) const { return start + share * (end - start); }
};

// The agent meets a cell: its open disc the closed square, or, if it is a point, the point the open square.
struct Contact {
    ObstacleId obstacle;
    double time = 0;
    Point place;
};

// The first contact on that leg with each obstacle met, by id. `radius` counts thousandths of a cell; 0 is a point.
// Precondition, here and below: the leg lies on the map.
std::vector<Contact> contacts(const Map& map, const Leg& leg, std::int64_t radius);

// A point passes between two blocked cells. Obstacle 0 is the outside of the map.
struct Passage {
    ObstacleId first;
    ObstacleId second;
    double time = 0;
    Point place;
};

// Along the side that two cells share, or that a cell shares with the outside.
std::vector<Passage> side_passages(const Map& map, const Leg& leg);

// Through a corner where two blocked cells meet diagonally.
std::vector<Passage> corner_passages(const Map& map, const Leg& leg);

}  // namespace waybreaker::checker
