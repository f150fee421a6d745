#include "city/label_raster.hpp"

#include <fmt/format.h>
#include <gdal_alg.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>

#include "geotiff/gdal_scope.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::city {

void paint(const std::vector<Paint>& paints, Cover cover, const CellWindow& window,
           std::vector<std::uint32_t>& labels) {
    const geotiff::GdalScope gdal;
    GDALRegister_MEM();
    CPLStringList band;
    band.SetNameValue("DATAPOINTER", fmt::format("{}", fmt::ptr(labels.data())).c_str());
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
    const GDALDatasetUniquePtr raster(driver->Create("", window.width, window.height, 0, GDT_UInt32, nullptr));
    raster->AddBand(GDT_UInt32, band.List());
    std::array<double, 6> transform = window.georeference.transform;
    raster->SetGeoTransform(transform.data());

    std::vector<OGRGeometryH> shapes;
    std::vector<double> numbers;
    for (const Paint& one : paints) {
        shapes.push_back(OGRGeometry::ToHandle(const_cast<OGRGeometry*>(one.shape)));
        numbers.push_back(double(one.label));
    }
    CPLStringList options;
    if (cover == Cover::touched) options.SetNameValue("ALL_TOUCHED", "TRUE");
    const int only_band = 1;
    const CPLErr outcome =
        GDALRasterizeGeometries(GDALDataset::ToHandle(raster.get()), 1, &only_band, int(shapes.size()), shapes.data(),
                                nullptr, nullptr, numbers.data(), options.List(), nullptr, nullptr);
    if (outcome != CE_None) throw InputError("the map cannot be rasterised: " + gdal.failure());
}

}  // namespace waybreaker::city
