// One question of a game within a frame: which wall should the drone break for the rover, and who is where when? The
// crossing search alone knows the way and the wall; Planner needs most of its time to prove that nothing is
// better.
#include <iostream>
#include <optional>
#include <utility>
#include <waybreaker/advanced.hpp>
#include <waybreaker/waybreaker.hpp>

namespace {

struct Answer {
    waybreaker::CrossingPath way;
    waybreaker::Schedule schedule;
};

// Breaks at most that many walls, for a way at most 1.2 times as long as the shortest. Empty where none is found within
// the limit, which is the same in every replay.
std::optional<Answer> think(waybreaker::CrossingSearcher& crossing, const waybreaker::Map& map,
                            const waybreaker::Agent& rover, const waybreaker::Agent& drone, int walls) {
    const waybreaker::CrossingResult found = crossing.find(
        map, rover.start, rover.goal, {.crossings = walls, .weight = 1.2, .limits = {.expansions = 2000}});
    const waybreaker::CrossingPath& way = found.best;
    if (way.path.empty()) return std::nullopt;
    return Answer{way, waybreaker::best_schedule(map, {way.path, rover, drone, waybreaker::Rules{}, way.crossed})};
}

}  // namespace

int main() {
    waybreaker::Grid grid(64, 48);
    for (int y = 0; y < 40; ++y) grid.set_blocked({20, y}, true);
    for (int y = 8; y < 48; ++y) grid.set_blocked({40, y}, true);
    const waybreaker::Map map(std::move(grid));
    const waybreaker::Mission mission = waybreaker::ground_and_air({4, 4}, {60, 44});

    waybreaker::CrossingSearcher crossing;  // one for each thread, kept from frame to frame: it keeps its memory
    for (int walls = 0; walls <= 2; ++walls) {
        const std::optional<Answer> answer = think(crossing, map, mission.agents[0], mission.agents[1], walls);
        if (!answer) return 1;
        std::cout << "breaking " << answer->way.crossed.size() << ": there after " << answer->schedule.makespan << "\n";
        for (const waybreaker::BreachPoint& wall : answer->schedule.flight.breaches) {
            std::cout << "  wall " << wall.obstacle.value << " from (" << wall.at.x << ", " << wall.at.y << ")\n";
        }
    }
}
