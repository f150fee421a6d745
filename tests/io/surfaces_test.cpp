// What plan files say of the ground that vehicles drive over: rightly, and found out where it is not.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "checked_plan.hpp"
#include "io/check_report.hpp"
#include "io/plan_json.hpp"
#include "random_map.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;
using site::CellRun;

// Some runs of cells, row by row.
std::vector<CellRun> some_runs(const PlainMap& map) {
    std::vector<CellRun> runs;
    for (int y = 0; y < map.height; ++y) {
        for (int x = *number(0, map.width); x < map.width; x += *number(2, 5)) {
            const int length = std::min(*number(1, 5), map.width - x);
            runs.push_back({{x, y}, length});
            x += length;
        }
    }
    return runs;
}

// A map whose obstacles are of any kind, with ways, unknown ground and a cell size.
MapFile any_town(const PlainMap& plain) {
    const Map map(plain.grid());
    MapFile file{.map = map, .source = "town.tif", .digest = "sha256:00"};
    file.cell_size = *rc::gen::element(0.5, 1.0, 2.0, 2.4, 10.0);
    file.cell_size_given = true;
    file.annotations.ways = some_runs(plain);
    RC_PRE(!file.annotations.ways.empty());
    if (*number(0, 2) == 0) file.annotations.unknown = some_runs(plain);
    file.annotations.kinds.resize(map.obstacles().size() + 1);
    for (const Obstacle& one : map.obstacles()) {
        const bool wet = *number(0, 2) == 0;
        file.annotations.kinds[one.id.value] = wet ? site::ObstacleKind::water : site::ObstacleKind::building;
        if (*number(0, 9) == 0) file.annotations.tags["occupancy=unknown"].push_back(one.id);
    }
    return file;
}

std::vector<std::string> messages(const std::string& plan, const MapFile& map, const JudgeOptions& options = {}) {
    std::vector<std::string> found;
    for (const Violation& one : judge(parse_plan(plan, "plan.json"), map, options)) {
        found.push_back(std::string(to_string(one.rule)) + ": " + one.message);
    }
    return found;
}

struct Planned {
    MapFile map;
    std::string text;
    std::size_t agent = 0;  // that drives somewhere

    Json json() const { return Json::parse(text); }
    Json surface() const { return json()["agents"][agent]["surface"]; }
};

// Any planner, also such as bend at cell corners; through what is removed as well; one vehicle or several.
Planned any_plan() {
    const PlainMap plain = *random_map(24, 20);
    Planned planned{.map = any_town(plain), .text = ""};
    Mission mission = ground_and_air(any_free_cell(plain), any_free_cell(plain));
    mission.rules.removals = *number(0, 2);
    Body& body = mission.agents[0].body;
    body.radius = *rc::gen::element(0.0, 0.5, 0.8);
    const Method method{.planner = *rc::gen::element(Algorithm::optimal, Algorithm::theta, Algorithm::astar)};
    Plan plan;
    try {
        plan = Planner().plan(planned.map.map, mission, method);
    } catch (const InputError&) {
        RC_DISCARD("a start that is too narrow");
    }
    RC_PRE(plan.status == PlanStatus::solved);
    planned.text = plan_json(plan, {.map = planned.map, .asked = {.mission = mission, .method = method}});
    return planned;
}

RC_GTEST_PROP(Surfaces, OfAPlanAddUpToItsLengthAndAreFoundAgain, ()) {
    const Planned planned = any_plan();
    const Json surface = planned.surface();
    const double length = planned.json()["after"]["ground"]["length"].get<double>();
    const double sum =
        surface["ways"].get<double>() + surface["off_ways"].get<double>() + surface["unknown"].get<double>();
    RC_ASSERT(std::abs(sum - length) < 1e-9 * (1 + length));
    RC_ASSERT(messages(planned.text, planned.map) == std::vector<std::string>());
    RC_TAG(std::string(surface["ways"] > 0 && surface["off_ways"] > 0 ? "both" : "one") +
           (surface["unknown"] > 0 ? ", unknown" : "") + (surface["near_water"] > 0 ? ", wet" : ""));
}

RC_GTEST_PROP(Surfaces, ThatAreWrongAreFoundOut, ()) {
    const Planned planned = any_plan();
    const std::string key = *rc::gen::element<std::string>("ways", "off_ways", "unknown", "near_water");
    Json json = planned.json();
    Json& stated = json["agents"][0]["surface"][key];
    const double truth = stated.get<double>();
    stated = truth + *rc::gen::element(1.0, -0.01 - 1e-3 * truth);
    const std::vector<std::string> found = messages(json.dump(), planned.map);
    RC_ASSERT(found.size() == 1U);
    const std::string where = key == "ways"       ? " cells on ways, not "
                              : key == "off_ways" ? " cells off ways, not "
                              : key == "unknown"  ? " cells on unknown ground, not "
                                                  : " cells near water, not ";
    RC_ASSERT(found[0].starts_with("surface: the ground agent drives "));
    RC_ASSERT(found[0].find(where) != std::string::npos);
}

// A street and a bank, and a plan along them.
class SurfacesOfATown : public testing::Test {
  protected:
    SurfacesOfATown() {
        file_.cell_size = 2.5;
        file_.cell_size_given = true;
        file_.annotations.kinds = {site::ObstacleKind::unknown, site::ObstacleKind::water};
        file_.annotations.ways = {{{0, 0}, 6}};
    }

    std::string plan() const {
        const Mission mission = ground_and_air({0, 0}, {8, 0});
        return plan_json(Planner().plan(file_.map, mission), {.map = file_, .asked = {.mission = mission}});
    }
    Json agent(std::size_t i) const { return Json::parse(plan())["agents"][i]; }

    MapFile file_{.map = Map::from_labels(9, 3, std::vector<std::uint32_t>{0, 0, 0, 0, 0, 0, 0, 0, 0,  //
                                                                           0, 0, 0, 0, 0, 0, 0, 0, 0,  //
                                                                           1, 1, 1, 0, 0, 0, 0, 0, 0}),
                  .source = "town.tif",
                  .digest = "sha256:00"};
};

TEST_F(SurfacesOfATown, StandBesideThePathsOfVehicles) {
    const Json ground = agent(0);
    EXPECT_EQ(ground["surface"].dump(), R"({"ways":5.5,"off_ways":2.5,"unknown":0.0,"near_water":3.5})");
    EXPECT_FALSE(agent(1).contains("surface"));
    EXPECT_EQ(messages(plan(), file_), std::vector<std::string>());
}

TEST_F(SurfacesOfATown, AreNotSaidWhereNobodyKnows) {
    const std::string known = plan();
    file_.annotations.ways.clear();
    EXPECT_FALSE(agent(0).contains("surface"));
    EXPECT_EQ(messages(plan(), file_), std::vector<std::string>());
    EXPECT_EQ(messages(known, file_),
              std::vector<std::string>{"surface: the plan says what is driven on ways, but the map knows none"});
    EXPECT_EQ(messages(known, file_, {.ignore_digest = true}), std::vector<std::string>());
}

TEST_F(SurfacesOfATown, NeedMetres) {
    file_.cell_size = 1;
    file_.cell_size_given = false;
    EXPECT_FALSE(agent(0).contains("surface"));
}

TEST_F(SurfacesOfATown, NameTheVehicleAndTheNumberThatIsWrong) {
    Json json = Json::parse(plan());
    json["agents"][0]["surface"]["near_water"] = 3;
    EXPECT_EQ(
        messages(json.dump(), file_),
        std::vector<std::string>{"surface: the ground agent drives 3.5 cells near water, not 3 as the plan says"});
    json["agents"][0]["surface"].erase("near_water");
    EXPECT_EQ(messages(json.dump(), file_), std::vector<std::string>());
    json["agents"][0].erase("surface");
    EXPECT_EQ(messages(json.dump(), file_), std::vector<std::string>());
}

}  // namespace
}  // namespace waybreaker::io
