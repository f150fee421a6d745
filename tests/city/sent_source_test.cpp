// Sources that strangers send: read like files, and nothing else is.
#include "city/sent_source.hpp"

#include <gtest/gtest.h>

#include "city/city_import.hpp"
#include "city/extract.hpp"
#include "city/osm_drawing.hpp"
#include "input_error.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::city {
namespace {

const ImportOptions window{.longitude = 9, .latitude = 50, .size = 200, .cell = 2};

std::shared_ptr<const std::string> shared(std::string bytes) {
    return std::make_shared<const std::string>(std::move(bytes));
}

std::string yard() {
    OsmDrawing drawing(window);
    drawing.area("building=yes|name=Barn", {{20, 20}, {60, 20}, {60, 70}, {20, 70}});
    drawing.way("barrier=wall", {{5, 80}, {90, 85}});
    drawing.way("highway=residential|name=Lane", {{0, 10}, {99, 12}});
    return drawing.xml();
}

class SentSourceTest : public TemporaryFolder {};

TEST_F(SentSourceTest, IsImportedAsAFileIs) {
    put("yard.osm", yard());
    const SentSource sent("yard.osm", shared(yard()));
    EXPECT_EQ(geotiff::label_tiff_bytes(import_city(sent.path(), window).tiff),
              geotiff::label_tiff_bytes(import_city(path("yard.osm"), window).tiff));
    EXPECT_EQ(read_extract(sent.path()).densest, read_extract(path("yard.osm")).densest);
}

TEST_F(SentSourceTest, SeveralOfOneNameAreApart) {
    const SentSource broken("yard.osm", shared("<osm version='0.6'><node"));
    const SentSource whole("yard.osm", shared(yard()));
    EXPECT_EQ(read_extract(whole.path()).buildings, 1U);
    EXPECT_NE(input_error([&] { read_extract(broken.path()); }), "");
}

TEST_F(SentSourceTest, IsCalledByItsName) {
    const SentSource sent("yard.osm", shared("nothing"));
    try {
        read_extract(sent.path());
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(sent.named(error.what()).find("yard.osm: cannot be read as map data"), 0U) << error.what();
    }
}

TEST_F(SentSourceTest, IsGoneWithItsObject) {
    std::string path;
    {
        const SentSource sent("yard.osm", shared(yard()));
        path = sent.path();
    }
    EXPECT_NE(input_error([&] { read_extract(path); }).find("no such file"), std::string::npos);
}

// GDAL knows formats that say where their data lies: none of them is read.
TEST_F(SentSourceTest, OpensNoOtherFile) {
    put("secret.geojson", R"({"type": "FeatureCollection", "features": []})");
    const std::string elsewhere = path("secret.geojson");
    const std::vector<std::string> all{"<OGRVRTDataSource><OGRVRTLayer name=\"secret\"><SrcDataSource>" + elsewhere +
                                           "</SrcDataSource></OGRVRTLayer></OGRVRTDataSource>",
                                       elsewhere, "<OGRWFSDataSource><URL>http://localhost:9/</URL></OGRWFSDataSource>",
                                       "SQLite format 3", "PG:dbname=secret"};
    for (const std::string& bytes : all) {
        const SentSource sent("sent", shared(bytes));
        EXPECT_NE(input_error([&] { read_extract(sent.path()); }).find("cannot be read as map data"),
                  std::string::npos);
    }
}

}  // namespace
}  // namespace waybreaker::city
