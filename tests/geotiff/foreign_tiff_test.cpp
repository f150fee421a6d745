// Rasters of other programs: masks, places on the ground, and what is refused in one helpful line.
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>

#include "geotiff/label_tiff.hpp"
#include "geotiff/written_tiff.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::geotiff {
namespace {

TEST(LabelTiff, takes_cells_without_data_for_free) {
    const std::string bytes = foreign_tiff(GDT_Int16, 1, [](GDALDataset& file) {
        std::vector<std::int32_t> cells(32, -9999);
        cells[9] = 5;
        write_cells(file, cells);
        file.GetRasterBand(1)->SetNoDataValue(-9999);
    });
    const Map map = read_label_tiff(bytes, "foreign.tif").map;
    ASSERT_EQ(map.obstacles().size(), 1U);
    EXPECT_EQ(map.obstacle_at({1, 1}), ObstacleId{1});
    EXPECT_EQ(map.obstacles()[0].cells, 1U);
}

void set_transform(GDALDataset& file, std::array<double, 6> transform) {
    file.SetGeoTransform(transform.data());
}

void fill_mask(GDALRasterBand& mask, const std::vector<std::uint8_t>& counts) {
    ASSERT_EQ(counts.size(), 32U);
    std::vector<std::uint8_t> values = counts;
    ASSERT_EQ(mask.RasterIO(GF_Write, 0, 0, 8, 4, values.data(), 8, 4, GDT_Byte, 0, 0, nullptr), CE_None);
}

// Two obstacles, of which a mask leaves out the second and half of the first.
TEST(LabelTiff, takes_cells_that_are_masked_out_for_free) {
    std::vector<std::int32_t> cells(32, 0);
    std::vector<std::uint8_t> counts(32, 255);
    cells[8] = cells[9] = 5;
    cells[15] = 6;
    counts[9] = counts[15] = 0;
    const auto expect_one = [](const std::string& bytes) {
        const Map map = read_label_tiff(bytes, "foreign.tif").map;
        ASSERT_EQ(map.obstacles().size(), 1U);
        EXPECT_EQ(map.obstacles()[0].cells, 1U);
        EXPECT_EQ(map.obstacle_at({0, 1}), ObstacleId{1});
    };
    CPLSetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", "YES");
    const std::string masked = foreign_tiff(GDT_Byte, 1, [&](GDALDataset& file) {
        write_cells(file, cells);
        ASSERT_EQ(file.CreateMaskBand(GMF_PER_DATASET), CE_None);
        fill_mask(*file.GetRasterBand(1)->GetMaskBand(), counts);
    });
    CPLSetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", nullptr);
    expect_one(masked);
    expect_one(foreign_tiff(
        GDT_UInt16, 2,
        [&](GDALDataset& file) {
            write_cells(file, cells);
            file.GetRasterBand(2)->SetColorInterpretation(GCI_AlphaBand);
            fill_mask(*file.GetRasterBand(2), counts);
        },
        8, 4, "ALPHA=YES"));
}

TEST(LabelTiff, measures_cells_in_metres_whatever_the_unit) {
    const std::string bytes = foreign_tiff(GDT_Byte, 1, [](GDALDataset& file) {
        OGRSpatialReference feet;
        feet.importFromEPSG(2263);  // New York Long Island, US survey feet
        file.SetSpatialRef(&feet);
        std::array<double, 6> transform{980000, 10, 0, 210000, 0, -10};
        file.SetGeoTransform(transform.data());
    });
    EXPECT_NEAR(read_label_tiff(bytes, "feet.tif").cell_size, 3.048006, 1e-6);
}

// An empty map of 8 x 4 cells in a coordinate system.
std::string placed_tiff(int epsg, std::array<double, 6> transform) {
    return foreign_tiff(GDT_Byte, 1, [&](GDALDataset& file) {
        OGRSpatialReference system;
        ASSERT_EQ(system.importFromEPSG(epsg), OGRERR_NONE);
        file.SetSpatialRef(&system);
        set_transform(file, transform);
    });
}

std::string refusal_of(const std::string& bytes) {
    try {
        read_label_tiff(bytes, "bad.tif");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(LabelTiff, refuses_coordinate_systems_that_stretch_lengths) {
    // At 50 degrees north Web Mercator makes 1.56 m of a metre.
    const std::string mercator = refusal_of(placed_tiff(3857, {1113000, 2, 0, 6446275, 0, -2}));
    EXPECT_NE(mercator.find("has cells of 2 m in WGS 84 / Pseudo-Mercator, which are 1.29 x 1.28 m on the ground"),
              std::string::npos)
        << mercator;
    EXPECT_NE(mercator.find("'gdalwarp -r near -t_srs EPSG:32632'"), std::string::npos) << mercator;
    // An equal-area cylinder keeps areas, but not squares.
    const std::string oblong = refusal_of(placed_tiff(6933, {0, 2, 0, 6000000, 0, -2}));
    EXPECT_NE(oblong.find("on the ground; project it with"), std::string::npos) << oblong;
    EXPECT_NE(refusal_of(placed_tiff(3857, {0, 2, 0, -6446275, 0, -2})).find("EPSG:32731"), std::string::npos);
    // At the equator it is true, and so are zones, countries' grids, and polar ones near their parallel.
    EXPECT_EQ(refusal_of(placed_tiff(3857, {1113000, 2, 0, 4, 0, -2})), "");
    EXPECT_EQ(refusal_of(placed_tiff(32633, {290000, 2, 0, 5500000, 0, -2})), "");
    EXPECT_EQ(refusal_of(placed_tiff(2154, {700000, 2, 0, 6600000, 0, -2})), "");
    EXPECT_EQ(refusal_of(placed_tiff(3035, {4321000, 2, 0, 3210000, 0, -2})), "");
    EXPECT_EQ(refusal_of(placed_tiff(3031, {0, 2, 0, 2082000, 0, -2})), "");
}

TEST(LabelTiff, names_the_zone_of_cells_in_degrees) {
    EXPECT_NE(refusal_of(placed_tiff(4326, {13, 1e-5, 0, 52, 0, -1e-5})).find("EPSG:32633"), std::string::npos);
    EXPECT_NE(refusal_of(placed_tiff(4326, {190, 1e-5, 0, -20, 0, -1e-5})).find("EPSG:32702"), std::string::npos);
    EXPECT_NE(refusal_of(placed_tiff(4326, {10, 1e-5, 0, 86, 0, -1e-5})).find("EPSG:32661"), std::string::npos);
}

// A site's own axes have no longitudes: the map is in a frame of its own, as those of robots are.
TEST(LabelTiff, takes_a_local_system_for_a_frame) {
    const LabelTiff tiff = read_label_tiff(foreign_tiff(GDT_Byte, 1,
                                                        [](GDALDataset& file) {
                                                            OGRSpatialReference site;
                                                            site.SetLocalCS("Site grid");
                                                            site.SetLinearUnits("foot", 0.3048);
                                                            file.SetSpatialRef(&site);
                                                            set_transform(file, {100, 10, 0, 240, 0, -10});
                                                        }),
                                           "site.tif");
    EXPECT_FALSE(tiff.georeference);
    EXPECT_NEAR(tiff.cell_size, 3.048, 1e-9);
    ASSERT_TRUE(tiff.origin);
    EXPECT_NEAR(tiff.origin->at(0), 30.48, 1e-9);
    EXPECT_NEAR(tiff.origin->at(1), 60.96, 1e-9);
}

TEST(LabelTiff, refuses_what_is_no_label_map_and_says_why) {
    const std::string good = label_tiff_bytes(small_map());
    struct Case {
        const char* what;
        std::string bytes;
        const char* message;
    };
    const std::vector<Case> cases{
        {"empty", "", "is no GeoTIFF map"},
        {"text", "type octile\nheight 4\n", "is no GeoTIFF map"},
        {"magic and junk", std::string("II*\0\x08\0\0\0", 8) + std::string(500, '\xff'), "is no GeoTIFF map"},
        {"header cut short", good.substr(0, 10), "is no GeoTIFF map"},
        {"two bands", foreign_tiff(GDT_Byte, 2), "has 2 bands"},
        {"floats", foreign_tiff(GDT_Float32, 1),
         "'gdal_calc.py -A IN.tif --outfile=OUT.tif --type=Byte --calc=\"A>0\"', or with \"~(A<=0)\" if what is no"},
        {"64 bits", foreign_tiff(GDT_Int64, 1), "-ot UInt32"},
        {"too wide", foreign_tiff(GDT_Byte, 1, {}, 40000, 2, "SPARSE_OK=YES"), "-srcwin"},
        {"too many cells", foreign_tiff(GDT_Byte, 1, {}, 20000, 20000, "SPARSE_OK=YES"), "-srcwin"},
        {"more cells than it has bytes for",
         foreign_tiff(GDT_Byte, 1, {}, 16384, 16384, "SPARSE_OK=YES").substr(0, 12000), "cannot hold"},
        {"rotated",
         foreign_tiff(GDT_Byte, 1,
                      [](GDALDataset& f) {
                          set_transform(f, {0, 2, 1, 0, 1, -2});
                      }),
         "not north-up"},
        {"south-up",
         foreign_tiff(GDT_Byte, 1,
                      [](GDALDataset& f) {
                          set_transform(f, {0, 2, 0, 0, 0, 2});
                      }),
         "not north-up"},
        {"oblong cells",
         foreign_tiff(GDT_Byte, 1,
                      [](GDALDataset& f) {
                          set_transform(f, {0, 2, 0, 0, 0, -2.1});
                      }),
         "must be square"},
        {"degrees",
         foreign_tiff(GDT_Byte, 1,
                      [](GDALDataset& f) {
                          OGRSpatialReference wgs84;
                          wgs84.SetWellKnownGeogCS("WGS84");
                          f.SetSpatialRef(&wgs84);
                          set_transform(f, {13, 1e-5, 0, 52, 0, -1e-5});
                      }),
         "in degrees"},
        {"negative id",
         foreign_tiff(GDT_Int32, 1,
                      [](GDALDataset& f) {
                          std::vector<std::int32_t> labels(32, 0);
                          labels[13] = -3;
                          write_cells(f, labels);
                      }),
         "negative obstacle id -3 at cell 5,1"},
        {"-1 for blocked",
         foreign_tiff(GDT_Int16, 1, [](GDALDataset& f) { write_cells(f, std::vector<std::int32_t>(32, -1)); }),
         R"(--calc="A!=0"')"},
        {"damaged ids",
         foreign_tiff(GDT_Byte, 1, [](GDALDataset& f) { f.SetMetadataItem("WAYBREAKER_OBSTACLES", "12,!34,x5"); }),
         "entry 3 of its metadata item"},
        {"a weight of nothing",
         foreign_tiff(GDT_Byte, 1, [](GDALDataset& f) { f.SetMetadataItem("WAYBREAKER_WEIGHTS", "1.5,0"); }),
         "entry 2 of its metadata item WAYBREAKER_WEIGHTS is no number above 0"},
        {"a breach before its time",
         foreign_tiff(GDT_Byte, 1, [](GDALDataset& f) { f.SetMetadataItem("WAYBREAKER_BREACH_TIMES", "-1"); }),
         "entry 1 of its metadata item WAYBREAKER_BREACH_TIMES is no number of at least 0"},
        {"a weight without end",
         foreign_tiff(GDT_Byte, 1, [](GDALDataset& f) { f.SetMetadataItem("WAYBREAKER_WEIGHTS", "inf"); }),
         "entry 1 of its metadata item WAYBREAKER_WEIGHTS"},
        {"ids end in a comma",
         foreign_tiff(GDT_Byte, 1, [](GDALDataset& f) { f.SetMetadataItem("WAYBREAKER_OBSTACLES", "12,"); }),
         "entry 1 of its metadata item"},
        {"a name of nobody",
         foreign_tiff(GDT_Byte, 1, [](GDALDataset& f) { f.SetMetadataItem("WAYBREAKER_NAMES", "3 Town hall\nCafé"); }),
         "line 2 of its metadata item WAYBREAKER_NAMES is no obstacle's number and name"},
        {"a name of free cells",
         foreign_tiff(GDT_Byte, 1, [](GDALDataset& f) { f.SetMetadataItem("WAYBREAKER_NAMES", "0 Town"); }),
         "line 1 of its metadata item WAYBREAKER_NAMES"},
        {"a kind of no number",
         foreign_tiff(GDT_Byte, 1,
                      [](GDALDataset& f) { f.SetMetadataItem("WAYBREAKER_KINDS", "water 1\nbarrier 2x"); }),
         "line 2 of its metadata item WAYBREAKER_KINDS is no kind and the numbers of its obstacles"},
        {"a background that is none",
         foreign_tiff(GDT_Byte, 1,
                      [](GDALDataset& f) {
                          OGRSpatialReference utm;
                          utm.importFromEPSG(32633);
                          f.SetSpatialRef(&utm);
                          set_transform(f, {390000, 2, 0, 5820000, 0, -2});
                          f.SetMetadataItem("WAYBREAKER_BACKGROUND", "{}");
                      }),
         "does not begin with WKT;kind;class;name"},
    };
    for (const Case& bad : cases) {
        SCOPED_TRACE(bad.what);
        try {
            read_label_tiff(bad.bytes, "bad.tif");
            ADD_FAILURE() << "was read";
        } catch (const InputError& error) {
            const std::string message = error.what();
            EXPECT_EQ(message.find("bad.tif: "), 0U) << message;
            EXPECT_NE(message.find(bad.message), std::string::npos) << message;
            EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        }
    }
}

TEST(LabelTiff, survives_being_cut_anywhere) {
    const std::string good = label_tiff_bytes(small_map());
    for (std::size_t length = 0; length < good.size(); ++length) {
        try {
            // What GDAL stores last may be missing without harm; whatever is read is the map itself.
            expect_same_obstacles(read_label_tiff(good.substr(0, length), "cut.tif").map, small_map().map);
        } catch (const InputError&) {
        }
    }
}

RC_GTEST_PROP(LabelTiff, survives_any_change_of_a_byte, ()) {
    std::string bytes = label_tiff_bytes(small_map());
    const auto changes = *rc::gen::inRange(1, 4);
    for (int i = 0; i < changes; ++i) {
        bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] = *rc::gen::arbitrary<char>();
    }
    try {
        read_label_tiff(bytes, "changed.tif");
    } catch (const InputError&) {
    }
}

}  // namespace
}  // namespace waybreaker::geotiff
