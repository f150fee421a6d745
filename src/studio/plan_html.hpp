// A plan as a self-contained page: what `waybreaker plan --html` and `waybreaker export --html` write, and the service.
#pragma once

#include <span>
#include <string>

#include "io/map_file.hpp"

namespace waybreaker::studio {

// The text of a plan file, and the layer of the map that shows it: "plan", "before" (nothing removed) or "paper".
struct NamedPlan {
    std::string name;
    std::string json;
};

// `front`: a plan file that holds one, or nothing.
std::string plan_html(const io::MapFile& map, std::span<const NamedPlan> plans, const std::string& front = "");

}  // namespace waybreaker::studio
