// Floods, debris and closed streets, drawn in cells and laid over a town: by an import, and over the finished map.
#include "city/overlay_source.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "city/city_import.hpp"
#include "city/import_window.hpp"
#include "city/osm_drawing.hpp"
#include "input_error.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::city {
namespace {

using site::OverlayUse;

// A letter for each cell: water, x for forbidden, Building, barrier.
std::string picture(const Map& map, const site::Annotations& known) {
    constexpr std::string_view letters = "?Bbwcx";
    std::string text;
    for (Cell c; c.y < map.height(); ++c.y) {
        for (c.x = 0; c.x < map.width(); ++c.x) {
            const ObstacleId id = map.obstacle_at(c);
            text += id ? letters[std::size_t(known.kinds.at(id.value))] : '.';
        }
        text += '\n';
    }
    return text;
}

// GeoJSON drawn in the cells of the town's window.
class Shapes {
  public:
    Shapes& area(const std::string& properties, std::vector<Point> ring) {
        ring.push_back(ring.front());
        return add("Polygon", "[[" + corners(ring) + "]]", properties);
    }
    Shapes& line(const std::string& properties, const std::vector<Point>& points) {
        return add("LineString", "[" + corners(points) + "]", properties);
    }
    Shapes& point(const std::string& properties, const Point& at) { return add("Point", corners({at}), properties); }
    Shapes& raw(const std::string& geometry) {
        features_ += fmt::format(R"({}{{"type":"Feature","properties":{{}},"geometry":{}}})",
                                 features_.empty() ? "" : ",", geometry);
        return *this;
    }
    std::string json(const std::string& more = "") const {
        return fmt::format(R"({{"type":"FeatureCollection",{}"features":[{}]}})", more, features_);
    }

  private:
    Shapes& add(const char* type, const std::string& coordinates, const std::string& properties) {
        features_ +=
            fmt::format(R"({}{{"type":"Feature","properties":{{{}}},"geometry":{{"type":"{}","coordinates":{}}}}})",
                        features_.empty() ? "" : ",", properties, type, coordinates);
        return *this;
    }
    std::string corners(const std::vector<Point>& points) const {
        std::string text;
        for (const Point& point : points) {
            const auto [lon, lat] = geotiff::ToLonLat(place_)(point.x, point.y);
            text += fmt::format("{}[{:.9f},{:.9f}]", text.empty() ? "" : ",", lon, lat);
        }
        return text;
    }

    site::Georeference place_ = import_window(town_window).georeference;
    std::string features_;
};

class Overlays : public TemporaryFolder {
  protected:
    // A house, a street from north to south, and a bridge.
    OsmDrawing town_ = OsmDrawing(town_window)
                           .area("building=yes|name=Mill", box(-0.4, -0.4, 3.4, 1.4))
                           .way("highway=residential|name=High Street", {{6, -1}, {6, 14}})
                           .way("highway=residential|bridge=yes|width=5", {{11, 2}, {11, 8}});

    ImportReport imported(const std::vector<OverlaySource>& overlays = {}) const {
        ImportOptions options = town_window;
        options.overlays = overlays;
        return import_city(put("town.osm", town_.xml()), options);
    }
    OverlaySource source(OverlayUse use, const Shapes& shapes, double width = 0) const {
        return {.file = put("today.geojson", shapes.json()), .use = use, .width = width};
    }
    // By the import, and over the finished map: the same.
    std::string laid(const OverlaySource& source) const {
        const ImportReport report = imported({source});
        geotiff::LabelTiff tiff = geotiff::read_label_tiff(geotiff::label_tiff_bytes(imported().tiff), "town.tif");
        site::DescribedMap map{tiff.map, tiff.annotations};
        reports_ = report.overlays;
        lay_over(source, *tiff.georeference, {}, map);
        tiff.map = map.map;
        tiff.annotations = map.annotations;
        EXPECT_EQ(geotiff::label_tiff_bytes(tiff), geotiff::label_tiff_bytes(report.tiff));
        return picture(report.tiff.map, report.tiff.annotations);
    }
    OverlayReport report() const { return reports_.at(0); }

  private:
    mutable std::vector<OverlayReport> reports_;
};

TEST_F(Overlays, of_water_bar_streets_and_leave_bridges_open) {
    const Shapes flood = Shapes().area(R"("name":"Flood")", box(-1, 0.6, 14, 6.4));
    EXPECT_EQ(laid(source(OverlayUse::water, flood)),
              "BBBB..........\n"
              "wwwwwwwwwww.ww\n"
              "wwwwwwwwwc...c\n"
              "wwwwwwwwwc...c\n"
              "wwwwwwwwwc...c\n"
              "wwwwwwwwwc...c\n"
              "wwwwwwwwwc...c\n"
              ".........c...c\n"
              ".........c...c\n"
              "..............\n"
              "..............\n"
              "..............\n"
              "..............\n"
              "..............\n");
    const geotiff::LabelTiff tiff = imported({source(OverlayUse::water, flood)}).tiff;
    EXPECT_EQ(tiff.annotations.name_of(tiff.map.obstacle_at({6, 3})), "Flood");
    EXPECT_EQ(tiff.annotations.name_of(tiff.map.obstacle_at({0, 0})), "Mill");
    EXPECT_FALSE(tiff.map.obstacle(tiff.map.obstacle_at({6, 3})).destructible);
    EXPECT_EQ(tiff.annotations.title, imported().tiff.annotations.title + ", today as water");
    EXPECT_EQ(report().things, 1U);
    EXPECT_TRUE(report().notes.empty());
}

TEST_F(Overlays, of_closures_bar_bridges_as_well) {
    const std::string map = laid(source(OverlayUse::closed, Shapes().line(R"("width":4)", {{-1, 4.5}, {14, 4.5}})));
    EXPECT_EQ(map.substr(4 * 15, 30),
              "xxxxxxxxxcxxxc\n"
              "xxxxxxxxxcxxxc\n");
}

TEST_F(Overlays, of_debris_lie_on_open_ground_and_can_be_removed) {
    const Shapes debris = Shapes()
                              .area(R"("name":"Fallen front","volume":40)", box(1.6, -0.4, 7.4, 1.4))
                              .area(R"("name":"Tree")", box(7.6, 3.6, 8.4, 4.4));
    const std::string map = laid(source(OverlayUse::debris, debris));
    EXPECT_EQ(map.substr(0, 15), "BBBBbbbb......\n");
    EXPECT_EQ(map.substr(4 * 15, 15), "........bc...c\n");
    ImportOptions options = town_window;
    options.overlays = {source(OverlayUse::debris, debris)};
    options.choice.weight = {"area", 2};
    const geotiff::LabelTiff tiff = import_city(path("town.osm"), options).tiff;
    const Obstacle& front = tiff.map.obstacle(tiff.map.obstacle_at({5, 0}));
    EXPECT_TRUE(front.destructible);
    EXPECT_NEAR(front.weight, 2 * 5.8 * 2 * 1.8 * 2, 1);  // in the window
    EXPECT_EQ(tiff.annotations.name_of(front.id), "Fallen front");
    EXPECT_EQ(tiff.annotations.tags.at("barrier=debris").size(), 2U);
}

TEST_F(Overlays, take_as_long_to_remove_as_their_volume_says) {
    const Shapes debris = Shapes().area(R"("volume":"40 m3")", box(7.6, 3.6, 8.4, 4.4));
    const ImportReport town = imported();
    site::DescribedMap map{town.tiff.map, town.tiff.annotations};
    lay_over(source(OverlayUse::debris, debris), *town.tiff.georeference, {.breach_time = {"volume", 1.5}}, map);
    EXPECT_EQ(map.map.obstacle(map.map.obstacle_at({8, 4})).breach_time, 60);
}

TEST_F(Overlays, say_so_where_nothing_has_the_property) {
    const Shapes debris = Shapes().area(R"("volume":40)", box(7.6, 3.6, 8.4, 4.4));
    const ImportReport town = imported();
    const auto notes = [&](OverlayUse use, const OverlayCosts& costs) {
        site::DescribedMap map{town.tiff.map, town.tiff.annotations};
        return lay_over(source(use, debris), *town.tiff.georeference, costs, map).notes;
    };
    const OverlayCosts misspelt{.weight = {"volme"}, .breach_time = {"volume"}};
    EXPECT_EQ(notes(OverlayUse::debris, misspelt),
              std::vector<std::string>{"nothing of it says a number above 0 as 'volme': each weighs 1"});
    EXPECT_TRUE(notes(OverlayUse::water, misspelt).empty());
    EXPECT_TRUE(notes(OverlayUse::debris, {.weight = {"area"}}).empty());
}

TEST_F(Overlays, of_walls_have_at_least_a_cell) {
    const std::string map = laid(source(OverlayUse::wall, Shapes().line("", {{-1, 10.2}, {14, 10.2}})));
    EXPECT_EQ(map.substr(10 * 15, 15), "bbbbbbbbbbbbbb\n");
}

TEST_F(Overlays, of_free_ground_open_what_stands_there) {
    EXPECT_EQ(laid(source(OverlayUse::free, Shapes().area("", box(-1, -1, 14, 14)))).find_first_not_of(".\n"),
              std::string::npos);
    // All cells that a line touches, as a way does.
    const std::string map = laid(source(OverlayUse::free, Shapes().line("", {{0.2, -1}, {1.9, 2}})));
    EXPECT_EQ(map.substr(0, 30),
              "..BB..........\n"
              "B..B..........\n");
}

TEST_F(Overlays, of_points_are_discs_of_the_width_that_is_given) {
    const Shapes crater = Shapes().point("", {9, 9}).point(R"("width":5.9)", {3, 11});
    EXPECT_EQ(laid(source(OverlayUse::closed, crater)).substr(9 * 15, 75),
              "..............\n"
              "..xxx.........\n"
              "..xxx.........\n"
              "..xxx.........\n"
              "..............\n");
    EXPECT_EQ(report().notes, std::vector<std::string>{"1 point is left out; a width makes a disc of it"});
    EXPECT_NE(laid(source(OverlayUse::closed, crater, 2)).substr(9 * 15, 15).find('x'), std::string::npos);
}

TEST_F(Overlays, in_other_coordinate_systems_lie_where_they_are) {
    const std::vector<Point> flood = box(5.6, -1, 8.4, 14);
    const std::string expected = laid(source(OverlayUse::water, Shapes().area("", flood)));
    const std::array<double, 6> transform = import_window(town_window).georeference.transform;
    std::string corners;
    for (const std::size_t i : {0U, 1U, 2U, 3U, 0U}) {
        corners += fmt::format("{}[{:.3f},{:.3f}]", corners.empty() ? "" : ",", transform[0] + (flood[i].x + 0.5) * 2,
                               transform[3] - (flood[i].y + 0.5) * 2);
    }
    const std::string system = R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::32633"}},)";
    const std::string metres =
        put("metres.geojson", Shapes().raw(R"({"type":"Polygon","coordinates":[[)" + corners + "]]}").json(system));
    const ImportReport report = imported({{.file = metres, .use = OverlayUse::water}});
    EXPECT_EQ(picture(report.tiff.map, report.tiff.annotations), expected);
}

TEST_F(Overlays, beside_the_map_change_nothing_and_say_so) {
    const OverlaySource far = source(OverlayUse::water, Shapes().area("", box(40, 40, 50, 50)));
    EXPECT_EQ(geotiff::label_tiff_bytes(imported({far}).tiff), geotiff::label_tiff_bytes(imported().tiff));
    EXPECT_EQ(imported({far}).overlays.at(0).notes, std::vector<std::string>{"nothing of it lies on the map"});
    const OverlaySource none = source(OverlayUse::free, Shapes());
    EXPECT_EQ(geotiff::label_tiff_bytes(imported({none}).tiff), geotiff::label_tiff_bytes(imported().tiff));
}

TEST_F(Overlays, say_what_they_leave_out) {
    const Shapes broken =
        Shapes()
            .area("", box(4.6, 4.6, 5.4, 5.4))
            .raw("null")
            .raw(R"({"type":"Polygon","coordinates":[[[13.4,52.52],[NaN,52.52],[13.4,NaN],[13.4,52.52]]]})");
    laid(source(OverlayUse::closed, broken));
    EXPECT_EQ(report().things, 1U);
    ASSERT_EQ(report().notes.size(), 1U);
    EXPECT_NE(report().notes[0].find("left out"), std::string::npos);
}

TEST_F(Overlays, that_cannot_be_read_are_refused_with_a_remedy) {
    const auto refused = [&](const std::string& name, const std::string& bytes) {
        const std::string file = put(name, bytes);
        return input_error([&] { imported({{.file = file, .use = OverlayUse::water}}); });
    };
    EXPECT_NE(
        refused(
            "x.geojson",
            R"({"type":"Polygon","coordinates":[[[392000,5820000],[392010,5820000],[392000,5820010],[392000,5820000]]]})")
            .find("its coordinates are not longitude and latitude"),
        std::string::npos);
    EXPECT_NE(refused("x.txt", "hello").find("cannot be read as map data"), std::string::npos);
    const std::string missing =
        input_error([&] { imported({{.file = path("no.geojson"), .use = OverlayUse::water}}); });
    EXPECT_NE(missing.find("no such file"), std::string::npos);
}

// Of two that lie over each other the first has the cells that both cover; of two overlays the later one.
TEST_F(Overlays, keep_an_order) {
    const Shapes both =
        Shapes().area(R"("name":"A")", box(7.6, 9.6, 9.4, 11.4)).area(R"("name":"B")", box(8.6, 9.6, 10.4, 11.4));
    const geotiff::LabelTiff tiff = imported({source(OverlayUse::closed, both)}).tiff;
    EXPECT_EQ(tiff.annotations.name_of(tiff.map.obstacle_at({9, 10})), "A");
    EXPECT_EQ(tiff.annotations.name_of(tiff.map.obstacle_at({10, 10})), "B");
    const std::string flood = put("flood.geojson", Shapes().area("", box(7.6, 9.6, 10.4, 11.4)).json());
    const std::string bridge = put("bridge.geojson", Shapes().line("", {{9, 8}, {9, 13}}).json());
    const geotiff::LabelTiff crossed =
        imported({{.file = flood, .use = OverlayUse::water}, {.file = bridge, .use = OverlayUse::free}}).tiff;
    EXPECT_FALSE(crossed.map.obstacle_at({9, 10}));
    EXPECT_TRUE(crossed.map.obstacle_at({8, 10}));
}

}  // namespace
}  // namespace waybreaker::city
