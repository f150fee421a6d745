// A plan on a map of data/, at a time of a day, and what GDAL makes of the files that are written of it.
#pragma once

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <string>
#include <tuple>

#include "exports/placed_plan.hpp"
#include "geotiff/georeference.hpp"
#include "mapfile/map_reader.hpp"
#include "project_folder.hpp"
#include "temporary_folder.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::exports {

class PlacedTown : public TemporaryFolder {
  protected:
    PlacedTown() {
        GDALAllRegister();
        Mission mission = ground_and_air({256, 434}, {118, 55});
        mission.rules.breach_time.per_obstacle = 30;
        mission.agents.back().speed = 5;
        plan = Planner().plan(map.map, mission);
    }

    PlacedPlan placed() const {
        constexpr std::int64_t start = 1777622400;  // 2026-05-01T08:00:00Z
        return {.plan = plan, .map = map, .to_lon_lat = geotiff::lon_lat_of(map.georeference), .starts_at = start};
    }

    GDALDatasetUniquePtr read(const std::string& name, const std::string& text) {
        return GDALDatasetUniquePtr(GDALDataset::Open(put(name, text).c_str(), GDAL_OF_VECTOR));
    }

    void expect_at(const OGRPoint& point, Point cell) const {
        const auto [lon, lat] = geotiff::lon_lat_of(map.georeference)(cell);
        EXPECT_NEAR(point.getX(), lon, 1e-9);
        EXPECT_NEAR(point.getY(), lat, 1e-9);
    }

    // Seconds after the start, of a field that GDAL has read as a date.
    static double seconds(const OGRFeature& feature, const char* field) {
        int year = 0, month = 0, day = 0, hour = 0, minute = 0, zone = 0;
        float second = 0;
        EXPECT_TRUE(feature.GetFieldAsDateTime(feature.GetFieldIndex(field), &year, &month, &day, &hour, &minute,
                                               &second, &zone));
        EXPECT_EQ(zone, 100);  // UTC
        EXPECT_EQ(std::tuple(year, month, day), std::tuple(2026, 5, 1));
        return (hour - 8) * 3600 + minute * 60 + double(second);
    }

    io::MapFile map = mapfile::read_map_file(project_folder() / "data" / "berlin-mitte.tif");
    Plan plan;
};

}  // namespace waybreaker::exports
