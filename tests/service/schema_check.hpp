// Whether a JSON value is what a schema says.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace waybreaker::service {

// Where and why not, a line each. `document`: what the schema stands in, for the references to its components.
std::vector<std::string> schema_faults(const nlohmann::json& document, const nlohmann::json& schema,
                                       const nlohmann::json& value);

// The object that a "$ref" stands for, or the value itself.
const nlohmann::json& resolved(const nlohmann::json& document, const nlohmann::json& value);

}  // namespace waybreaker::service
