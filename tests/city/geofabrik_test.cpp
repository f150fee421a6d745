// A town as Geofabrik offers it: a folder of shapefiles, whose fclass says what things are.
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <filesystem>
#include <string>
#include <vector>

#include "city/ground_picture.hpp"
#include "city/import_window.hpp"
#include "city/town_ground.hpp"

namespace waybreaker::city {
namespace {

struct Thing {
    const char* fclass;
    std::vector<Point> points;
    const char* bridge = "F";
};

class Geofabrik : public TemporaryFolder {
  protected:
    Geofabrik() { GDALAllRegister(); }

    void layer(const std::string& name, OGRwkbGeometryType type, const std::vector<Thing>& things) const {
        OGRSpatialReference wgs84;
        wgs84.SetWellKnownGeogCS("WGS84");
        GDALDriver& driver = *GetGDALDriverManager()->GetDriverByName("ESRI Shapefile");
        const GDALDatasetUniquePtr file(
            driver.Create(path("town/" + name + ".shp").c_str(), 0, 0, 0, GDT_Unknown, nullptr));
        OGRLayer& layer = *file->CreateLayer(name.c_str(), &wgs84, type);
        for (const char* text : {"osm_id", "fclass", "bridge"}) {
            OGRFieldDefn field(text, OFTString);
            ASSERT_EQ(layer.CreateField(&field), OGRERR_NONE);
        }
        OGRFieldDefn code("code", OFTInteger);
        ASSERT_EQ(layer.CreateField(&code), OGRERR_NONE);
        for (const Thing& thing : things) {
            OGRFeature feature(layer.GetLayerDefn());
            feature.SetField("osm_id", "7");
            feature.SetField("fclass", thing.fclass);
            feature.SetField("bridge", thing.bridge);
            OGRLinearRing line;
            for (const Point& point : thing.points) {
                const auto [longitude, latitude] = to_lon_lat_(point.x, point.y);
                line.addPoint(longitude, latitude);
            }
            OGRPolygon area;
            if (type == wkbPolygon) {
                line.closeRings();
                area.addRing(&line);
            }
            const OGRLineString way(line);
            feature.SetGeometry(type == wkbPolygon ? static_cast<const OGRGeometry*>(&area) : &way);
            ASSERT_EQ(layer.CreateFeature(&feature), OGRERR_NONE);
        }
    }
    void draw() const {
        std::filesystem::create_directory(path("town"));
        layer("gis_osm_buildings_a_free_1", wkbPolygon, {{"building", box(0.6, 0.6, 3.4, 2.4)}});
        layer("gis_osm_water_a_free_1", wkbPolygon,
              {{"river", box(-1, 4.6, 14, 8.4)}, {"glacier", box(11.6, 10.6, 14, 14)}});
        layer("gis_osm_roads_free_1", wkbLineString,
              {{"residential", {{6, -1}, {6, 3}}},
               {"residential", {{6, 3}, {6, 10}}, "T"},
               {"track_grade2", {{6, 10}, {6, 15}}}});
        layer("gis_osm_pois_a_free_1", wkbPolygon, {{"park", box(0.6, 10.6, 3.4, 12.4)}});
    }

  private:
    geotiff::ToLonLat to_lon_lat_{import_window(town_window).georeference};
};

TEST_F(Geofabrik, HasWaterThatItsBridgesCross) {
    draw();
    ImportOptions options = town_window;
    const std::string rover = picture(import_city(path("town"), options).tiff);
    EXPECT_EQ(rover.substr(0, 45), "..............\n.BBB..........\n.BBB..........\n") << rover;
    EXPECT_EQ(rover.substr(5 * 15, 2), "ww") << rover;
    EXPECT_EQ(rover.substr(5 * 15 + 6, 1), ".") << rover;
    EXPECT_EQ(rover.substr(12 * 15 + 12, 2), "xx") << rover;
    options.profile = Profile::paper;
    EXPECT_EQ(import_city(path("town"), options).buildings, 1U);
}

TEST_F(Geofabrik, HasNoBuildingsInItsWater) {
    draw();
    ImportOptions options = town_window;
    options.choice.layer = "gis_osm_water_a_free_1";
    const ImportReport water = import_city(path("town"), options);
    EXPECT_EQ(water.buildings, 0U);
    for (const Obstacle& obstacle : water.tiff.map.obstacles()) EXPECT_FALSE(obstacle.destructible);
}

TEST_F(Geofabrik, KeepsItsAttributes) {
    draw();
    ImportOptions options = town_window;
    options.choice.layer = "gis_osm_water_a_free_1";
    options.choice.obstacles = {{"fclass", {"river"}}};
    EXPECT_EQ(import_city(path("town"), options).tiff.map.obstacles().size(), 1U);
}

TEST_F(Geofabrik, IsKnownByItsAttributesAndName) {
    std::filesystem::create_directory(path("town"));
    layer("houses", wkbPolygon, {{"building", box(0.6, 0.6, 3.4, 2.4)}});
    EXPECT_EQ(import_city(path("town/houses.shp"), town_window).buildings, 1U);  // as any layer of areas
}

}  // namespace
}  // namespace waybreaker::city
