#include "experiment/document.hpp"

#include "io/mission_json.hpp"

namespace waybreaker::experiment {

std::string document_of(const Mission& mission, const std::string& map) {
    nlohmann::ordered_json json = io::mission_json({.mission = mission, .map = map});
    json.erase("method");
    json.erase("limits");
    return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace waybreaker::experiment
