// A map from a world of your own: a game's tiles, where buildings have numbers and not every wall can be broken.
//
// Any world will do that can say, cell by cell, which obstacle stands there (0: none) and, obstacle by obstacle,
// whether it can be removed. Labels may be the world's own numbers; `source_id` leads back from a plan to the world.
#include <array>
#include <cstdint>
#include <iostream>
#include <string_view>
#include <vector>
#include <waybreaker/waybreaker.hpp>

namespace {

// The game's level: `.` floor, a letter: a tile of that building. A..M are of brick, N..Z of steel.
constexpr std::array<std::string_view, 11> level = {
    "............................",  //
    ".......NN...................",  //
    ".......NN....BBB............",  //
    ".......NN....BBB....AAA.....",  //
    ".......NN....BBB....AAA.....",  //
    ".......NN....BBB....AAA.....",  //
    ".......NN....BBB............",  //
    ".......NN....BBB............",  //
    "..............B.............",  //
    "..............B.............",  //
    "..............B.............",  //
};

waybreaker::Map map_of_level() {
    const int width = int(level[0].size());
    const int height = int(level.size());

    std::vector<std::uint32_t> labels;
    for (const std::string_view row : level) {
        for (const char tile : row) labels.push_back(tile == '.' ? 0U : std::uint32_t(tile - 'A' + 1));
    }

    std::vector<waybreaker::ObstacleAttributes> buildings(27);  // by label; label 0 is floor
    for (char tile = 'A'; tile <= 'Z'; ++tile) {
        buildings[std::size_t(tile - 'A' + 1)] = {.destructible = tile <= 'M', .source_id = tile};
    }
    return waybreaker::Map::from_labels(width, height, std::move(labels), buildings);
}

}  // namespace

int main() {
    const waybreaker::Map map = map_of_level();
    waybreaker::Planner planner;
    auto mission = waybreaker::ground_and_air({1, 5}, {26, 4});
    waybreaker::Method method;
    mission.rules.removals = 2;
    waybreaker::follow_paper(mission.rules, method);

    // Two may go, yet the steel building N stays, however much it is in the way.
    const waybreaker::Plan plan = planner.plan(map, mission, method);
    if (plan.status != waybreaker::PlanStatus::solved) return 1;
    for (const auto& removal : plan.breaches) {
        std::cout << "tear down building " << char(removal.source_id) << ", " << removal.cells << " tiles\n";
    }
    std::cout << "the walk shrinks from " << *plan.before.ground().length << " to " << *plan.after.ground().length
              << "\n";
}
