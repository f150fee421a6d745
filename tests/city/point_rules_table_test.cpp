// What bars whom, feature by feature: points in walls and on ways. The reasons stand beside the rules in
// src/city/point_rules.cpp.
#include <gtest/gtest.h>

#include <vector>

#include "city/lots.hpp"

namespace waybreaker::city {
namespace {

using PointRulesTable = GroundRulesTable;

const std::vector<Row> points{
    {"barrier=gate", "..."},
    {"barrier=gate|access=private", "ddd"},
    {"barrier=gate|access=private|foot=yes", ".d."},
    {"barrier=gate|locked=yes", "ddd"},
    {"barrier=gate|motor_vehicle=no", ".d."},
    {"barrier=lift_gate", "..."},
    {"barrier=swing_gate", "..."},
    {"barrier=sliding_gate", "..."},
    {"barrier=hampshire_gate", "..."},
    {"barrier=bump_gate", "..."},
    {"barrier=entrance", "..."},
    {"barrier=entrance|maxwidth=2", ".d."},
    {"barrier=toll_booth", "..."},
    {"barrier=border_control", "..."},
    {"barrier=sally_port", "..."},
    {"barrier=wicket_gate", ".d."},
    {"barrier=kissing_gate", "dd."},
    {"barrier=stile", "dd."},
    {"barrier=horse_stile", "dd."},
    {"barrier=turnstile", "dd."},
    {"barrier=full-height_turnstile", "dd."},
    {"barrier=step", "dd."},
    {"barrier=bollard", ".d."},
    {"barrier=bollard|hgv=yes", "..."},
    {"barrier=bollard|motor_vehicle=permissive", "..."},
    {"barrier=block", ".d."},
    {"barrier=planter", ".d."},
    {"barrier=jersey_barrier", ".d."},
    {"barrier=tank_trap", ".d."},
    {"barrier=cycle_barrier", ".d."},
    {"barrier=motorcycle_barrier", "dd."},
    {"barrier=cattle_grid", "..d"},
    {"barrier=bus_trap", "d.."},
    {"barrier=sump_buster", "..."},
    {"barrier=height_restrictor", ".d."},
    {"barrier=height_restrictor|maxheight=2.1", ".d."},
    {"barrier=height_restrictor|maxheight=4.2", "..."},
    {"barrier=log", "dd."},
    {"barrier=debris", "dd."},
    {"barrier=chain", "dd."},
    {"barrier=rope", "dd."},
};

// A point in a wall that no way leads through.
TEST_F(PointRulesTable, ofPointsInWalls) {
    const auto draw = [](Lot& lot, const char* tags) { lot.car_park().line("barrier=wall").point(tags); };
    expect(points, draw);
    expect({{"barrier=kerb", "ddd"}, {"barrier=wall", "ddd"}, {"highway=crossing", "ddd"}}, draw);
}

// A point on a way that leads through a wall, and would open it.
TEST_F(PointRulesTable, ofPointsInWays) {
    const auto draw = [](Lot& lot, const char* tags) {
        lot.car_park().point(tags).line("barrier=wall").way("highway=residential");
    };
    expect(points, draw);
    expect({{"barrier=kerb", "..."}, {"highway=crossing", "..."}, {"traffic_calming=bump", "..."}}, draw);
}

}  // namespace
}  // namespace waybreaker::city
