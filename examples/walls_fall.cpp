// A game whose walls fall: what is broken stays broken, and the next plan is made on what is left.
//
// A Map never changes. When a wall falls, the program changes its own world and makes a new Map of it. Obstacles are
// numbered anew then, in scan order, so an ObstacleId of the old map may name another wall of the new one, or none:
// `source_id` is what the program knows a wall by from map to map.
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>
#include <waybreaker/waybreaker.hpp>

namespace {

// `.` floor, a letter: a tile of that wall.
using Level = std::vector<std::string>;

waybreaker::Map map_of(const Level& level) {
    std::vector<std::uint32_t> labels;
    for (const std::string& row : level) {
        for (const char tile : row) labels.push_back(tile == '.' ? 0U : std::uint32_t(tile - 'A' + 1));
    }
    std::vector<waybreaker::ObstacleAttributes> walls(27);  // by label; label 0 is floor
    for (char wall = 'A'; wall <= 'Z'; ++wall) walls[std::size_t(wall - 'A' + 1)].source_id = wall;
    return waybreaker::Map::from_labels(int(level[0].size()), int(level.size()), std::move(labels), walls);
}

// The id that a wall has on this map; 0 if it is not there.
waybreaker::ObstacleId id_of(const waybreaker::Map& map, char wall) {
    for (const waybreaker::Obstacle& obstacle : map.obstacles()) {
        if (obstacle.source_id == wall) return obstacle.id;
    }
    return {};
}

}  // namespace

int main() {
    Level level{
        "....A....C.....",  //
        "....A....C.....",  //
        "....A....C..D..",  //
        "....A....C..D..",  //
        "....B....C..D..",  //
        "....B.......D..",  //
        "....B.......D..",  //
    };
    waybreaker::MissionPlanner planner;  // keeps its memory from map to map
    for (int turn = 1; turn <= 3; ++turn) {
        const waybreaker::Map map = map_of(level);
        auto mission = waybreaker::ground_and_air({0, 3}, {14, 3});
        mission.rules.removals = 1;
        if (const auto keep = id_of(map, 'D')) mission.rules.protect.push_back(keep);
        const waybreaker::Plan plan = planner.plan(map, mission);
        std::cout << "turn " << turn << ": wall D is obstacle " << id_of(map, 'D').value;
        if (plan.status != waybreaker::PlanStatus::solved) return 1;
        for (const waybreaker::Breach& breach : plan.breaches) {
            const char fallen = char(breach.source_id);
            std::cout << "; wall " << fallen << ", obstacle " << breach.obstacle.value << ", falls";
            for (std::string& row : level) {
                for (char& tile : row) tile = tile == fallen ? '.' : tile;
            }
        }
        std::cout << "; there after " << *plan.after.ground_makespan << "\n";
    }
}
