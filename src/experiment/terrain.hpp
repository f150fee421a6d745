// Terrain: generated maps of the kinds that the paper's conjecture is about (section 4), and some others.
//
//     Map map = make_terrain(Terrain::maze, {.side = 501, .seed = 7});
#pragma once

#include <cstdint>

#include "waybreaker/map.hpp"

namespace waybreaker::experiment {

// maze: corridors that are a tree; every wall between two of its rooms is an obstacle. rooms: the same with doors in
// the walls, and more of them. spiral: square spirals side by side, each an obstacle. blocks: city blocks between
// streets. random: cells blocked at random, obstacles are 4-connected.
enum class Terrain { maze, rooms, spiral, blocks, random };

struct TerrainOptions {
    int side = 501;     // cells
    double share = -1;  // of blocked cells (random), of walls with a door beyond the tree's (maze, rooms); < 0: usual
    std::uint64_t seed = 1;
};

inline constexpr int least_terrain_side = 32;

// The same for the same options on every platform. Throws InputError if the side or the share is out of range.
Map make_terrain(Terrain terrain, const TerrainOptions& options);

}  // namespace waybreaker::experiment
