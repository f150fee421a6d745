// Orders of VDA 5050, held against what its text says of orders and their updates; against its JSON schemas they are
// held by tests/exports/outside.
#include "exports/plan_vda5050.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ascii_map.hpp"
#include "input_error.hpp"

namespace waybreaker::exports {
namespace {

using Json = nlohmann::json;

// A crate bars the corridor; the vehicle drives up to it, round a bend, and waits.
class PlanVda5050 : public testing::Test {
  protected:
    io::MapFile map{.map = map_from_ascii("....... ....#.. ....#.. ......."),
                    .source = "hall.yaml",
                    .cell_size = 0.5,
                    .origin = std::array{-1.0, 2.0}};
    Mission mission{.agents = {{.id = "ground", .start = {0, 0}, .goal = {6, 2}}, aircraft("air", {0, 3})}};
    Plan plan;

    PlanVda5050() {
        plan.status = PlanStatus::solved;
        plan.breaches = {{.obstacle = map.map.obstacle_at({4, 1}), .at = {4, 3}, .cleared_at = 9}};
        plan.agents = {{.id = "ground", .path = {{0, 0, 0}, {2, 0, 2}, {2, 2, 4}, {2, 2, 9}, {6, 2, 13}}},
                       {.id = "air", .kind = AgentKind::air, .path = {{0, 3, 0}, {4, 3, 4}, {4, 3, 9}, {0, 3, 13}}}};
    }

    Json messages() const { return Json::parse(plan_vda5050({.plan = plan, .map = map}, mission)); }

    // Whether each element is released.
    static std::vector<bool> base(const Json& elements) {
        std::vector<bool> released;
        for (const Json& element : elements) released.push_back(element.at("released"));
        return released;
    }
};

TEST_F(PlanVda5050, EndsTheBaseBeforeAnOpening) {
    const Json orders = messages().at("orders");
    ASSERT_EQ(orders.size(), 2U);  // none for the aircraft
    EXPECT_EQ(orders[0].at("serialNumber"), "ground");
    EXPECT_EQ(base(orders[0].at("nodes")), (std::vector<bool>{true, true, true, false}));
    EXPECT_EQ(base(orders[0].at("edges")), (std::vector<bool>{true, true, false}));
    EXPECT_EQ(orders[0].at("timestamp"), "1970-01-01T00:00:00.000Z");
    const Json& stop = orders[0].at("nodes")[2];
    EXPECT_EQ(stop.at("nodePosition"), Json({{"x", 0.25}, {"y", 2.75}, {"mapId", "hall"}}));
    EXPECT_EQ(stop.at("sequenceId"), 4);
    EXPECT_EQ(orders[0].at("edges")[1].at("sequenceId"), 3);
    EXPECT_EQ(orders[0].at("edges")[1].at("maximumSpeed"), 0.5);
    EXPECT_EQ(orders[0].at("edges")[1].at("trajectory").at("controlPoints")[1], Json({{"x", 0.25}, {"y", 2.75}}));
}

// An update begins with the decision point, unchanged, and has an id one higher.
TEST_F(PlanVda5050, ReleasesTheNextPartInAnUpdate) {
    const Json orders = messages().at("orders");
    ASSERT_EQ(orders.size(), 2U);
    EXPECT_EQ(orders[1].at("orderId"), orders[0].at("orderId"));
    EXPECT_EQ(orders[0].at("orderUpdateId"), 0);
    EXPECT_EQ(orders[1].at("orderUpdateId"), 1);
    EXPECT_EQ(orders[1].at("headerId"), 1);
    EXPECT_EQ(orders[1].at("nodes")[0], orders[0].at("nodes")[2]);
    EXPECT_EQ(base(orders[1].at("nodes")), (std::vector<bool>{true, true}));
    EXPECT_EQ(orders[1].at("timestamp"), "1970-01-01T00:00:09.000Z");
    EXPECT_EQ(orders[1].at("orderDescription"), "to be sent when open: obstacle 1");
}

TEST_F(PlanVda5050, HasAReleaseZoneForEachOpening) {
    const Json sets = messages().at("zoneSets");
    ASSERT_EQ(sets.size(), 1U);
    const Json& zones = sets[0].at("zoneSet").at("zones");
    ASSERT_EQ(zones.size(), 1U);
    EXPECT_EQ(zones[0].at("zoneId"), "obstacle-1");
    EXPECT_EQ(zones[0].at("zoneType"), "RELEASE");
    double left = 1e9, right = -1e9, low = 1e9, high = -1e9;
    for (const Json& corner : zones[0].at("vertices")) {
        left = std::min(left, corner.at("x").get<double>());
        right = std::max(right, corner.at("x").get<double>());
        low = std::min(low, corner.at("y").get<double>());
        high = std::max(high, corner.at("y").get<double>());
    }
    EXPECT_EQ(zones[0].at("vertices").size(), 4U);
    EXPECT_EQ((std::array{left, right, low, high}), (std::array{1.0, 1.5, 2.5, 3.5}));
}

// Those that hold for the vehicle, behind what opens.
TEST_F(PlanVda5050, HasABlockedZoneForEachThatItKeepsOutOf) {
    const std::vector<Point> corners{{0, 1}, {1.5, 1}, {1, 2.5}};
    const std::vector<Zone> zones{{ZoneKind::keep_out, {corners}, "yard", {"ground"}},
                                  {ZoneKind::no_fly, {corners}, "", {}},
                                  {ZoneKind::keep_out, {corners}, "", {"other"}}};
    const Json bare = messages().at("zoneSets")[0].at("zoneSet");
    const Json set =
        Json::parse(plan_vda5050({.plan = plan, .map = map, .zones = zones}, mission)).at("zoneSets")[0].at("zoneSet");
    EXPECT_NE(set.at("zoneSetId"), bare.at("zoneSetId"));
    ASSERT_EQ(set.at("zones").size(), bare.at("zones").size() + 1);
    EXPECT_EQ(set.at("zones").back(),
              Json::parse(R"({"zoneId": "zone-1", "zoneType": "BLOCKED", "zoneDescriptor": "yard",
        "vertices": [{"x": -0.75, "y": 3.25}, {"x": 0.0, "y": 3.25}, {"x": -0.25, "y": 2.5}]})"));
}

// Who stands before the crate at first has an order that lets it go nowhere, and is the same to the vehicle on every
// day.
TEST_F(PlanVda5050, LetsWhoMustWaitStandAtItsStart) {
    plan.agents[0].path = {{2, 2, 0}, {2, 2, 9}, {6, 2, 13}};
    const Json orders = messages().at("orders");
    ASSERT_EQ(orders.size(), 2U);
    EXPECT_EQ(base(orders[0].at("nodes")), (std::vector<bool>{true, false}));
    EXPECT_EQ(base(orders[1].at("nodes")), (std::vector<bool>{true, true}));
    EXPECT_EQ(messages().at("orders"), orders);
    plan.agents[0].path.back().t = 14;
    plan.agents[0].path[1].t = 10;
    EXPECT_NE(messages().at("orders")[0].at("orderId"), orders[0].at("orderId"));
    plan.agents[0].path = {{2, 2, 0}};
    EXPECT_EQ(messages().at("orders").size(), 1U);
}

// Such as a breach that had begun when the plan was revised.
TEST_F(PlanVda5050, WaitsForWhatOpensByItself) {
    const Json planned = messages();
    mission.rules.opened = {{plan.breaches[0].obstacle, 9}};
    plan.breaches.clear();
    EXPECT_EQ(messages(), planned);
    mission.rules.opened[0].at = 0;
    EXPECT_EQ(base(messages().at("orders")[0].at("nodes")), (std::vector<bool>{true, true, true, false}));
    EXPECT_TRUE(messages().at("zoneSets")[0].at("zoneSet").at("zones").empty());
}

// A base that was sent cannot be taken back: the order is cancelled, and the new one releases what the vehicle is bound
// to do. Then come the rest and, when it is open, what lies behind the crate.
TEST_F(PlanVda5050, OfARevisionEndsTheBaseAtTheDecisionPoint) {
    EXPECT_TRUE(messages().at("instantActions").empty());
    const std::string before = messages().at("orders")[0].at("orderId");
    plan.agents[0].path = {{1, 0, 1}, {2, 0, 2}, {2, 2, 4}, {2, 2, 9}, {6, 2, 13}};
    plan.revised = Revised{.number = 1, .sequence = 1, .now = 1, .decisions = {{"ground", 1, 2}, {"air", 0, 1}}};
    const Json orders = messages().at("orders");
    ASSERT_EQ(orders.size(), 3U);
    EXPECT_NE(orders[0].at("orderId"), before);
    EXPECT_EQ(base(orders[0].at("nodes")), (std::vector<bool>{true, true, false, false}));
    EXPECT_EQ(base(orders[0].at("edges")), (std::vector<bool>{true, false, false}));
    EXPECT_EQ(base(orders[1].at("nodes")), (std::vector<bool>{true, true, false}));
    EXPECT_EQ(base(orders[2].at("nodes")), (std::vector<bool>{true, true}));
    for (std::size_t i = 0; i < orders.size(); ++i) {
        EXPECT_EQ(orders[i].at("orderUpdateId"), i);
        EXPECT_EQ(orders[i].at("orderId"), orders[0].at("orderId"));
    }
    EXPECT_EQ(orders[1].at("timestamp"), "1970-01-01T00:00:02.000Z");
    const Json actions = messages().at("instantActions");
    ASSERT_EQ(actions.size(), 1U);
    EXPECT_EQ(actions[0].at("serialNumber"), "ground");
    EXPECT_EQ(actions[0].at("timestamp"), "1970-01-01T00:00:01.000Z");
    EXPECT_EQ(actions[0].at("actions")[0].at("actionType"), "cancelOrder");
    // Who decides where it stands is bound to nothing.
    plan.revised->decisions[0] = {"ground", 0, 1};
    EXPECT_EQ(base(messages().at("orders")[0].at("nodes")), (std::vector<bool>{true, false, false, false}));
}

// A vehicle refuses another set under a name that it knows.
TEST_F(PlanVda5050, NamesAZoneSetByWhatIsInIt) {
    const auto id = [&] { return messages().at("zoneSets")[0].at("zoneSet").at("zoneSetId").get<std::string>(); };
    const std::string one = id();
    EXPECT_EQ(one, id());
    plan.breaches.clear();
    EXPECT_NE(one, id());
}

TEST_F(PlanVda5050, NeedsIdsThatCanBeSerialNumbers) {
    for (const char* const good : {"ground", "AMR-7.b:2_x"}) {
        plan.agents[0].id = good;
        EXPECT_EQ(messages().at("orders")[0].at("serialNumber"), good);
    }
    for (const char* const bad : {"", "hall/1", "+", "amr 7", "Käfer"}) {
        plan.agents[0].id = bad;
        EXPECT_NE(input_error([&] { messages(); }).find("rename the agent"), std::string::npos) << bad;
    }
}

TEST_F(PlanVda5050, NeedsMetres) {
    const io::MapFile bare{.map = map_from_ascii("..#.."), .source = "yard.map"};
    const std::string error = input_error([&] { plan_vda5050({.plan = plan, .map = bare}, mission); });
    EXPECT_EQ(error.find("yard.map: VDA 5050 counts in metres"), 0U) << error;
}

}  // namespace
}  // namespace waybreaker::exports
