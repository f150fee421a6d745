// A plan as GeoJSON, read back by GDAL: it must lie where the map says, and on the streets of the map's source.
#include "io/plan_geojson.hpp"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "ascii_map.hpp"
#include "geotiff/georeference.hpp"
#include "input_error.hpp"
#include "mapfile/map_reader.hpp"
#include "project_folder.hpp"
#include "shared_data.hpp"
#include "temporary_folder.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::io {
namespace {

constexpr double cell = 2.4;

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

Transformation to_system_of(const MapFile& map) {
    OGRSpatialReference wgs84;
    wgs84.SetWellKnownGeogCS("WGS84");
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    OGRSpatialReference system(map.georeference->crs.c_str());
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return Transformation(OGRCreateCoordinateTransformation(&wgs84, &system));
}

class PlanGeojson : public TemporaryFolder {
  protected:
    PlanGeojson() {
        GDALAllRegister();
        plan = Planner().plan(map.map, ground_and_air({256, 434}, {118, 55}));
        file.reset(GDALDataset::Open(
            put("plan.geojson", plan_geojson(plan, map, geotiff::lon_lat_of(map.georeference))).c_str(),
            GDAL_OF_VECTOR));
    }

    // The features of a role, their shapes in the map's own coordinate system.
    std::vector<OGRFeatureUniquePtr> features(const std::string& role) {
        const Transformation forth = to_system_of(map);
        std::vector<OGRFeatureUniquePtr> found;
        for (OGRFeatureUniquePtr& feature : *file->GetLayer(0)) {
            if (feature->GetFieldAsString("role") != role) continue;
            EXPECT_EQ(feature->GetGeometryRef()->transform(forth.get()), OGRERR_NONE);
            found.push_back(std::move(feature));
        }
        return found;
    }

    void expect_at(const OGRPoint& point, double x, double y) const {
        const auto& transform = map.georeference->transform;
        EXPECT_NEAR(point.getX(), transform[0] + (x + 0.5) * cell, 1e-3);
        EXPECT_NEAR(point.getY(), transform[3] - (y + 0.5) * cell, 1e-3);
    }

    MapFile map = mapfile::read_map_file(project_folder() / "data" / "berlin-mitte.tif");
    Plan plan;
    GDALDatasetUniquePtr file;
};

TEST_F(PlanGeojson, HasThePathsWhereTheCellsAre) {
    const auto paths = features("path");
    ASSERT_EQ(paths.size(), 2U);
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const OGRLineString& line = *paths[i]->GetGeometryRef()->toLineString();
        const Itinerary& agent = plan.agents[i];
        EXPECT_EQ(paths[i]->GetFieldAsString("agent"), agent.id);
        ASSERT_EQ(std::size_t(line.getNumPoints()), agent.path.size());
        double driven = 0;
        int times = 0;
        const double* time = paths[i]->GetFieldAsDoubleList("times", &times);
        ASSERT_EQ(std::size_t(times), agent.path.size());
        for (int k = 0; k < times; ++k) {
            OGRPoint point;
            line.getPoint(k, &point);
            const Waypoint& waypoint = agent.path[std::size_t(k)];
            expect_at(point, waypoint.x, waypoint.y);
            EXPECT_EQ(time[k], waypoint.t);
            if (k != 0) {
                const Waypoint& last = agent.path[std::size_t(k - 1)];
                driven += std::hypot(waypoint.x - last.x, waypoint.y - last.y) * cell;
            }
        }
        EXPECT_NEAR(line.get_Length(), driven, 0.1);
    }
}

TEST_F(PlanGeojson, HasBreachesAndRemovedObstacles) {
    const auto breaches = features("breach");
    const auto removed = features("removed");
    ASSERT_EQ(plan.breaches.size(), 3U);
    ASSERT_EQ(breaches.size(), 3U);
    ASSERT_EQ(removed.size(), 3U);
    EXPECT_EQ(map.annotations.name_of(plan.breaches[0].obstacle), "ARD-Hauptstadtstudio");
    for (std::size_t i = 0; i < removed.size(); ++i) {
        const Breach& breach = plan.breaches[i];
        expect_at(*breaches[i]->GetGeometryRef()->toPoint(), breach.at.x, breach.at.y);
        for (const auto* feature : {breaches[i].get(), removed[i].get()}) {
            EXPECT_EQ(feature->GetFieldAsInteger64("source_id"), breach.source_id);
            EXPECT_EQ(feature->GetFieldAsInteger("obstacle"), int(breach.obstacle.value));
            EXPECT_EQ(feature->GetFieldAsString("name"), map.annotations.name_of(breach.obstacle));
            EXPECT_EQ(feature->GetFieldAsDouble("cleared_at"), breach.cleared_at);
        }
        OGRGeometry* shape = removed[i]->GetGeometryRef();
        EXPECT_NEAR(OGR_G_Area(OGRGeometry::ToHandle(shape)), breach.cells * cell * cell, 0.1);
        // The air agent is at its boundary: a cell, diagonals included, away.
        EXPECT_LT(shape->Distance(breaches[i]->GetGeometryRef()), 0.75 * cell);
    }
}

// On the streets of OpenStreetMap itself: the outlines, not our cells. Between two cell centres a corner of a building
// may reach in by less than a cell.
TEST_F(PlanGeojson, LiesOnTheStreetsOfItsSource) {
    const auto shared = shared_folder();
    if (!shared) GTEST_SKIP() << no_shared_folder;
    const std::string source = "/vsigzip/" + (*shared / "data" / "osm" / "berlin-mitte.osm.gz").string();
    const CPLErrorHandlerPusher quiet(CPLQuietErrorHandler);
    const GDALDatasetUniquePtr osm(GDALDataset::Open(source.c_str(), GDAL_OF_VECTOR));
    ASSERT_TRUE(osm);
    const auto paths = features("path");
    const OGRGeometry& way = *paths[0]->GetGeometryRef();
    OGREnvelope box;
    way.getEnvelope(&box);

    OGRLayer* layer = osm->GetLayerByName("multipolygons");
    layer->SetAttributeFilter("building IS NOT NULL AND building <> 'no'");
    const Transformation forth = to_system_of(map);
    const std::vector<OGRFeatureUniquePtr> openings = features("removed");
    const auto is_opened = [&](const OGRGeometry& shape) {
        return std::ranges::any_of(openings,
                                   [&](const auto& one) { return one->GetGeometryRef()->Intersects(&shape); });
    };
    int beside = 0;
    int crossed = 0;
    for (const OGRFeatureUniquePtr& feature : *layer) {
        OGRGeometry* outline = feature->GetGeometryRef();
        if (outline->transform(forth.get()) != OGRERR_NONE) continue;
        OGREnvelope bounds;
        outline->getEnvelope(&bounds);
        if (!bounds.Intersects(box)) continue;
        const std::unique_ptr<OGRGeometry> shape(outline->MakeValid());
        const std::unique_ptr<OGRGeometry> inner(shape->Buffer(-cell));
        ++beside;
        for (const OGRPoint& point : *way.toLineString()) {
            if (shape->Contains(&point) && !is_opened(point)) ++crossed;
        }
        if (inner->Intersects(&way)) {
            const std::unique_ptr<OGRGeometry> core(shape->Intersection(&way));
            EXPECT_TRUE(is_opened(*core)) << "the way leads through " << feature->GetFieldAsString("osm_way_id");
        }
    }
    EXPECT_GT(beside, 100);
    EXPECT_EQ(crossed, 0);  // no turning point is inside a building that stands
}

TEST_F(PlanGeojson, NeedsToKnowWhereTheMapLies) {
    const MapFile nowhere{.map = map_from_ascii("..#.."), .source = "yard.map"};
    EXPECT_EQ(
        input_error([&] { plan_geojson({}, nowhere, {}); }).find("yard.map: GeoJSON needs longitude and latitude"), 0U);
}

TEST_F(PlanGeojson, HasALineAlsoForWhoStays) {
    MapFile here{.map = Map::from_labels(3, 1, {0, 0, 0}), .georeference = map.georeference};
    const Plan stay = Planner().plan(here.map, ground_and_air({1, 0}, {1, 0}));
    ASSERT_EQ(stay.status, PlanStatus::solved);
    const std::string path = put("stay.geojson", plan_geojson(stay, here, geotiff::lon_lat_of(here.georeference)));
    const GDALDatasetUniquePtr read(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->GetLayer(0)->GetFeatureCount(), 2);
}

}  // namespace
}  // namespace waybreaker::io
