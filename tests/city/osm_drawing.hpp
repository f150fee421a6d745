// Map data for tests, drawn in the cells of a window.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "city/city_import.hpp"
#include "city/import_window.hpp"

namespace waybreaker::city {

inline constexpr int town_side = 14;
// 14 x 14 cells of 2 m.
inline const ImportOptions town_window{
    .longitude = 13.4, .latitude = 52.52, .size = 2 * town_side, .cell = 2, .section = 0};

inline std::vector<Point> box(double west, double north, double east, double south) {
    return {{west, north}, {east, north}, {east, south}, {west, south}};
}

// OpenStreetMap's XML, drawn in the cells of the window.
class OsmDrawing {
  public:
    // Unless it is said to end, the data goes on beyond the window.
    explicit OsmDrawing(const ImportOptions& window) : place_(import_window(window).georeference) {
        const double side = import_window(window).width;
        ends(-side, -side, 2 * side, 2 * side);
    }

    // West, north, east, south; sides of cells, not their middles as elsewhere.
    OsmDrawing& ends(double west, double north, double east, double south) {
        const geotiff::ToLonLat to_lon_lat(place_);
        const auto [left, bottom] = to_lon_lat(west - 0.5, south - 0.5);
        const auto [right, top] = to_lon_lat(east - 0.5, north - 0.5);
        bounds_ = fmt::format("<bounds minlon='{:.7f}' minlat='{:.7f}' maxlon='{:.7f}' maxlat='{:.7f}'/>\n", left,
                              bottom, right, top);
        return *this;
    }
    OsmDrawing& without_bounds() {
        bounds_.clear();
        return *this;
    }

    // Shared points of ways are one node each.
    OsmDrawing& way(const std::string& tags, const std::vector<Point>& points) {
        std::string refs;
        for (const Point& point : points) refs += fmt::format("<nd ref='{}'/>", node(point));
        ways_ += fmt::format("<way id='{}' version='1'>{}{}</way>\n", ++ids_, refs, tags_xml(tags));
        return *this;
    }
    // The id of what was drawn last.
    std::int64_t last() const { return ids_; }
    // A multipolygon of ways by their ids, whether they are there or not.
    OsmDrawing& relation(const std::string& tags, const std::vector<std::int64_t>& ways) {
        std::string members;
        for (const std::int64_t id : ways) members += fmt::format("<member type='way' ref='{}' role='outer'/>", id);
        relations_ += fmt::format("<relation id='{}' version='1'>{}{}</relation>\n", ++ids_, members,
                                  tags_xml("type=multipolygon|" + tags));
        return *this;
    }
    OsmDrawing& area(const std::string& tags, std::vector<Point> ring) {
        ring.push_back(ring.front());
        return way(tags, ring);
    }
    // `shared`: ways that have the place as a point have this node there.
    OsmDrawing& point(const std::string& tags, const Point& point, bool shared = false) {
        const auto [longitude, latitude] = geotiff::ToLonLat(place_)(point.x, point.y);
        nodes_ += fmt::format("<node id='{}' version='1' lon='{:.7f}' lat='{:.7f}'>{}</node>\n", ++ids_, longitude,
                              latitude, tags_xml(tags));
        if (shared) known_[{point.x, point.y}] = ids_;
        return *this;
    }

    std::string xml() const { return "<osm version='0.6'>\n" + bounds_ + nodes_ + ways_ + relations_ + "</osm>\n"; }

  private:
    std::int64_t node(const Point& at) {
        const auto known = known_.try_emplace({at.x, at.y}, ids_ + 1);
        if (known.second) point("", at);
        return known.first->second;
    }
    // "key=value|key=value"
    static std::string tags_xml(const std::string& tags) {
        std::string xml;
        for (std::size_t begin = 0; begin < tags.size();) {
            const std::size_t equals = tags.find('=', begin);
            const std::size_t end = std::min(tags.find('|', begin), tags.size());
            std::string value = tags.substr(equals + 1, end - equals - 1);
            if (const std::size_t quote = value.find('\''); quote != std::string::npos)
                value.replace(quote, 1, "&apos;");
            xml += fmt::format("<tag k='{}' v='{}'/>", tags.substr(begin, equals - begin), value);
            begin = end + 1;
        }
        return xml;
    }

    site::Georeference place_;
    std::int64_t ids_ = 0;
    std::map<std::pair<double, double>, std::int64_t> known_;
    std::string bounds_;
    std::string nodes_;
    std::string ways_;
    std::string relations_;
};

}  // namespace waybreaker::city
