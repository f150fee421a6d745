// Whether a JSON value is what a schema of openapi.json says: the words of JSON Schema that it uses, and no others.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace waybreaker::server {

// Where and why not, a line each.
std::vector<std::string> schema_faults(const nlohmann::json& api, const nlohmann::json& schema,
                                       const nlohmann::json& value, const std::string& place = "$");

// The object that a "$ref" stands for, or the value itself.
const nlohmann::json& resolved(const nlohmann::json& api, const nlohmann::json& value);

}  // namespace waybreaker::server
