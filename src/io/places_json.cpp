#include "io/places_json.hpp"

#include "io/mission_json.hpp"
#include "io/zones_json.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::io {
namespace {

Place read_place(const JsonField& feature) {
    feature["type"].one_of<bool>({{"Feature", true}});
    Place place;
    if (const auto properties = feature.find("properties")) {
        if (const auto name = properties->find("name")) place.name = read_agent_id(*name);
        if (const auto weight = properties->find("weight")) {
            place.weight = weight->number();
            const bool is_weight = place.weight >= 0 && place.weight <= most_weight_of_agent;
            if (!is_weight) weight->fail("is no weight: a number from 0 to 1e9");
        }
    }
    const JsonField geometry = feature["geometry"];
    geometry["type"].one_of<bool>({{"Point", true}});
    place.at = read_position(geometry["coordinates"]);
    return place;
}

}  // namespace

PlaceCollection parse_places(std::string_view bytes, const std::string& name) {
    const auto document = parse_json(bytes, name, max_mission_depth);
    const JsonField collection(document);
    collection["type"].one_of<bool>({{"FeatureCollection", true}});
    PlaceCollection result;
    result.in_cells = is_in_cells(collection);
    for (const JsonField& feature : collection["features"].items()) result.places.push_back(read_place(feature));
    return result;
}

}  // namespace waybreaker::io
