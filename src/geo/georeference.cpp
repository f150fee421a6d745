#include <ogr_spatialref.h>

#include <memory>

#include "geo/gdal_scope.hpp"
#include "geo/label_tiff.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::geo {

std::string Georeference::crs_name() const {
    const GdalScope gdal;
    const OGRSpatialReference system(crs.c_str());
    const char* name = system.GetName();
    return name ? name : "";
}

std::array<double, 2> Georeference::lon_lat(double x, double y) const {
    const GdalScope gdal;
    OGRSpatialReference from(crs.c_str());
    from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    OGRSpatialReference wgs84;
    wgs84.SetWellKnownGeogCS("WGS84");
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> to_wgs84(OGRCreateCoordinateTransformation(&from, &wgs84));
    // Cell centres are integers, GDAL counts from the corner of the upper-left cell.
    const double column = x + 0.5;
    const double row = y + 0.5;
    double east = transform[0] + column * transform[1] + row * transform[2];
    double north = transform[3] + column * transform[4] + row * transform[5];
    if (!to_wgs84 || !to_wgs84->Transform(1, &east, &north)) {
        throw InputError("no longitude and latitude for cell " + std::to_string(x) + ", " + std::to_string(y) + ": " +
                         gdal.failure());
    }
    return {east, north};
}

}  // namespace waybreaker::geo
