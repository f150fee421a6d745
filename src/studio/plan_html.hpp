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

// The same plan as a page that plans by itself: whoever drags the start or changes the mission sees it planned anew.
// `planner`: studio.wasm, by gzip (http/gzip.hpp).
std::string steerable_html(const io::MapFile& map, Connectivity connectivity, const std::string& plan,
                           std::string planner);

}  // namespace waybreaker::studio
