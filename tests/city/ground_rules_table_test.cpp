// What bars whom, feature by feature: each is drawn across a small town, imported, and driven at from the north to the
// south. The reasons stand beside the rules in src/city/*_rules.cpp.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "city/city_import.hpp"
#include "city/osm_drawing.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::city {
namespace {

// For rover, truck and walker: `.` gets through, `d` only if something is destroyed, `x` never.
struct Row {
    const char* tags;
    const char* fate;
};

// Lots in rows on one map, a feature on each.
constexpr int lots = 8;    // in a row
constexpr int pitch = 22;  // cells from one to the next
const ImportOptions lots_window{
    .longitude = 13.4, .latitude = 52.52, .size = 2.0 * lots * pitch, .cell = 2, .section = 0, .background = false};

// A square of 14 cells, on which things reach from edge to edge.
class Lot {
  public:
    Lot(OsmDrawing& drawing, int number)
        : drawing_(&drawing), corner_{4 + number % lots * pitch, 4 + number / lots * pitch} {}

    // A multipolygon, which is an area whatever its tags are.
    Lot& area(const std::string& tags, double north = 4.6, double south = 8.4) {
        drawing_->area("", box(x(-2), y(north), x(15), y(south)));
        drawing_->relation(tags, {drawing_->last()});
        return *this;
    }
    Lot& line(const std::string& tags) {
        drawing_->way(tags, {{x(-2), y(6)}, {x(2), y(6)}, {x(15), y(6)}});
        return *this;
    }
    Lot& way(const std::string& tags) {
        drawing_->way(tags, {{x(6), y(-2)}, {x(6), y(6)}, {x(6), y(15)}});
        return *this;
    }
    // In the middle of line and way.
    Lot& point(const std::string& tags) {
        drawing_->point(tags, {x(6), y(6)}, true);
        return *this;
    }
    // Where trucks may drive as well, but no way that opens anything.
    Lot& car_park() { return area("amenity=parking", -2, 15); }

    char fate(const Map& map) const {
        if (gets_through([&](Cell c) { return !map.obstacle_at(c); })) return '.';
        const auto opened = [&](Cell c) {
            return !map.obstacle_at(c) || map.obstacle(map.obstacle_at(c)).destructible;
        };
        return gets_through(opened) ? 'd' : 'x';
    }

  private:
    double x(double column) const { return corner_.x + column; }
    double y(double row) const { return corner_.y + row; }

    // From the upper edge to the lower one, by sides of cells.
    template <class Open>
    bool gets_through(Open open) const {
        std::array<std::array<bool, town_side>, town_side> seen{};
        std::vector<Cell> front;
        const auto reach = [&](Cell c) {
            if (c.x < 0 || c.y < 0 || c.x >= town_side || c.y >= town_side) return;
            bool& known = seen.at(std::size_t(c.y)).at(std::size_t(c.x));
            if (known || !open(Cell{corner_.x + c.x, corner_.y + c.y})) return;
            known = true;
            front.push_back(c);
        };
        for (int column = 0; column < town_side; ++column) reach({column, 0});
        while (!front.empty()) {
            const Cell c = front.back();
            front.pop_back();
            if (c.y == town_side - 1) return true;
            for (const Cell next : {Cell{c.x - 1, c.y}, Cell{c.x + 1, c.y}, Cell{c.x, c.y - 1}, Cell{c.x, c.y + 1}}) {
                reach(next);
            }
        }
        return false;
    }

    OsmDrawing* drawing_;
    Cell corner_;
};

class GroundRulesTable : public TemporaryFolder {
  protected:
    template <class Draw>
    void expect(const std::vector<Row>& rows, Draw draw) const {
        ASSERT_LE(rows.size(), std::size_t(lots * lots));
        // A house, so that there is something to import.
        OsmDrawing town = OsmDrawing(lots_window).area("building=yes", box(-0.2, -0.2, 0.2, 0.2));
        std::vector<Lot> drawn;
        for (const Row& row : rows) {
            Lot lot(town, int(drawn.size()));
            draw(lot, row.tags);
            drawn.push_back(lot);
        }
        const std::string path = put("town.osm", town.xml());
        std::vector<std::string> fates(rows.size());
        for (const Profile profile : {Profile::rover, Profile::truck, Profile::walker}) {
            ImportOptions options = lots_window;
            options.profile = profile;
            const Map map = import_city(path, options).tiff.map;
            for (std::size_t i = 0; i < rows.size(); ++i) fates[i] += drawn[i].fate(map);
        }
        for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(fates[i], rows[i].fate) << rows[i].tags;
    }
};

TEST_F(GroundRulesTable, ofAreas) {
    expect(
        {
            {"natural=water", "xxx"},
            {"natural=water|covered=yes", "..."},
            {"natural=water|tunnel=culvert", "..."},
            {"natural=water|access=private", "xxx"},
            {"waterway=riverbank", "xxx"},
            {"waterway=dock", "xxx"},
            {"landuse=reservoir", "xxx"},
            {"landuse=basin", "xxx"},
            {"landuse=salt_pond", "xxx"},
            {"landuse=aquaculture", "xxx"},
            {"leisure=swimming_pool", "xxx"},
            {"leisure=swimming_pool|location=indoor", "..."},
            {"natural=mud", "xxx"},
            {"natural=wetland|wetland=tidalflat", "xxx"},
            {"natural=wetland|wetland=marsh", "..."},
            {"natural=glacier", "xxx"},
            {"natural=wood", "..."},
            {"natural=beach", "..."},
            {"landuse=military", "xxx"},
            {"military=barracks", "xxx"},
            {"amenity=prison", "xxx"},
            {"amenity=prison|fenced=yes", "xxx"},
            {"power=substation", "xxx"},
            {"power=substation|building=yes", "ddd"},
            {"power=plant", "..."},
            {"aeroway=runway", "xxx"},
            {"aeroway=taxiway", "xxx"},
            {"aeroway=aerodrome", "..."},
            {"leisure=garden|access=private", "xxx"},
            {"leisure=garden|access=no", "xxx"},
            {"leisure=garden|access=customers", "..."},
            {"boundary=protected_area|access=no", "..."},
            {"leisure=garden|access=private|layer=-1", "..."},
            {"man_made=storage_tank", "ddd"},
            {"man_made=silo", "ddd"},
            {"man_made=bunker_silo", "ddd"},
            {"man_made=gasometer", "ddd"},
            {"man_made=tower", "ddd"},
            {"man_made=water_tower", "ddd"},
            {"man_made=communications_tower", "ddd"},
            {"man_made=cooling_tower", "ddd"},
            {"man_made=chimney", "ddd"},
            {"man_made=lighthouse", "ddd"},
            {"man_made=windmill", "ddd"},
            {"man_made=tower|historic=tower", "xxx"},
            {"man_made=silo|building=silo", "ddd"},
            {"man_made=storage_tank|location=underground", "..."},
            {"man_made=storage_tank|layer=-1", "..."},
            {"man_made=works", "..."},
            {"man_made=bridge", "..."},
            {"building=yes", "ddd"},
            {"building=yes|amenity=hospital", "xxx"},
            {"building=roof", "..."},
            {"building=carport", "..."},
            {"building=yes|location=underground", "..."},
            {"building=parking|amenity=parking|parking=underground", "..."},
            {"building=parking|amenity=parking|parking=multi-storey", "ddd"},
            {"barrier=hedge|area=yes", "ddd"},
            {"leisure=pitch|barrier=fence", "ddd"},
            {"barrier=retaining_wall|area=yes", "xxx"},
        },
        [](Lot& lot, const char* tags) { lot.car_park().area(tags); });
}

TEST_F(GroundRulesTable, ofLines) {
    expect(
        {
            {"waterway=river", "xxx"},
            {"waterway=canal", "xxx"},
            {"waterway=river|tunnel=culvert", "..."},
            {"waterway=stream", "..."},
            {"waterway=stream|width=1.5", "..."},
            {"waterway=stream|width=3", "xx."},
            {"waterway=drain|width=2", "xx."},
            {"waterway=ditch|width=2.5 m", "xx."},
            {"waterway=ditch|width=3|tunnel=culvert", "..."},
            {"natural=cliff", "xxx"},
            {"natural=tree_row", "..."},
            {"barrier=retaining_wall", "xxx"},
            {"barrier=retaining_wall|height=3", "xxx"},
            {"barrier=retaining_wall|height=0.4", "xx."},
            {"barrier=retaining_wall|height=1'6\"", "xx."},
            {"barrier=city_wall", "xxx"},
            {"historic=citywalls", "xxx"},
            {"barrier=ditch", "xxx"},
            {"railway=rail", "xxx"},
            {"railway=light_rail", "xxx"},
            {"railway=rail|tunnel=yes", "..."},
            {"railway=tram", "..."},
            {"railway=disused", "..."},
            {"man_made=pipeline", "..."},
            {"man_made=pipeline|location=underground", "..."},
            {"man_made=pipeline|location=overhead", "..."},
            {"man_made=pipeline|location=overground", "xxx"},
            {"man_made=embankment", "..."},
            {"aeroway=runway", "xxx"},
            {"aeroway=taxiway|width=12", "xxx"},
            {"highway=motorway", "x.x"},
            {"highway=motorway|tunnel=yes", "..."},
            {"highway=trunk", "x.x"},
            {"highway=trunk|foot=yes", "..."},
            {"highway=trunk_link|foot=designated", "..."},
            {"highway=residential", "..."},
            {"highway=construction", "..."},
            {"highway=service|access=private", "xxx"},
            {"highway=service|access=private|foot=yes", ".x."},
            {"highway=service|access=destination", "..."},
            {"highway=steps", "xx."},
            {"highway=steps|ramp:wheelchair=yes", ".x."},
            {"highway=steps|indoor=yes", "..."},
            {"highway=steps|tunnel=yes|layer=-1", "..."},
            {"barrier=wall", "ddd"},
            {"barrier=fence", "ddd"},
            {"barrier=hedge", "ddd"},
            {"barrier=guard_rail", "ddd"},
            {"barrier=jersey_barrier", "ddd"},
            {"barrier=block", "ddd"},
            {"barrier=chain", "ddd"},
            {"barrier=rope", "ddd"},
            {"barrier=yes", "ddd"},
            {"barrier=log", "dd."},
            {"barrier=debris", "dd."},
            {"barrier=bollard", ".d."},
            {"barrier=planter", ".d."},
            {"barrier=tank_trap", ".d."},
            {"barrier=kerb", "..."},
            {"barrier=wall|layer=-1", "..."},
            {"barrier=wall|historic=citywalls", "xxx"},
        },
        [](Lot& lot, const char* tags) { lot.car_park().line(tags); });
}

TEST_F(GroundRulesTable, ofWaysOverWater) {
    expect(
        {
            {"highway=residential|bridge=yes", "..."},
            {"highway=residential", "..."},
            {"highway=residential|bridge=movable", "..."},
            {"highway=residential|bridge=collapsed", "xxx"},
            {"highway=residential|bridge=yes|impassable=yes", "xxx"},
            {"highway=residential|bridge=yes|access=private", "xxx"},
            {"highway=residential|bridge=yes|hgv=no", ".x."},
            {"highway=residential|bridge=yes|motor_vehicle=no", ".x."},
            {"highway=residential|bridge=yes|motor_vehicle=no|hgv=yes", "..."},
            {"highway=residential|bridge=yes|foot=no", "x.x"},
            {"highway=residential|bridge=yes|maxwidth=2", ".x."},
            {"highway=residential|bridge=yes|maxwidth=2.6", "..."},
            {"highway=residential|bridge=yes|maxwidth=8 ft", ".x."},
            {"highway=residential|bridge=yes|maxwidth:physical=2.3", ".x."},
            {"highway=residential|bridge=yes|maxweight=3.5", ".x."},
            {"highway=residential|bridge=yes|maxweight=7500 kg", ".x."},
            {"highway=residential|bridge=yes|maxweight=44", "..."},
            {"highway=residential|bridge=yes|maxweight=none", "..."},
            {"highway=residential|bridge=yes|maxweightrating=12", ".x."},
            {"highway=residential|bridge=yes|maxheight=3.5", ".x."},
            {"highway=residential|bridge=yes|maxheight=4.2 m", "..."},
            {"highway=residential|bridge=yes|maxheight=default", "..."},
            {"highway=residential|bridge=yes|maxheight=13'6\"", "..."},
            {"highway=residential|bridge=yes|maxheight=11'0\"", ".x."},
            {"highway=motorway|bridge=yes", "x.x"},
            {"highway=footway|bridge=yes", ".x."},
            {"highway=path|bridge=boardwalk", ".x."},
            {"highway=cycleway|bridge=yes", ".x."},
            {"highway=pedestrian|bridge=yes", ".x."},
            {"highway=pedestrian|bridge=yes|motor_vehicle=yes", "..."},
            {"highway=steps|bridge=yes", "xx."},
            {"highway=footway|tunnel=yes", "xxx"},
            {"highway=track|ford=yes", "..."},
            {"highway=track|ford=stepping_stones", "xx."},
            {"highway=path|ford=stepping_stones", "xx."},
            {"highway=residential|embankment=yes", "..."},
            {"man_made=pier", ".x."},
            {"route=ferry", "xxx"},
            {"highway=proposed|bridge=yes", "xxx"},
        },
        [](Lot& lot, const char* tags) { lot.car_park().area("natural=water").way(tags); });
}

// Others drive on open ground anyway.
TEST_F(GroundRulesTable, ofRoadsForTrucks) {
    expect(
        {
            {"highway=motorway", "..."},
            {"highway=residential", "..."},
            {"highway=living_street", "..."},
            {"highway=service", "..."},
            {"highway=track", "..."},
            {"highway=road", "..."},
            {"highway=pedestrian", ".x."},
            {"highway=footway", ".x."},
            {"highway=cycleway", ".x."},
            {"highway=bridleway", ".x."},
            {"highway=path", ".x."},
            {"highway=path|motor_vehicle=yes", "..."},
            {"highway=residential|hgv=no", ".x."},
            {"highway=residential|hgv=destination", "..."},
            {"highway=residential|motor_vehicle=private", ".x."},
            {"highway=residential|maxweight=3.5", ".x."},
            {"highway=residential|maxwidth=2.2", ".x."},
            {"highway=residential|impassable=yes", ".x."},
        },
        [](Lot& lot, const char* tags) { lot.way(tags); });
    expect(
        {
            {"amenity=parking", "..."},
            {"amenity=parking|parking=surface", "..."},
            {"amenity=parking|parking=underground", ".x."},
            {"amenity=parking|parking=multi-storey", ".x."},
            {"amenity=parking|access=customers", "..."},
            {"amenity=fuel", "..."},
            {"amenity=bus_station", "..."},
            {"landuse=garages", "..."},
            {"landuse=depot", "..."},
            {"landuse=industrial", ".x."},
            {"landuse=commercial", ".x."},
            {"landuse=meadow", ".x."},
            {"natural=wood", ".x."},
            {"leisure=park", ".x."},
            {"place=square", ".x."},
            {"highway=pedestrian|area=yes", ".x."},
            {"highway=service|area=yes", "..."},
            {"area:highway=residential", "..."},
            {"area:highway=footway", ".x."},
        },
        [](Lot& lot, const char* tags) { lot.area(tags, -2, 15); });
}

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
TEST_F(GroundRulesTable, ofPointsInWalls) {
    const auto draw = [](Lot& lot, const char* tags) { lot.car_park().line("barrier=wall").point(tags); };
    expect(points, draw);
    expect({{"barrier=kerb", "ddd"}, {"barrier=wall", "ddd"}, {"highway=crossing", "ddd"}}, draw);
}

// A point on a way that leads through a wall, and would open it.
TEST_F(GroundRulesTable, ofPointsInWays) {
    const auto draw = [](Lot& lot, const char* tags) {
        lot.car_park().point(tags).line("barrier=wall").way("highway=residential");
    };
    expect(points, draw);
    expect({{"barrier=kerb", "..."}, {"highway=crossing", "..."}, {"traffic_calming=bump", "..."}}, draw);
}

}  // namespace
}  // namespace waybreaker::city
