// Label maps and rasters that tests write, and GDAL's own tools on them.
#pragma once

#include <gdal_priv.h>
#include <gdal_utils.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "geotiff/label_tiff.hpp"

namespace waybreaker::geotiff {

inline const char* const memory_path = "/vsimem/label_tiff_test.tif";

inline std::string take_memory_file() {
    vsi_l_offset size = 0;
    const GByte* data = VSIGetMemFileBuffer(memory_path, &size, FALSE);
    std::string bytes(reinterpret_cast<const char*>(data), size);
    VSIUnlink(memory_path);
    return bytes;
}

// What another program might have written: an 8 x 4 raster of `type`, changed by `edit` before it is closed.
inline std::string foreign_tiff(GDALDataType type, int bands, const std::function<void(GDALDataset&)>& edit = {},
                                int width = 8, int height = 4, const char* option = nullptr) {
    GDALAllRegister();
    CPLStringList options;
    if (option) options.AddString(option);
    GDALDatasetUniquePtr file(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(memory_path, width, height,
                                                                                       bands, type, options.List()));
    if (edit) edit(*file);
    file.reset();
    return take_memory_file();
}

inline void write_cells(GDALDataset& file, std::vector<std::int32_t> cells) {
    ASSERT_EQ(cells.size(), 32U);
    ASSERT_EQ(file.GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 8, 4, cells.data(), 8, 4, GDT_Int32, 0, 0, nullptr),
              CE_None);
}

// The same file after `gdal_translate OPTIONS`.
inline std::string translated(const std::string& bytes, const std::vector<const char*>& arguments) {
    GDALAllRegister();
    const char* const in_path = "/vsimem/label_tiff_test_in.tif";
    std::string copy = bytes;
    VSIFCloseL(VSIFileFromMemBuffer(in_path, reinterpret_cast<GByte*>(copy.data()), copy.size(), FALSE));
    CPLStringList list;
    for (const char* argument : arguments) list.AddString(argument);
    GDALTranslateOptions* options = GDALTranslateOptionsNew(list.List(), nullptr);
    GDALDatasetUniquePtr in(GDALDataset::Open(in_path));
    GDALClose(GDALTranslate(memory_path, GDALDataset::ToHandle(in.get()), options, nullptr));
    GDALTranslateOptionsFree(options);
    in.reset();
    VSIUnlink(in_path);
    return take_memory_file();
}

using Kind = site::ObstacleKind;

// 5 x 3 cells, three obstacles in two touching pieces and one apart, in UTM zone 33N.
inline LabelTiff small_map() {
    const std::vector<ObstacleAttributes> attributes{{}, {true, 4711}, {false, -12345678901}, {true, 0}};
    OGRSpatialReference utm;
    utm.SetWellKnownGeogCS("WGS84");
    utm.SetUTM(33, TRUE);
    char* text = nullptr;
    utm.exportToWkt(&text);
    LabelTiff tiff{
        .map = Map::from_labels(5, 3,
                                {1, 1, 2, 0, 0,  //
                                 0, 2, 2, 0, 3,  //
                                 0, 0, 0, 0, 3},
                                attributes),
        .cell_size = 2.4,
        .georeference = site::Georeference{text, {390000.25, 2.4, 0, 5820000.75, 0, -2.4}},
        .annotations = {.title = "Place, 12 m around Zürich",
                        .attribution = "(c) somebody, some licence 1.0",
                        .names = {"", "Grand \"Hôtel\" & <Café>", "", "7"},
                        .kinds = {Kind::unknown, Kind::building, Kind::water, Kind::barrier},
                        .sections = {{{Kind::building, 4711, "7"}, {Kind::barrier, -12, ""}}, {{}, {0}, {}, {1}}}}};
    CPLFree(text);
    return tiff;
}

inline void expect_same_obstacles(const Map& a, const Map& b) {
    ASSERT_EQ(a.width(), b.width());
    ASSERT_EQ(a.height(), b.height());
    EXPECT_TRUE(std::equal(a.labels().begin(), a.labels().end(), b.labels().begin(), b.labels().end()));
    ASSERT_EQ(a.obstacles().size(), b.obstacles().size());
    for (std::size_t i = 0; i < a.obstacles().size(); ++i) {
        EXPECT_EQ(a.obstacles()[i].source_id, b.obstacles()[i].source_id);
        EXPECT_EQ(a.obstacles()[i].destructible, b.obstacles()[i].destructible);
        EXPECT_EQ(a.obstacles()[i].bounds, b.obstacles()[i].bounds);
    }
}

}  // namespace waybreaker::geotiff
