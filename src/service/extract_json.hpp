// What map data covers, as JSON: in the description of a source, and in what an import worker says.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "city/extract.hpp"

namespace waybreaker::service {

nlohmann::ordered_json extract_json(const city::Extract& extract);
// The same again. Throws nlohmann::json::exception if it is none.
city::Extract extract_of(const nlohmann::ordered_json& json);

}  // namespace waybreaker::service
