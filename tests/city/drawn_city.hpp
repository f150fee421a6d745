// A scene drawn in cells, as GeoJSON and OpenStreetMap XML, and what an import makes of it.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gdal_priv.h>
#include <gdal_utils.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "city/city_import.hpp"

namespace waybreaker::city {

inline constexpr int cells = 12;
inline const ImportOptions window{.longitude = 13.4, .latitude = 52.52, .size = 120, .cell = 10, .section = 0};

struct Corner {
    double column;  // in cells, from the window's upper-left corner
    double row;
};
using Ring = std::vector<Corner>;
using Polygon = std::vector<Ring>;  // outer ring, holes

inline Ring rectangle(double west, double north, double east, double south) {
    return {{west, north}, {east, north}, {east, south}, {west, south}};
}

struct Thing {
    char letter;                // in pictures; '-' is never seen there
    std::int64_t osm_id;        // relations are negative
    const char* tag;            // key=value
    std::vector<Polygon> area;  // more than one: a multipolygon
};

// Fractions keep every cell centre clear of every edge. All but the last four are buildings with a part in the window.
inline const std::vector<Thing>& scene() {
    static const std::vector<Thing> things{
        {'A', -500, "building=yes", {{rectangle(0.9, 0.9, 5.9, 5.9), rectangle(1.9, 1.9, 4.9, 4.9)}}},
        {'M', -510, "building=school", {{rectangle(7.1, 0.9, 8.9, 2.9)}, {rectangle(10.1, 0.9, 11.2, 1.9)}}},
        {'T', 11, "building=yes", {{rectangle(1.1, 7.1, 3.9, 9.1)}}},
        {'U', 12, "building=yes", {{rectangle(3.9, 7.1, 6.1, 8.1)}}},
        {'E', 13, "building=yes", {{rectangle(10.6, 6.1, 15, 8.1)}}},
        {'-', 15, "building=yes", {{rectangle(8.1, 10.6, 11.9, 11.4)}}},  // covers no cell centre
        {'V', 18, "building=yes", {{rectangle(2.1, 8.1, 4.9, 10.1)}}},    // partly under T
        {'-', 20, "building=no", {{rectangle(7.1, 8.1, 8.1, 9.1)}}},
        {'-', 21, "leisure=park", {{rectangle(7.1, 4.1, 9.1, 5.1)}}},
        {'-', 22, "building=yes", {{rectangle(20, 2, 22, 4)}}},
        {'-', 23, "building=yes", {{rectangle(-400, 2, -390, 400)}}},
    };
    return things;
}

inline constexpr std::size_t buildings_in_window = 7;
inline constexpr double area_in_window = 100 * (16 + 3.6 + 1.1 + 5.6 + 2.2 + 2.8 + 3.04 + 5.6);

inline const char* const drawing =
    "............\n"
    ".AAAAA.MM.M.\n"
    ".A...A.MM...\n"
    ".A...A......\n"
    ".A...A......\n"
    ".AAAAA......\n"
    "...........E\n"
    ".TTTUU.....E\n"
    ".TTTV.......\n"
    "..VVV.......\n"
    "............\n"
    "............\n";

// Longitude and latitude of a corner, by the way back: UTM zone 33N to WGS84.
class Site {
  public:
    Site() {
        OGRSpatialReference wgs84;
        OGRSpatialReference utm;
        wgs84.SetWellKnownGeogCS("WGS84");
        wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        utm.importFromEPSG(32633);
        to_wgs84_.reset(OGRCreateCoordinateTransformation(&utm, &wgs84));
        const std::unique_ptr<OGRCoordinateTransformation> to_utm(OGRCreateCoordinateTransformation(&wgs84, &utm));
        east_ = window.longitude;
        north_ = window.latitude;
        to_utm->Transform(1, &east_, &north_);
    }
    std::pair<double, double> lon_lat(Corner c) const {
        double x = east_ + (c.column - cells / 2.0) * window.cell;
        double y = north_ - (c.row - cells / 2.0) * window.cell;
        to_wgs84_->Transform(1, &x, &y);
        return {x, y};
    }

  private:
    double east_ = 0;
    double north_ = 0;
    std::unique_ptr<OGRCoordinateTransformation> to_wgs84_;
};

// A file in GDAL's memory, as one would have it on disk.
class Source {
  public:
    Source(const std::string& name, const std::string& text) : path_("/vsimem/city_import_test/" + name) {
        VSILFILE* file = VSIFOpenL(path_.c_str(), "wb");
        VSIFWriteL(text.data(), 1, text.size(), file);
        VSIFCloseL(file);
    }
    ~Source() { VSIRmdirRecursive("/vsimem/city_import_test"); }
    const std::string& path() const { return path_; }

  private:
    std::string path_;
};

inline std::string geojson(const std::vector<Thing>& things) {
    const Site site;
    std::string features;
    for (const Thing& thing : things) {
        std::string polygons;
        for (const Polygon& polygon : thing.area) {
            std::string rings;
            for (Ring ring : polygon) {
                ring.push_back(ring.front());
                std::string corners;
                for (const Corner& corner : ring) {
                    const auto [lon, lat] = site.lon_lat(corner);
                    corners += fmt::format("{}[{:.9f},{:.9f}]", corners.empty() ? "" : ",", lon, lat);
                }
                rings += fmt::format("{}[{}]", rings.empty() ? "" : ",", corners);
            }
            polygons += fmt::format("{}[{}]", polygons.empty() ? "" : ",", rings);
        }
        const std::string tag = thing.tag;
        const std::size_t equals = tag.find('=');
        features += fmt::format(R"({}{{"type":"Feature","properties":{{"osm_id":{},"{}":"{}"}},)"
                                R"("geometry":{{"type":"MultiPolygon","coordinates":[{}]}}}})",
                                features.empty() ? "" : ",", thing.osm_id, tag.substr(0, equals),
                                tag.substr(equals + 1), polygons);
    }
    return fmt::format(R"({{"type":"FeatureCollection","features":[{}]}})", features);
}

// Ways for single rings; multipolygon relations, with untagged ways as members, for the rest.
inline std::string osm_xml(const std::vector<Thing>& things) {
    const Site site;
    std::string nodes;
    std::string ways;
    std::string relations;
    int next_id = 1000;
    const auto way = [&](std::int64_t id, const Ring& ring, const std::string& tag) {
        const int first = next_id;
        std::string members;
        for (const Corner& corner : ring) {
            const auto [lon, lat] = site.lon_lat(corner);
            nodes += fmt::format("<node id=\"{}\" lat=\"{:.7f}\" lon=\"{:.7f}\"/>\n", next_id, lat, lon);
            members += fmt::format("<nd ref=\"{}\"/>", next_id++);
        }
        ways += fmt::format("<way id=\"{}\">{}<nd ref=\"{}\"/>{}</way>\n", id, members, first, tag);
    };
    for (const Thing& thing : things) {
        const std::string text = thing.tag;
        const std::size_t equals = text.find('=');
        const std::string tag =
            fmt::format("<tag k=\"{}\" v=\"{}\"/>", text.substr(0, equals), text.substr(equals + 1));
        if (thing.osm_id > 0) {
            way(thing.osm_id, thing.area.at(0).at(0), tag);
            continue;
        }
        std::string members;
        for (const Polygon& polygon : thing.area) {
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const int id = next_id++;
                way(id, polygon[i], "");
                members += fmt::format("<member type=\"way\" ref=\"{}\" role=\"{}\"/>", id, i == 0 ? "outer" : "inner");
            }
        }
        relations += fmt::format("<relation id=\"{}\">{}<tag k=\"type\" v=\"multipolygon\"/>{}</relation>\n",
                                 -thing.osm_id, members, tag);
    }
    const auto [west, south] = site.lon_lat({-500, 500});
    const auto [east, north] = site.lon_lat({500, -500});
    const std::string bounds =
        fmt::format("<bounds minlon=\"{}\" minlat=\"{}\" maxlon=\"{}\" maxlat=\"{}\"/>\n", west, south, east, north);
    return "<?xml version=\"1.0\"?>\n<osm version=\"0.6\">\n" + bounds + nodes + ways + relations + "</osm>\n";
}

inline std::string picture(const Map& map) {
    std::map<std::int64_t, char> letters;
    for (const Thing& thing : scene()) letters[thing.osm_id] = thing.letter;
    std::string text;
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            const ObstacleId id = map.obstacle_at({x, y});
            text += id ? letters.at(map.obstacle(id).source_id) : '.';
        }
        text += '\n';
    }
    return text;
}

inline void expect_scene(const ImportReport& report) {
    EXPECT_EQ(picture(report.tiff.map), drawing);
    EXPECT_EQ(report.tiff.map.obstacles().size(), 6U);
    EXPECT_EQ(report.buildings, buildings_in_window);
    EXPECT_NEAR(report.area, area_in_window, 2);  // corners are rounded to a centimetre in OpenStreetMap's own format
    EXPECT_EQ(report.tiff.annotations.attribution, "(c) OpenStreetMap contributors, ODbL 1.0");
    EXPECT_EQ(geotiff::crs_name(*report.tiff.georeference), "WGS 84 / UTM zone 33N");
    const auto [lon, lat] = geotiff::ToLonLat(*report.tiff.georeference)(cells / 2.0 - 0.5, cells / 2.0 - 0.5);
    EXPECT_NEAR(lon, window.longitude, 1e-8);
    EXPECT_NEAR(lat, window.latitude, 1e-8);
}

}  // namespace waybreaker::city
