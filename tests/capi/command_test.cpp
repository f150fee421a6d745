// One plan, two ways: what the C interface gives is what the command writes, to the byte.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "capi/owned.hpp"
#include "shared_data.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::capi {
namespace {

using Json = nlohmann::json;

// Rooms of 7 cells with a door here and there.
std::string rooms() {
    std::string map = "type octile\nheight 64\nwidth 64\nmap\n";
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const bool wall = x % 8 == 7 || y % 8 == 7;
            const bool door = (x * 5 + y * 3) % 11 == 0;
            map += wall && !door ? '@' : '.';
        }
        map += '\n';
    }
    return map;
}

std::string mission(const std::string& rules, const std::string& more = "") {
    return R"({"format": "waybreaker-mission/1", "agents": [
        {"id": "rover", "kind": "ground", "start": [2, 3], "goal": [58, 60], "speed": 1},
        {"id": "drone", "kind": "air", "start": [3, 3], "goal": [60, 60], "speed": 2.5}],
        "rules": {)" +
           rules + "}" + more + "}";
}

class CommandAndC : public TemporaryFolder {
  protected:
    // The exit status of `waybreaker ARGUMENTS` in the test's folder.
    int status_of(const std::string& arguments) const {
        const std::string line = "cd '" + path("") + "' && '" WAYBREAKER_COMMAND "' " + arguments + " >log 2>&1";
        return WEXITSTATUS(std::system(line.c_str()));
    }
    void run(const std::string& arguments) const {
        ASSERT_EQ(status_of(arguments), 0) << arguments << '\n' << bytes_of("log");
    }

    void expect_equal(const std::string& map_bytes, const std::string& mission, int connectivity = 4,
                      double cell_size = 0) {
        put("city.map", map_bytes);
        put("mission.json", mission);
        std::string options = " --connectivity " + std::to_string(connectivity);
        if (cell_size != 0) options += " --cell-size " + std::to_string(cell_size);
        run("plan city.map --mission mission.json --no-timing --json plan.json" + options);
        const OwnedMap map = from_movingai(map_bytes, "city.map", connectivity, cell_size);
        ASSERT_TRUE(map);
        const Answer plan = capi::plan(planner, map, mission);
        EXPECT_EQ(plan.status, WAYBREAKER_OK) << plan.error;
        EXPECT_EQ(plan.text, bytes_of("plan.json"));
    }

    OwnedPlanner planner = new_planner();
};

TEST_F(CommandAndC, PlanTheSame) {
    expect_equal(rooms(), mission(R"("removals": 2, "breach_time": 3)"));
    expect_equal(rooms(), mission(R"("removals": 3, "objective": "flowtime")", R"(, "method": {"select": "greedy"})"));
    expect_equal(rooms(), mission(R"("removals": 1)"), 8);
    expect_equal(rooms(), mission(R"("removals": 2)", R"(, "method": {"explain": true}, "time_unit": "s")"), 4, 0.5);
    expect_equal(rooms(), mission(R"("removals": 9, "budget_m2": 40)"), 4, 1);
    expect_equal(rooms(), R"({"format": "waybreaker-mission/1", "map": "elsewhere.map", "agents": [
        {"id": "a", "kind": "ground", "start": [2, 3], "goal": [58, 60]},
        {"id": "b", "kind": "ground", "start": [58, 3], "goal": [3, 60], "ready_at": 4},
        {"id": "drone", "kind": "air", "start": [3, 3], "goal": [60, 60], "speed": 2.5}],
        "rules": {"removals": 2, "separation": 0.5}})");
}

TEST_F(CommandAndC, PlanTheSameFront) {
    put("city.map", rooms());
    run("plan city.map --mission '" + put("m.json", mission(R"("removals": 3, "breach_time": 3)")) +
        "' --removals auto --no-timing --json front.json");
    // The command's auto is at most 32.
    EXPECT_EQ(front(planner, from_movingai(rooms(), "city.map"), mission(R"("removals": 32, "breach_time": 3)")).text,
              bytes_of("front.json"));
}

TEST_F(CommandAndC, PlanTheSameOnAGrid) {
    put("city.map", rooms());
    run("map convert city.map grid.map");
    run("plan grid.map --mission '" + put("m.json", mission(R"("removals": 2)")) + "' --no-timing --json plan.json");
    std::vector<std::uint8_t> blocked;
    const std::string text = rooms();
    for (const char c : text.substr(text.find("map\n") + 4)) {
        if (c != '\n') blocked.push_back(c == '@' ? 1 : 0);
    }
    const OwnedMap map = map_by([&](auto** result, auto** error) {
        return waybreaker_map_from_grid("grid.map", blocked.data(), 64, 64, 4, 0, result, error);
    });
    EXPECT_EQ(plan(planner, map, mission(R"("removals": 2)")).text, bytes_of("plan.json"));
}

TEST_F(CommandAndC, JudgeTheSame) {
    const std::string bytes = rooms();
    const OwnedMap map = from_movingai(bytes, "city.map");
    const std::string plan = capi::plan(planner, map, mission(R"("removals": 2)")).text;
    put("city.map", bytes);
    put("plan.json", plan);
    run("check city.map plan.json --json report.json");
    EXPECT_EQ(check(map, plan).text, bytes_of("report.json"));
}

// A wall with a way around it at either end, and one that ends at the lower edge.
std::string two_walls() {
    std::string map = "type octile\nheight 12\nwidth 32\nmap\n";
    for (int y = 0; y < 12; ++y) {
        std::string row(32, '.');
        if (y > 0 && y < 11) row[10] = '@';
        if (y > 0) row[21] = '@';
        map += row + "\n";
    }
    return map;
}

TEST_F(CommandAndC, ReviseTheSame) {
    put("walls.map", two_walls());
    const OwnedMap map = from_movingai(two_walls(), "walls.map");
    const std::string plan = capi::plan(planner, map, R"({"format": "waybreaker-mission/1", "agents": [
        {"id": "rover", "kind": "ground", "start": [2, 6], "goal": [29, 6]},
        {"id": "drone", "kind": "air", "start": [2, 6], "goal": [29, 6]}],
        "rules": {"removals": 1, "breach_time": 2}})")
                                 .text;
    put("plan.json", plan);
    const Json removed = Json::parse(plan)["removed"];
    ASSERT_FALSE(removed.empty());
    const std::string first = removed[0]["obstacle"].dump();
    const std::string at = removed[0]["cleared_at"].dump();
    for (const std::string& news :
         {R"("now": )" + at + R"(, "failed": [{"obstacle": )" + first + R"(, "at": )" + at + "}]",
          std::string(R"("now": 5, "agents": [{"id": "drone", "passed": 0, "doing": "lost"}])"),
          std::string(R"("now": 5, "agents": [{"id": "rover", "passed": 0, "doing": "lost"}])"),
          std::string(R"("now": 5, "found": [{"cells": [[27, 6], [27, 7]]}])"), std::string(R"("now": 7)")}) {
        const std::string state = R"({"format": "waybreaker-state/1", "sequence": 1, )" + news + "}";
        put("state.json", state);
        // Without a plan the exit status is 1, and the files are written nevertheless.
        EXPECT_LE(status_of("revise walls.map plan.json --state state.json --reaction 1 --no-timing --json new.json"),
                  1);
        EXPECT_LE(status_of("check walls.map new.json --after plan.json --state state.json --json report.json"), 1);
        const Answer next = revise(planner, map, plan, state, 1);
        EXPECT_EQ(next.text, bytes_of("new.json")) << news << next.error;
        EXPECT_EQ(check_after(map, next.text, plan, state).text, bytes_of("report.json")) << news;
    }
}

TEST_F(CommandAndC, PlanTheSameOnAMapOfTheBenchmarks) {
    const auto shared = shared_folder();
    if (!shared) GTEST_SKIP() << no_shared_folder;
    std::ostringstream bytes;
    bytes << std::ifstream(*shared / "data/benchmarks/den312d.map", std::ios::binary).rdbuf();
    expect_equal(bytes.str(), R"({"format": "waybreaker-mission/1", "agents": [
        {"id": "ground", "kind": "ground", "start": [29, 10], "goal": [40, 70]},
        {"id": "air", "kind": "air", "start": [29, 10], "goal": [40, 70], "speed": 2}],
        "rules": {"removals": 2, "breach_time": 5}})");
}

}  // namespace
}  // namespace waybreaker::capi
