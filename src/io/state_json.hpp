// The state of a mission under way, "waybreaker-state/1" (docs/live.md): what its agents report.
//
//     {"format": "waybreaker-state/1", "sequence": 1, "now": 42.5,
//      "agents": [{"id": "rover", "passed": 3, "at": [120.25, 88], "doing": "driving"}],
//      "failed": [{"obstacle": 473, "at": 40.0}]}
//
// Only "format", "sequence" and "now" must be there.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "io/json_field.hpp"
#include "waybreaker/state.hpp"

namespace waybreaker::io {

// Throw InputError: the file's name, where in it, what is wrong. Whether it can be of a plan is not asked. `name` is
// how the input is called in errors.
State parse_state(std::string_view bytes, const std::string& name);
State read_state(const JsonField& document);
State read_state_file(const std::string& path);

// Reads back as what was written.
nlohmann::ordered_json state_json(const State& state);

// A list of what was found, as states and revised plans have it.
std::vector<Found> read_found(const JsonField& list);
nlohmann::ordered_json found_json(std::span<const Found> found);

}  // namespace waybreaker::io
