// A game level in which a wall falls or is built in every frame, and the plan changes with it: how long a frame takes.
//
// A map never changes: the next one is made of the last by an edit. A wall that is built gets the next id, and all
// others keep theirs. Times go to the standard error output.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <iostream>
#include <random>
#include <vector>
#include <waybreaker/waybreaker.hpp>

namespace wb = waybreaker;

namespace {

constexpr int side = 128;
constexpr int room = 16;  // with its walls
constexpr int frames = 1000;

struct Wall {
    std::vector<wb::Cell> cells;
    wb::ObstacleId id = {};  // none while it is down
};

// A piece of wall between two pillars; many have a door.
Wall piece(wb::Cell from, int dx, int dy, std::size_t number) {
    Wall wall;
    const bool has_door = number * 37 % 10 < 6;
    for (int i = 1; i < room; ++i) {
        if (!has_door || i < 7 || i > 9) wall.cells.push_back({from.x + i * dx, from.y + i * dy});
    }
    return wall;
}

std::vector<Wall> level() {
    std::vector<Wall> walls;
    for (int at = room; at < side; at += room) {
        for (int from = 0; from < side; from += room) {
            walls.push_back(piece({from, at}, 1, 0, walls.size()));
            walls.push_back(piece({at, from}, 0, 1, walls.size()));
        }
    }
    return walls;
}

double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

int main() {
    std::vector<Wall> walls = level();
    wb::Map map(wb::Grid(side, side));
    const auto build = [&map](Wall& wall) {
        map = map.with({wb::MapEdit::add(wall.cells)});
        wall.id.value = std::uint32_t(map.obstacles().size());
    };
    for (Wall& wall : walls) build(wall);

    wb::Mission mission;
    mission.agents = {wb::vehicle("rover", {8, 8}, {120, 120}), wb::aircraft("drone", {8, 8}, {120, 120})};
    mission.agents[1].speed = 2;
    mission.rules.removals = 1;
    mission.rules.breach_time.per_obstacle = 4;

    wb::Planner planner;
    std::minstd_rand random(7);
    std::vector<double> times;
    std::size_t breached = 0;
    for (int frame = 0; frame < frames; ++frame) {
        const auto start = std::chrono::steady_clock::now();
        Wall& wall = walls[random() % walls.size()];
        if (wall.id) {
            map = map.with({wb::MapEdit::remove(wall.id)});
            wall.id = {};
        } else {
            build(wall);
        }
        // A limit in expansions, unlike one in seconds, gives the same plan on every machine.
        const wb::Plan plan = planner.plan(map, mission, {.expansions = 2000});
        times.push_back(milliseconds_since(start));

        breached += plan.breaches.size();
        if (frame % 200 != 0) continue;
        std::cout << "frame " << frame << ": " << std::ranges::count_if(walls, [](const Wall& w) { return bool(w.id); })
                  << " walls stand; there at " << plan.after.ground_makespan.value_or(0);
        for (const wb::Breach& breach : plan.breaches) std::cout << ", through wall " << breach.obstacle.value;
        std::cout << '\n';
    }
    std::cout << breached << " walls to breach in " << frames << " plans\n";
    std::ranges::sort(times);
    std::clog << "milliseconds a frame: median " << times[frames / 2] << ", 99 of 100 within "
              << times[frames * 99 / 100] << ", worst " << times.back() << '\n';
}
