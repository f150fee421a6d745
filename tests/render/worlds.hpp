// Small worlds with plans made by hand, so that the pictures' tests depend on no planner.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "ascii_map.hpp"
#include "project_folder.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/movingai.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::render {

struct World {
    Map map;
    Mission mission;
    Plan plan;
};

inline constexpr std::string_view wall_picture = R"(
    ....a...
    ....a...
    S...a..G
    ....a...
    .b..a...
    ....a...
    ........)";

inline Outcome outcome(std::vector<waybreaker::Point> ground, std::vector<waybreaker::Point> air, double ground_length,
                       double air_length) {
    Outcome outcome;
    outcome.ground().path = std::move(ground);
    outcome.ground().length = ground_length;
    outcome.air().path = std::move(air);
    outcome.air().length = air_length;
    outcome.makespan = std::max(ground_length, air_length);
    outcome.flowtime = ground_length + air_length;
    return outcome;
}

// A wall with a way around it; the plan goes through.
inline World wall() {
    World world{map_from_ascii(wall_picture), ground_and_air({0, 2}, {7, 2}), {}};
    world.plan.status = PlanStatus::solved;
    world.plan.before = outcome({{0, 2}, {3, 6}, {5, 6}, {7, 2}}, {{0, 2}, {7, 2}}, 11.5, 7);
    world.plan.after = outcome({{0, 2}, {7, 2}}, {{0, 2}, {3, 1}, {7, 2}}, 7, 7.2);
    world.plan.breaches = {{.obstacle = {1}, .cells = 6, .at = {3, 1}, .entered_at = 3.5}};
    return world;
}

// A mission on a map, with no plan: the ground agent cannot get there.
inline World unsolved(Map map, Cell start, Cell goal) {
    World world{std::move(map), ground_and_air(start, goal), {}};
    world.plan.before.air() = {.kind = AgentKind::air, .length = distance(start, goal), .path = {start, goal}};
    world.plan.after.air() = world.plan.before.air();
    return world;
}

// A city map of the shared data; empty where that is absent.
inline std::optional<Map> shared_city(const std::string& file) {
    const char* shared = std::getenv("WAYBREAKER_SHARED");
    const std::filesystem::path folder = shared ? std::filesystem::path(shared) : project_folder() / ".." / "shared";
    std::ifstream in(folder / "data" / "cities" / file);
    if (!in) return std::nullopt;
    return Map(read_movingai_map(in, file));
}

}  // namespace waybreaker::render
