// A plan as GPX, read back by GDAL: places and times must be those of the plan.
#include "exports/plan_gpx.hpp"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <cmath>

#include "ascii_map.hpp"
#include "exports/utc_time.hpp"
#include "geotiff/georeference.hpp"
#include "input_error.hpp"
#include "mapfile/map_reader.hpp"
#include "project_folder.hpp"
#include "temporary_folder.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::exports {
namespace {

constexpr std::int64_t start = 1777622400;  // 2026-05-01T08:00:00Z

// Seconds after the start, of a field that GDAL has read as a date.
double seconds(const OGRFeature& feature, const char* field) {
    int year = 0, month = 0, day = 0, hour = 0, minute = 0, zone = 0;
    float second = 0;
    EXPECT_TRUE(
        feature.GetFieldAsDateTime(feature.GetFieldIndex(field), &year, &month, &day, &hour, &minute, &second, &zone));
    EXPECT_EQ(zone, 100);  // UTC
    EXPECT_EQ(std::tuple(year, month, day), std::tuple(2026, 5, 1));
    return (hour - 8) * 3600 + minute * 60 + double(second);
}

class PlanGpx : public TemporaryFolder {
  protected:
    PlanGpx() {
        GDALAllRegister();
        plan = Planner().plan(map.map, ground_and_air({256, 434}, {118, 55}));
    }

    PlacedPlan placed() const {
        return {.plan = plan, .map = map, .to_lon_lat = geotiff::lon_lat_of(map.georeference), .starts_at = start};
    }

    GDALDatasetUniquePtr read(const std::string& text) {
        return GDALDatasetUniquePtr(GDALDataset::Open(put("plan.gpx", text).c_str(), GDAL_OF_VECTOR));
    }

    void expect_at(const OGRFeature& feature, Point cell) const {
        const auto [lon, lat] = geotiff::lon_lat_of(map.georeference)(cell);
        const OGRPoint& point = *feature.GetGeometryRef()->toPoint();
        EXPECT_NEAR(point.getX(), lon, 1e-9);
        EXPECT_NEAR(point.getY(), lat, 1e-9);
    }

    io::MapFile map = mapfile::read_map_file(project_folder() / "data" / "berlin-mitte.tif");
    Plan plan;
};

TEST_F(PlanGpx, HasATrackForEachAgent) {
    const auto file = read(plan_gpx(placed()));
    ASSERT_TRUE(file);
    OGRLayer* const tracks = file->GetLayerByName("tracks");
    ASSERT_EQ(tracks->GetFeatureCount(), 2);
    std::vector<std::string> names;
    for (const OGRFeatureUniquePtr& track : *tracks) names.emplace_back(track->GetFieldAsString("name"));
    EXPECT_EQ(names, (std::vector<std::string>{"ground", "air"}));
    std::array<std::size_t, 2> next{};
    for (const OGRFeatureUniquePtr& point : *file->GetLayerByName("track_points")) {
        const auto track = std::size_t(point->GetFieldAsInteger("track_fid"));
        const std::vector<Waypoint>& path = plan.agents[track].path;
        std::size_t& i = next[track];
        while (i != 0 && i < path.size() && path[i] == path[i - 1]) ++i;
        ASSERT_LT(i, path.size());
        expect_at(*point, {path[i].x, path[i].y});
        EXPECT_NEAR(seconds(*point, "time"), path[i].t, 0.002);
        ++i;
    }
    EXPECT_EQ(next[0], plan.agents[0].path.size());
    EXPECT_EQ(next[1], plan.agents[1].path.size());
}

TEST_F(PlanGpx, HasAWayPointForEachBreach) {
    const auto file = read(plan_gpx(placed()));
    ASSERT_TRUE(file);
    ASSERT_FALSE(plan.breaches.empty());
    std::size_t i = 0;
    for (const OGRFeatureUniquePtr& point : *file->GetLayerByName("waypoints")) {
        const Breach& breach = plan.breaches.at(i++);
        expect_at(*point, {double(breach.at.x), double(breach.at.y)});
        EXPECT_NEAR(seconds(*point, "time"), breach.cleared_at, 0.002);
        EXPECT_EQ(point->GetFieldAsString("type"), std::string("breach"));
    }
    EXPECT_EQ(i, plan.breaches.size());
}

TEST_F(PlanGpx, HoldsNamesOfAnyBytes) {
    map.annotations.title = "A < B & \"C\" \x01\xff";
    plan.agents[0].id = "<ground>";
    const auto file = read(plan_gpx(placed()));
    ASSERT_TRUE(file);
    EXPECT_EQ(file->GetLayerByName("tracks")->GetNextFeature()->GetFieldAsString("name"), std::string("<ground>"));
}

TEST_F(PlanGpx, NeedsToKnowWhereTheMapLies) {
    const io::MapFile nowhere{.map = map_from_ascii("..#.."), .source = "yard.map"};
    EXPECT_EQ(input_error([&] {
                  plan_gpx({.plan = plan, .map = nowhere});
              }).find("yard.map: GPX needs longitude and latitude"),
              0U);
}

}  // namespace
}  // namespace waybreaker::exports
