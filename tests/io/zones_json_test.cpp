#include "io/zones_json.hpp"

#include <gtest/gtest.h>

#include <string>

#include "input_error.hpp"
#include "io/mission_json.hpp"

namespace waybreaker::io {
namespace {

constexpr auto airport = R"({"type": "FeatureCollection", "crs": "cells", "features": [
  {"type": "Feature", "properties": {"zone": "no_fly", "name": "airport", "agents": ["air"], "osm_id": 4},
   "geometry": {"type": "Polygon", "coordinates": [[[40, 10], [90, 10.5], [90, 60], [40, 10]],
                                                   [[50, 20, 7], [60, 20, 7], [60, 25, 7]]]}}]})";

std::string feature(const std::string& properties, const std::string& geometry) {
    return R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": )" + properties +
           R"(, "geometry": )" + geometry + "}]}";
}

constexpr auto triangle = R"({"type": "Polygon", "coordinates": [[[1, 1], [2, 1], [2, 2], [1, 1]]]})";

std::string fault_of(const std::string& text) {
    return input_error([&] { parse_zones(text, "zones.geojson"); });
}

TEST(ZonesJson, ReadsPolygons) {
    const ZoneCollection given = parse_zones(airport, "zones.geojson");
    EXPECT_TRUE(given.in_cells);
    const Zone expected{.kind = ZoneKind::no_fly,
                        .polygon = {{{40, 10}, {90, 10.5}, {90, 60}}, {{50, 20}, {60, 20}, {60, 25}}},
                        .name = "airport",
                        .agents = {"air"}};
    EXPECT_EQ(given.zones, std::vector<Zone>{expected});
}

TEST(ZonesJson, MakesAZoneOfEachPolygon) {
    const ZoneCollection given =
        parse_zones(feature(R"({"zone": "keep_out"})", R"({"type": "MultiPolygon", "coordinates": [
            [[[1, 1], [2, 1], [2, 2], [1, 1]]], [[[5, 5], [6, 5], [6, 6], [5, 5]]]]})"),
                    "zones.geojson");
    EXPECT_FALSE(given.in_cells);
    ASSERT_EQ(given.zones.size(), 2U);
    EXPECT_EQ(given.zones[1].kind, ZoneKind::keep_out);
    EXPECT_EQ(given.zones[1].polygon, (std::vector<std::vector<Point>>{{{5, 5}, {6, 5}, {6, 6}}}));
}

TEST(ZonesJson, SaysWhatIsWrongAndWhere) {
    EXPECT_EQ(fault_of(feature("{}", triangle)), "zones.geojson:1:78: features[0].properties has no member zone");
    EXPECT_NE(fault_of(feature(R"({"zone": "park"})", triangle)).find("is none of no_fly, keep_out"),
              std::string::npos);
    EXPECT_NE(fault_of(feature(R"({"zone": "no_fly", "agents": []})", triangle)).find("names nobody"),
              std::string::npos);
    EXPECT_NE(fault_of(feature(R"({"zone": "no_fly", "until": "5"})", triangle)).find("until is not a number"),
              std::string::npos);
    EXPECT_NE(fault_of(feature(R"({"zone": "no_fly"})", R"({"type": "Point", "coordinates": [1, 2]})"))
                  .find("is none of Polygon, MultiPolygon"),
              std::string::npos);
    EXPECT_NE(fault_of(feature(R"({"zone": "no_fly"})", R"({"type": "Polygon", "coordinates": [[[1]]]})"))
                  .find("is no position, [x, y]"),
              std::string::npos);
    EXPECT_NE(fault_of(R"({"type": "FeatureCollection", "crs": "EPSG:25833", "features": []})").find("crs is neither"),
              std::string::npos);
    EXPECT_EQ(fault_of(R"({"type": "FeatureCollection", "features": [],
                           "crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:OGC:1.3:CRS84"}}})"),
              "");
}

TEST(ZonesJson, HasTheTimesBetweenWhichItHolds) {
    const std::string text = feature(R"({"zone": "no_fly", "from": 10.5, "until": 20})", triangle);
    const std::vector<Zone> zones = parse_zones(text, "zones.geojson").zones;
    ASSERT_EQ(zones.size(), 1U);
    EXPECT_EQ(zones[0].from, 10.5);
    EXPECT_EQ(zones[0].until, 20);
    EXPECT_EQ(parse_zones(zones_json(zones).dump(), "again").zones, zones);
    EXPECT_EQ(zones_json(zones)["features"][0]["properties"].dump(), R"({"zone":"no_fly","from":10.5,"until":20.0})");
    const std::vector<Zone> always{{.polygon = zones[0].polygon}};
    EXPECT_EQ(zones_json(always)["features"][0]["properties"].dump(), R"({"zone":"no_fly"})");
}

TEST(ZonesJson, StandsInMissionFiles) {
    const std::string agents =
        R"("agents": [{"id": "ground", "kind": "ground", "start": [0, 0], "goal": [9, 9]}], "rules": {"zones": )";
    const std::string begin = R"({"format": "waybreaker-mission/1", )" + agents;
    const MissionDocument document = parse_mission(begin + airport + "}}", "mission.json");
    ASSERT_EQ(document.mission.rules.zones.size(), 1U);
    const MissionDocument again = parse_mission(mission_text(document), "mission.json");
    EXPECT_EQ(again.mission.rules.zones, document.mission.rules.zones);
    EXPECT_NE(input_error([&] {
                  parse_mission(begin + feature(R"({"zone": "no_fly"})", triangle) + "}}", "mission.json");
              }).find("rules.zones are not in cells"),
              std::string::npos);
    EXPECT_EQ(mission_text({}).find("zones"), std::string::npos);
}

}  // namespace
}  // namespace waybreaker::io
