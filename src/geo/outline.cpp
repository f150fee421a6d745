#include "geo/outline.hpp"

#include <fmt/format.h>
#include <gdal_alg.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <cstdint>
#include <functional>
#include <utility>

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

// Labels row by row, as a raster that GDAL reads where they are.
struct Labels {
    const std::uint32_t* data;
    int width;
    int height;
};

GDALDatasetUniquePtr raster_of(const Labels& labels) {
    GDALRegister_MEM();
    CPLStringList band;
    band.SetNameValue("DATAPOINTER", fmt::format("{}", fmt::ptr(labels.data)).c_str());
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
    GDALDatasetUniquePtr raster(driver->Create("", labels.width, labels.height, 0, GDT_UInt32, nullptr));
    raster->AddBand(GDT_UInt32, band.List());
    return raster;
}

// Gives each polygon of a label other than 0 to `take`.
void polygonize(const Labels& labels, const std::function<void(std::size_t label, Polygon polygon)>& take) {
    const GdalScope gdal;
    const GDALDatasetUniquePtr raster = raster_of(labels);
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
    for (const OGRFeatureUniquePtr& feature : *layer) {
        Polygon polygon;
        for (const OGRLinearRing* ring : *feature->GetGeometryRef()->toPolygon()) polygon.push_back(ring_of(*ring));
        take(std::size_t(feature->GetFieldAsInteger64(0)), std::move(polygon));
    }
}

}  // namespace

std::vector<std::vector<Polygon>> outlines(const Map& map) {
    std::vector<std::vector<Polygon>> result(map.obstacles().size() + 1);
    polygonize({map.labels().data(), map.width(), map.height()},
               [&](std::size_t label, Polygon polygon) { result[label].push_back(std::move(polygon)); });
    return result;
}

std::vector<Polygon> outline(const Map& map, ObstacleId id) {
    const Box& bounds = map.obstacle(id).bounds;
    const int width = bounds.max.x - bounds.min.x + 1;
    const int height = bounds.max.y - bounds.min.y + 1;
    std::vector<std::uint32_t> cells;
    cells.reserve(std::size_t(width) * std::size_t(height));
    for (Cell c = bounds.min; c.y <= bounds.max.y; ++c.y) {
        for (c.x = bounds.min.x; c.x <= bounds.max.x; ++c.x) cells.push_back(map.obstacle_at(c) == id ? 1 : 0);
    }
    std::vector<Polygon> result;
    polygonize({cells.data(), width, height}, [&](std::size_t /*label*/, Polygon polygon) {
        for (Ring& ring : polygon) {
            for (Point& point : ring) point = {point.x + bounds.min.x, point.y + bounds.min.y};
        }
        result.push_back(std::move(polygon));
    });
    return result;
}

}  // namespace waybreaker::geo
