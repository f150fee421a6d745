#include "geotiff/time_tiff.hpp"

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

#include "geotiff/gdal_scope.hpp"
#include "written_tiff.hpp"

namespace waybreaker::geotiff {
namespace {

constexpr float never = std::numeric_limits<float>::infinity();

std::vector<float> read_band(GDALDataset& file, int number) {
    std::vector<float> times(std::size_t(file.GetRasterXSize()) * std::size_t(file.GetRasterYSize()));
    EXPECT_EQ(
        file.GetRasterBand(number)->RasterIO(GF_Read, 0, 0, file.GetRasterXSize(), file.GetRasterYSize(), times.data(),
                                             file.GetRasterXSize(), file.GetRasterYSize(), GDT_Float32, 0, 0, nullptr),
        CE_None);
    return times;
}

TEST(TimeTiff, IsReadByGisProgramsAsWritten) {
    const std::vector<float> before{0, 1.5F, never, 3, 4, never};
    const std::vector<float> after{0, 1.5F, 2, 2.5F, 4, never};
    const site::Georeference place = *small_map().georeference;
    const std::string bytes = time_tiff_bytes({.width = 3,
                                               .height = 2,
                                               .cell_size = 2.4,
                                               .georeference = place,
                                               .bands = {{"before", before}, {"after", after}}});
    const GdalScope gdal;
    const MemoryFile memory(bytes);
    const GDALDatasetUniquePtr file(GDALDataset::Open(memory.path().c_str(), GDAL_OF_RASTER));
    ASSERT_NE(file, nullptr);
    ASSERT_EQ(file->GetRasterCount(), 2);
    EXPECT_STREQ(file->GetRasterBand(1)->GetDescription(), "before");
    EXPECT_STREQ(file->GetRasterBand(2)->GetDescription(), "after");
    EXPECT_EQ(file->GetRasterBand(2)->GetNoDataValue(), -1);
    EXPECT_EQ(read_band(*file, 1), (std::vector<float>{0, 1.5F, -1, 3, 4, -1}));
    EXPECT_EQ(read_band(*file, 2), (std::vector<float>{0, 1.5F, 2, 2.5F, 4, -1}));
    std::array<double, 6> transform{};
    EXPECT_EQ(file->GetGeoTransform(transform.data()), CE_None);
    EXPECT_EQ(transform, place.transform);
    EXPECT_STREQ(file->GetSpatialRef()->GetName(), "WGS 84 / UTM zone 33N");
}

TEST(TimeTiff, LiesAtTheOriginOfARobotsMap) {
    const std::vector<float> times{1, 2};
    const std::string bytes = time_tiff_bytes(
        {.width = 1, .height = 2, .cell_size = 0.5, .origin = std::array{-10.0, 3.0}, .bands = {{"before", times}}});
    const GdalScope gdal;
    const MemoryFile memory(bytes);
    const GDALDatasetUniquePtr file(GDALDataset::Open(memory.path().c_str(), GDAL_OF_RASTER));
    ASSERT_NE(file, nullptr);
    std::array<double, 6> transform{};
    EXPECT_EQ(file->GetGeoTransform(transform.data()), CE_None);
    EXPECT_EQ(transform, (std::array<double, 6>{-10, 0.5, 0, 4, 0, -0.5}));
}

}  // namespace
}  // namespace waybreaker::geotiff
