// Mission in, plan and picture out, as the files that the command reads and writes; no GDAL. Built where the sources
// are a subproject, with WAYBREAKER_FORMATS=ON; links waybreaker::io and waybreaker::render, and waybreaker::mission to
// plan.
#include <fstream>
#include <iostream>

#include "io/mission_json.hpp"
#include "io/plan_json.hpp"
#include "render/picture.hpp"
#include "waybreaker/waybreaker.hpp"

int main() {
    waybreaker::Grid grid(40, 20);
    for (int y = 0; y < 18; ++y) grid.set_blocked({20, y}, true);
    const waybreaker::io::MapFile map{.map = waybreaker::Map(std::move(grid)), .source = "yard"};

    const waybreaker::io::MissionDocument asked = waybreaker::io::parse_mission(R"({
        "format": "waybreaker-mission/1",
        "agents": [{"id": "rover", "kind": "ground", "start": [4, 4], "goal": [36, 4]},
                   {"id": "drone", "kind": "air", "start": [4, 4], "goal": [36, 4], "speed": 2}],
        "rules": {"removals": 1, "breach_time": 3}})",
                                                                                "mission.json");
    const waybreaker::Plan plan = waybreaker::Planner().plan(map.map, asked.mission, asked.method, asked.limits);
    std::cout << waybreaker::io::plan_json(plan, {.map = map, .asked = asked, .timing_fields = false});
    std::ofstream("documents.svg") << waybreaker::render::svg(map.map, asked.mission, plan,
                                                              {.annotations = {.title = "Yard"}});
}
