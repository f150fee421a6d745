#include "geotiff/background_item.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "geotiff/feature_parts.hpp"
#include "geotiff/gdal_scope.hpp"
#include "labels/obstacle_names.hpp"
#include "labels/take_until.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::geotiff {
namespace {

using Shape = site::Background::Shape;
using Part = std::vector<Point>;

constexpr std::string_view heading = "WKT;kind;class;name";

// Six decimals are a decimetre; zeros at the end say nothing.
void append_number(double value, std::string& text) {
    text += fmt::format("{:.6f}", value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
}

void append_part(const Part& part, bool closed, const ToLonLat& to_lon_lat, std::string& text) {
    text += '(';
    for (std::size_t i = 0; i < part.size() + (closed ? 1 : 0); ++i) {
        const Point& point = part[i % part.size()];
        const auto [longitude, latitude] = to_lon_lat(point.x, point.y);
        if (i > 0) text += ',';
        append_number(longitude, text);
        text += ' ';
        append_number(latitude, text);
    }
    text += ')';
}

std::string wkt(const site::Background::Feature& feature, const ToLonLat& to_lon_lat) {
    const bool area = feature.shape == Shape::area;
    std::string text = area ? "MULTIPOLYGON(" : feature.shape == Shape::line ? "MULTILINESTRING(" : "MULTIPOINT(";
    for (std::size_t i = 0; i < feature.parts.size(); ++i) {
        const Part& part = feature.parts[i];
        const bool outer = signed_area(part) < 0;  // in cells y goes down
        const bool new_polygon = area && (i == 0 || outer);
        if (i > 0) text += new_polygon ? ")," : ",";
        if (new_polygon) text += '(';
        append_part(part, area, to_lon_lat, text);
    }
    return text + (area ? "))" : ")");
}

// As a field of the table.
std::string field(std::string_view text) {
    std::string result = labels::clean_name(text);
    std::replace(result.begin(), result.end(), '"', '\'');
    std::replace(result.begin(), result.end(), ';', ',');
    return result;
}

// Whether a part has anything to show on a map of that size; nowhere, if a point of it has no place there.
bool meets(const Part& part, int width, int height) {
    Point least = part.front();
    Point most = part.front();
    for (const Point& point : part) {
        if (!std::isfinite(point.x) || !std::isfinite(point.y)) return false;
        least = {std::min(least.x, point.x), std::min(least.y, point.y)};
        most = {std::max(most.x, point.x), std::max(most.y, point.y)};
    }
    return most.x >= -1 && most.y >= -1 && least.x <= width && least.y <= height;
}

// Parts in longitude and latitude.
std::optional<FeatureParts> parse_wkt(std::string_view text) {
    const GdalScope gdal;
    const std::string copy(text);
    OGRGeometry* shape = nullptr;
    const OGRErr outcome = OGRGeometryFactory::createFromWkt(copy.c_str(), nullptr, &shape);
    const std::unique_ptr<OGRGeometry> owned(shape);
    return outcome == OGRERR_NONE && owned ? parts_of(*owned) : std::nullopt;
}

std::optional<site::Background::Feature> parse_feature(std::string_view line) {
    std::optional<FeatureParts> shape = parse_wkt(labels::take_until(';', line));
    const std::string_view kind_name = labels::take_until(';', line);
    const auto kind = std::find(site::background_kinds.begin(), site::background_kinds.end(), kind_name) -
                      site::background_kinds.begin();
    if (!shape || std::size_t(kind) == site::background_kinds.size()) return std::nullopt;
    const std::string type = labels::clean_name(labels::take_until(';', line));
    return site::Background::Feature{.kind = site::Background::Kind(kind),
                                     .type = type,
                                     .name = labels::clean_name(line),
                                     .shape = shape->shape,
                                     .parts = std::move(shape->parts)};
}

}  // namespace

std::string background_text(const site::Background& background, const site::Georeference& place) {
    if (background.features.empty()) return "";
    const ToLonLat to_lon_lat(place);
    std::string text(heading);
    for (const site::Background::Feature& feature : background.features) {
        if (feature.parts.empty()) continue;
        const std::string_view kind = site::background_kinds[std::size_t(feature.kind)];
        text += fmt::format("\n{};{};{};{}", wkt(feature, to_lon_lat), kind, field(feature.type), field(feature.name));
    }
    return text;
}

site::Background parse_background(std::string_view text, const site::Georeference& place, int width, int height,
                                  const std::string& name) {
    const auto refusal = [&](const std::string& what) {
        return InputError(fmt::format("{}: {}; drop it with 'gdal_edit.py -mo {}=' or import the map anew", name, what,
                                      background_item));
    };
    if (text.size() > max_background_bytes) {
        throw refusal(
            fmt::format("its metadata item {} has more than {} bytes", background_item, max_background_bytes));
    }
    if (labels::take_until('\n', text) != heading) {
        throw refusal(fmt::format("its metadata item {} does not begin with {}", background_item, heading));
    }
    const FromLonLat to_cells(place);
    site::Background background;
    for (std::size_t line = 2; !text.empty(); ++line) {
        std::optional<site::Background::Feature> feature = parse_feature(labels::take_until('\n', text));
        if (!feature)
            throw refusal(fmt::format("line {} of its metadata item {} is no feature", line, background_item));
        for (Part& part : feature->parts) part = to_cells(std::move(part));
        std::erase_if(feature->parts, [&](const Part& part) { return !meets(part, width, height); });
        if (!feature->parts.empty()) background.features.push_back(std::move(*feature));
    }
    return background;
}

}  // namespace waybreaker::geotiff
