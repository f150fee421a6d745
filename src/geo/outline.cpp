#include "geo/outline.hpp"

#include <fmt/format.h>
#include <gdal_alg.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "geo/gdal_scope.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::geo {
namespace {

Ring ring_of(const OGRLinearRing& points) {
    Ring ring;
    // GDAL's corners are whole numbers.
    for (const OGRPoint& point : points) ring.emplace_back(point.getX() - 0.5, point.getY() - 0.5);
    return ring;
}

// The labels as a raster that GDAL reads where they are.
GDALDatasetUniquePtr raster_of(const Map& map) {
    GDALRegister_MEM();
    CPLStringList band;
    band.SetNameValue("DATAPOINTER", fmt::format("{}", fmt::ptr(map.labels().data())).c_str());
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
    GDALDatasetUniquePtr raster(driver->Create("", map.width(), map.height(), 0, GDT_UInt32, nullptr));
    raster->AddBand(GDT_UInt32, band.List());
    return raster;
}

}  // namespace

std::vector<std::vector<Polygon>> outlines(const Map& map) {
    const GdalScope gdal;
    const GDALDatasetUniquePtr raster = raster_of(map);
    RegisterOGRMEM();
    GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("Memory");
    const GDALDatasetUniquePtr vectors(memory->Create("", 0, 0, 0, GDT_Unknown, nullptr));
    OGRLayer* layer = vectors->CreateLayer("outlines", nullptr, wkbPolygon);
    OGRFieldDefn field("obstacle", OFTInteger64);
    layer->CreateField(&field);
    GDALRasterBandH band = GDALRasterBand::ToHandle(raster->GetRasterBand(1));
    if (GDALPolygonize(band, band, OGRLayer::ToHandle(layer), 0, nullptr, nullptr, nullptr) != CE_None) {
        throw InputError("the obstacles have no outlines: " + gdal.failure());
    }
    std::vector<std::vector<Polygon>> result(map.obstacles().size() + 1);
    for (const OGRFeatureUniquePtr& feature : *layer) {
        Polygon& polygon = result[std::size_t(feature->GetFieldAsInteger64(0))].emplace_back();
        for (const OGRLinearRing* ring : *feature->GetGeometryRef()->toPolygon()) polygon.push_back(ring_of(*ring));
    }
    return result;
}

}  // namespace waybreaker::geo
