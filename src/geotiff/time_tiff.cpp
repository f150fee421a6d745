#include "geotiff/time_tiff.hpp"

#include <gdal_frmts.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geotiff/gdal_scope.hpp"
#include "geotiff/raster_place.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::geotiff {
namespace {

constexpr float no_time = -1;

}  // namespace

std::string time_tiff_bytes(const TimeTiff& tiff) {
    GDALRegister_GTiff();
    GDALDriver& driver = *GetGDALDriverManager()->GetDriverByName("GTiff");
    const GdalScope gdal;
    const MemoryFile memory;
    CPLStringList options;
    options.SetNameValue("COMPRESS", "DEFLATE");
    options.SetNameValue("PREDICTOR", "3");  // of floating point numbers
    options.SetNameValue("INTERLEAVE", "BAND");
    const int count = int(tiff.bands.size());
    GDALDatasetUniquePtr file(
        driver.Create(memory.path().c_str(), tiff.width, tiff.height, count, GDT_Float32, options.List()));
    if (!file) throw InputError("cannot make a GeoTIFF: " + gdal.failure());
    write_place(*file, {tiff.cell_size, tiff.georeference, tiff.origin});
    file->SetMetadataItem("TIFFTAG_SOFTWARE", "waybreaker");
    CPLErr outcome = CE_None;
    for (int i = 0; i < count; ++i) {
        const TimeBand& band = tiff.bands[std::size_t(i)];
        std::vector<float> times(band.times.begin(), band.times.end());
        std::ranges::replace_if(
            times, [](float time) { return std::isinf(time); }, no_time);
        GDALRasterBand& raster = *file->GetRasterBand(i + 1);
        raster.SetDescription(band.name.c_str());
        raster.SetNoDataValue(no_time);
        outcome = std::max(outcome, raster.RasterIO(GF_Write, 0, 0, tiff.width, tiff.height, times.data(), tiff.width,
                                                    tiff.height, GDT_Float32, 0, 0, nullptr));
    }
    file.reset();
    if (outcome != CE_None || gdal.failed()) throw InputError("cannot make a GeoTIFF: " + gdal.failure());
    return memory.bytes();
}

}  // namespace waybreaker::geotiff
