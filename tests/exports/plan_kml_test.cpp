// A plan as KML, read back by GDAL through Google's own library (LIBKML); the times of tracks, which GDAL leaves out,
// by pugixml.
#include "exports/plan_kml.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <pugixml.hpp>
#include <vector>

#include "ascii_map.hpp"
#include "exports/utc_time.hpp"
#include "input_error.hpp"
#include "placed_town.hpp"

namespace waybreaker::exports {
namespace {

class PlanKml : public PlacedTown {
  protected:
    GDALDatasetUniquePtr read_kml(const PlacedPlan& what) {
        GDALDatasetUniquePtr file = read("plan.kml", plan_kml(what));
        EXPECT_TRUE(file && file->GetDriverName() == std::string("LIBKML"));
        return file;
    }
};

TEST_F(PlanKml, HasATrackForEachAgent) {
    PlacedPlan flown = placed();
    flown.altitude = 60;
    const auto file = read_kml(flown);
    ASSERT_TRUE(file);
    OGRLayer* const layer = file->GetLayerByName("agents");
    ASSERT_TRUE(layer);
    std::size_t i = 0;
    for (const OGRFeatureUniquePtr& feature : *layer) {
        const Itinerary& agent = plan.agents.at(i++);
        EXPECT_EQ(feature->GetFieldAsString("Name"), agent.id);
        const OGRLineString& line = *feature->GetGeometryRef()->toLineString();
        ASSERT_EQ(std::size_t(line.getNumPoints()), agent.path.size());
        for (int k = 0; k < line.getNumPoints(); ++k) {
            OGRPoint point;
            line.getPoint(k, &point);
            expect_at(point, {agent.path[std::size_t(k)].x, agent.path[std::size_t(k)].y});
            EXPECT_EQ(point.getZ(), agent.kind == AgentKind::air ? 60 : 0);
        }
    }
    EXPECT_EQ(i, 2U);
}

TEST_F(PlanKml, HasTheTimeAtEachPointOfATrack) {
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(plan_kml(placed()).c_str()));
    const auto tracks = document.select_nodes("//gx:Track");
    ASSERT_EQ(tracks.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        const auto times = tracks[i].node().select_nodes("when");
        ASSERT_EQ(times.size(), plan.agents[i].path.size());
        ASSERT_EQ(times.size(), tracks[i].node().select_nodes("gx:coord").size());
        for (std::size_t k = 0; k < times.size(); ++k)
            EXPECT_EQ(times[k].node().text().get(), utc_text(placed().starts_at, plan.agents[i].path[k].t));
        EXPECT_EQ(tracks[i].node().child("altitudeMode").text().get(), std::string("clampToGround"));
    }
}

TEST_F(PlanKml, HasBreachesForAsLongAsTheyTake) {
    const auto file = read_kml(placed());
    ASSERT_TRUE(file);
    std::size_t i = 0;
    for (const OGRFeatureUniquePtr& feature : *file->GetLayerByName("breaches")) {
        const Breach& breach = plan.breaches.at(i++);
        expect_at(*feature->GetGeometryRef()->toPoint(), {double(breach.at.x), double(breach.at.y)});
        EXPECT_NEAR(seconds(*feature, "begin"), breach.cleared_at - 30, 0.002);
        EXPECT_NEAR(seconds(*feature, "end"), breach.cleared_at, 0.002);
    }
    EXPECT_GT(i, 0U);
    EXPECT_EQ(i, plan.breaches.size());
}

TEST_F(PlanKml, HasObstaclesUntilTheyOpenAndAfter) {
    const auto file = read_kml(placed());
    ASSERT_TRUE(file);
    OGRSpatialReference system(map.georeference->crs.c_str());
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    std::size_t i = 0;
    for (const OGRFeatureUniquePtr& feature : *file->GetLayerByName("obstacles")) {
        const Breach& breach = plan.breaches.at(i / 2);
        const bool opened = i % 2 == 1;
        ++i;
        EXPECT_NEAR(seconds(*feature, opened ? "begin" : "end"), breach.cleared_at, 0.002);
        EXPECT_EQ(feature->IsFieldSetAndNotNull(feature->GetFieldIndex("end")), !opened);
        OGRGeometry* const shape = feature->GetGeometryRef();
        ASSERT_EQ(shape->transformTo(&system), OGRERR_NONE);
        EXPECT_NEAR(OGR_G_Area(OGRGeometry::ToHandle(shape)), map.square_metres(breach.cells), 0.1);
    }
    EXPECT_EQ(i, 2 * plan.breaches.size());
}

// With its hole, and corners off the map.
TEST_F(PlanKml, HasZones) {
    EXPECT_FALSE(read_kml(placed())->GetLayerByName("zones"));
    const std::vector<Zone> zones{
        {ZoneKind::no_fly, {{{-5, 10}, {60, 20}, {30, 90}}, {{20, 30}, {30, 30}, {30, 40}}}, "Charité", {"air"}},
        {ZoneKind::keep_out, {{{200, 10}, {260, 20}, {230, 90}}}, "", {}, 10, 20}};
    PlacedPlan zoned = placed();
    zoned.zones = zones;
    const auto file = read_kml(zoned);
    OGRLayer* const layer = file->GetLayerByName("zones");
    ASSERT_TRUE(layer);
    std::size_t i = 0;
    for (const OGRFeatureUniquePtr& feature : *layer) {
        const Zone& zone = zones.at(i++);
        EXPECT_EQ(feature->GetFieldAsString("Name"), zone.name.empty() ? "zone 2" : zone.name);
        EXPECT_EQ(feature->GetFieldAsString("description"), std::string(i == 1 ? "no_fly for air" : "keep_out"));
        EXPECT_EQ(feature->IsFieldSetAndNotNull(feature->GetFieldIndex("begin")), i == 2 ? 1 : 0);
        EXPECT_EQ(feature->IsFieldSetAndNotNull(feature->GetFieldIndex("end")), i == 2 ? 1 : 0);
        const OGRPolygon& polygon = *feature->GetGeometryRef()->toPolygon();
        EXPECT_EQ(std::size_t(polygon.getNumInteriorRings()) + 1, zone.polygon.size());
        ASSERT_EQ(polygon.getExteriorRing()->getNumPoints(), 4);
        for (const Point corner : zone.polygon.front()) {
            bool found = false;
            const auto [lon, lat] = geotiff::lon_lat_of(map.georeference)(corner);
            for (const OGRPoint& point : *polygon.getExteriorRing())
                found = found || std::hypot(point.getX() - lon, point.getY() - lat) < 1e-8;
            EXPECT_TRUE(found) << corner.x << "," << corner.y;
        }
    }
    EXPECT_EQ(i, 2U);
}

TEST_F(PlanKml, NeedsToKnowWhereTheMapLies) {
    const io::MapFile nowhere{.map = map_from_ascii("..#.."), .source = "yard.map"};
    const std::string error = input_error([&] { plan_kml({.plan = plan, .map = nowhere}); });
    EXPECT_EQ(error.find("yard.map: KML needs longitude and latitude"), 0U) << error;
}

}  // namespace
}  // namespace waybreaker::exports
