// Fields of CSV, and that no name is a formula to a spreadsheet.
#include "io/csv_field.hpp"

#include <gtest/gtest.h>

#include "io/plan_csv.hpp"
#include "mapfile/map_reader.hpp"

namespace waybreaker::io {
namespace {

TEST(CsvField, IsQuotedWhereItMustBe) {
    EXPECT_EQ(csv_field(""), "");
    EXPECT_EQ(csv_field("Town hall"), "Town hall");
    EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
    EXPECT_EQ(csv_field("the \"Eagle\""), "\"the \"\"Eagle\"\"\"");
    EXPECT_EQ(csv_field("two\nlines"), "\"two\nlines\"");
}

TEST(CsvField, IsNoFormula) {
    for (const std::string text : {"=1", "+1+1", "-x", "@SUM(A1)", "\t=1", "- 5", "-5;", "-"}) {
        EXPECT_EQ(csv_field(text), "'" + text);
    }
    EXPECT_EQ(csv_field("\r=1"), "\"'\r=1\"");
    EXPECT_EQ(csv_field("=cmd|'/C calc'!A0,1"), "\"'=cmd|'/C calc'!A0,1\"");
    for (const std::string text : {"-5", "-0.25", "-1e-07", "5", "'=1", "a=1", "1+1"}) EXPECT_EQ(csv_field(text), text);
}

TEST(PlanCsv, AgentsNamesAreNoFormulas) {
    const MapFile map = mapfile::parse_map("type octile\nheight 1\nwidth 2\nmap\n..\n", "m.map");
    Plan plan;
    plan.agents = {{.id = "=1+1", .kind = AgentKind::ground, .path = {{0, 0, 0}, {1, 0, 1}}}};
    EXPECT_EQ(plan_csv(plan, map, {}),
              "agent,kind,t,x,y,map_x,map_y,lon,lat,breaches,area_m2,time_unit,map_crs\n"
              "'=1+1,ground,0,0,0,0.5,0.5,,,,,cells at speed 1,\n"
              "'=1+1,ground,1,1,0,1.5,0.5,,,,,cells at speed 1,\n");
}

}  // namespace
}  // namespace waybreaker::io
