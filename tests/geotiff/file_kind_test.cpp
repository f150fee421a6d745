// Who names the wrong file learns what it is.
#include "geotiff/file_kind.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace waybreaker::geotiff {
namespace {

using namespace std::string_view_literals;
using Reader = FileKind::Reader;

TEST(FileKinds, AreKnownByTheirFirstBytes) {
    struct Case {
        std::string_view head;
        const char* what;
        Reader reader;
    };
    const std::vector<Case> cases{
        {"", "empty", Reader::neither},
        {" \n<!DOCTYPE html><html><head><title>429</title>", "a web page (HTML)", Reader::neither},
        {"<!-- a --><HTML>", "a web page (HTML)", Reader::neither},
        {"\xEF\xBB\xBF<!doctype HTML PUBLIC \"-//W3C\">", "a web page (HTML)", Reader::neither},
        {"<?xml version=\"1.0\"?><Error><Code>NoSuchKey</Code>", "the error message of a server", Reader::neither},
        {"{\"error\": \"no such file\"}", "JSON, but no GeoJSON", Reader::perhaps_import},
        {R"({"version":0.6,"generator":"Overpass API","elements":[]})", "JSON of the Overpass API", Reader::neither},
        {R"({"format": "waybreaker-plan/1"})", "a plan file", Reader::neither},
        {R"({"format": "waybreaker-mission/1"})", "a mission file", Reader::neither},
        {"PK\x03\x04 etc", "a ZIP archive", Reader::perhaps_import},
        {"\x1f\x8b\x08", "packed with gzip", Reader::perhaps_import},
        {"PAR1\x15", "Parquet, which this GDAL does not read", Reader::perhaps_import},
        {"\xff\xe0\x04o5m2", "OpenStreetMap data (o5m)", Reader::import},
        {"BZh91", "packed with bzip2", Reader::neither},
        {"\xff\xfe<\0o\0"sv, "text in UTF-16", Reader::neither},
        {"<VRTDataset rasterXSize=\"2\">", "a virtual raster, which only names others", Reader::neither},
        {"<?xml version='1.0'?>\n<osm version='0.6'>", "OpenStreetMap data", Reader::import},
        {"\0\0\0\x0d\x0a\x09OSMHeader\x18"sv, "OpenStreetMap data (PBF)", Reader::import},
        {"\0\0\x27\x0a"sv, "a shapefile", Reader::import},
        {"SQLite format 3\0"sv, "GeoPackage or another database", Reader::import},
        {"{\n\"type\": \"FeatureCollection\", \"features\": []}", "GeoJSON", Reader::import},
        {"<kml xmlns='x'>", "KML", Reader::import},
        {"<gml:FeatureCollection>", "GML", Reader::import},
        {"II*\0"sv, "a TIFF", Reader::map},
        {"P5\n2 2 255\n", "a picture (netpbm)", Reader::map},
        {"type octile\n", "a MovingAI map", Reader::map},
    };
    for (const Case& one : cases) {
        const auto kind = file_kind(one.head);
        ASSERT_TRUE(kind) << one.what;
        EXPECT_EQ(kind->what, one.what) << one.head;
        EXPECT_EQ(int(kind->reader), int(one.reader)) << one.what;
        EXPECT_EQ(kind->remedy.empty(), one.reader == Reader::import || one.reader == Reader::map) << one.what;
    }
}

TEST(FileKinds, LeaveOtherFilesToTheirReaders) {
    for (const std::string_view head :
         {"image: m.pgm\n"sv, R"({"image": "m.pgm", "resolution": 0.05, "origin": [0, 0, 0]})"sv,
          "{image: 'm.pgm', resolution: 0.05}"sv, "hello\n"sv, "P7\n"sv, "<task>"sv, "\0\1\2"sv}) {
        EXPECT_FALSE(file_kind(head)) << head;
    }
}

}  // namespace
}  // namespace waybreaker::geotiff
