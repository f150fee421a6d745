#include "io/background_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;

Json points_json(const std::vector<Point>& part) {
    const auto rounded = [](double value) { return std::round(value * 100) / 100 + 0.0; };  // no -0
    Json points = Json::array();
    for (const Point& point : part) points.push_back({rounded(point.x), rounded(point.y)});
    return points;
}

Json feature_json(const site::Background::Feature& feature) {
    Json points = Json::array();
    for (const std::vector<Point>& part : feature.parts) points.push_back(points_json(part));
    return {{"kind", site::background_kinds[std::size_t(feature.kind)]},
            {"class", feature.type},
            {"name", feature.name},
            {"shape", site::background_shapes[std::size_t(feature.shape)]},
            {"points", std::move(points)}};
}

}  // namespace

std::string background_json(const site::Background& background) {
    Json features = Json::array();
    for (const site::Background::Feature& feature : background.features) features.push_back(feature_json(feature));
    return Json{{"features", std::move(features)}}.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace waybreaker::io
