#include "geo/georeference.hpp"

#include <ogr_spatialref.h>

#include "geo/gdal_scope.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::geo {

std::string Georeference::crs_name() const {
    const GdalScope gdal;
    const OGRSpatialReference system(crs.c_str());
    const char* name = system.GetName();
    return name ? name : "";
}

std::array<double, 2> Georeference::lon_lat(double x, double y) const {
    return ToLonLat(*this)(x, y);
}

ToLonLat::ToLonLat(const Georeference& place) : transform_(place.transform) {
    const GdalScope gdal;
    OGRSpatialReference from(place.crs.c_str());
    from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    OGRSpatialReference wgs84;
    wgs84.SetWellKnownGeogCS("WGS84");
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    to_wgs84_.reset(OGRCreateCoordinateTransformation(&from, &wgs84));
    if (!to_wgs84_) throw InputError("the map's coordinate system has no longitudes and latitudes: " + gdal.failure());
}

ToLonLat::~ToLonLat() = default;

std::array<double, 2> ToLonLat::operator()(double x, double y) const {
    const GdalScope gdal;
    // Cell centres are integers, GDAL counts from the corner of the upper-left cell.
    const double column = x + 0.5;
    const double row = y + 0.5;
    double east = transform_[0] + column * transform_[1] + row * transform_[2];
    double north = transform_[3] + column * transform_[4] + row * transform_[5];
    if (!to_wgs84_->Transform(1, &east, &north)) {
        throw InputError("no longitude and latitude for cell " + std::to_string(x) + ", " + std::to_string(y) + ": " +
                         gdal.failure());
    }
    return {east, north};
}

}  // namespace waybreaker::geo
