// A game whose walls fall: what is broken stays broken, and the next plan is made on what is left.
//
// A Map never changes. When a wall falls, the program makes the next map of the last one by an edit, which costs a
// small part of a new map, and all other walls keep their ids.
#include <iostream>
#include <string>
#include <vector>
#include <waybreaker/waybreaker.hpp>

int main() {
    // `.` floor, a letter: a tile of that wall.
    waybreaker::Map map = waybreaker::Map::from_rows({
        "....A....C.....",
        "....A....C.....",
        "....A....C..D..",
        "....A....C..D..",
        "....B....C..D..",
        "....B.......D..",
        "....B.......D..",
    });
    const waybreaker::ObstacleId keep = map.obstacle_at({12, 2});
    waybreaker::Mission mission;
    mission.agents = {waybreaker::vehicle("rover", {0, 3}, {14, 3}), waybreaker::aircraft("drone", {0, 3}, {14, 3})};
    mission.rules.removals = 1;
    mission.rules.protect = {keep};

    waybreaker::Planner planner;  // keeps its memory from map to map
    for (int turn = 1; turn <= 4; ++turn) {
        const waybreaker::Plan plan = planner.plan(map, mission);
        std::cout << "turn " << turn << ": there after " << plan.after.ground_makespan.value_or(0);
        std::vector<waybreaker::MapEdit> edits;
        for (const waybreaker::Breach& breach : plan.breaches) {
            std::cout << "; wall " << char(breach.source_id) << ", obstacle " << breach.obstacle.value << ", falls";
            edits.push_back(waybreaker::MapEdit::remove(breach.obstacle));
        }
        if (turn == 3) {
            const waybreaker::MapEdit gate = waybreaker::MapEdit::add({{7, 2}, {7, 3}, {7, 4}}, {.source_id = 'E'});
            std::cout << "; wall E is built, obstacle " << map.obstacles().size() + 1;
            edits.push_back(gate);
        }
        map = map.with(edits);
        std::cout << "; wall D is obstacle " << map.obstacle_at({12, 2}).value << "\n";
    }
}
