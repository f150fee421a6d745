// Missions as the paper draws them (section 4): per map some random pairs of start and goal that lie far apart, of
// which those are kept whose Theta* path is clearly longer than the straight line.
//
//     DrawnMissions drawn = draw_missions(map, {.pairs = 200, .min_distance = 400, .min_detour = 0.1});
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/movingai.hpp"

namespace waybreaker::experiment {

struct MissionRules {
    int pairs = 200;            // drawn on each map
    double min_distance = 400;  // cells: start and goal are farther apart than that
    double min_detour = 0.1;    // Theta* paths are longer than (1 + that) times the straight line
    std::uint64_t seed = 1;
};

struct DrawnMissions {
    std::vector<Scenario> kept;  // without the map's name
    std::size_t drawn = 0;
    std::size_t without_way = 0;  // the ground agent cannot get from start to goal
};

// The same for the same cells, whatever file they come from, on every platform. Throws InputError if the map has no
// such pairs, or they are too rare to find.
DrawnMissions draw_missions(const Map& map, const MissionRules& rules);

struct TeamSize {
    int vehicles = 1;
    int aircraft = 1;
};

// Missions of teams: as many vehicles drive pairs in their order, one that has no room beside those before it left out;
// and each aircraft starts and ends with a vehicle, the first with the first. What is left over makes no team. A team
// of one and one is the paper's coalition. REQUIRES: at least one vehicle; the pairs are of that map.
std::vector<Mission> teams_of(const Map& map, std::span<const Scenario> pairs, const TeamSize& size,
                              const Rules& rules);

}  // namespace waybreaker::experiment
