#include "service/extract_json.hpp"

#include <nlohmann/json.hpp>

namespace waybreaker::service {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

nlohmann::ordered_json extract_json(const city::Extract& extract) {
    Json places = Json::array();
    for (const city::NamedPlace& place : extract.places) places.push_back({{"name", place.name}, {"at", place.at}});
    return {{"bounds", extract.bounds},   {"buildings", extract.buildings},
            {"columns", extract.columns}, {"rows", extract.rows},
            {"built", extract.built},     {"densest", {{"center", extract.densest}, {"size", extract.side}}},
            {"places", std::move(places)}};
}

city::Extract extract_of(const nlohmann::ordered_json& json) {
    city::Extract extract{.bounds = json.at("bounds"),
                          .buildings = json.at("buildings"),
                          .columns = json.at("columns"),
                          .rows = json.at("rows"),
                          .built = json.at("built"),
                          .densest = json.at("densest").at("center"),
                          .side = json.at("densest").at("size")};
    for (const auto& place : json.at("places")) extract.places.push_back({place.at("name"), place.at("at")});
    return extract;
}

}  // namespace waybreaker::service
