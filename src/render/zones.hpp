// Zones of a mission in its picture: outlines over a tint, those for aircraft dashed as their paths are.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "render/layout.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::render {

// What lies on the map; empty where there are none.
std::string draw_zones(const Mission& mission, const Layout& layout);

// The kinds that a mission has, as a legend calls them; and how it shows them, in a box of that place and size.
std::vector<std::pair<ZoneKind, std::string_view>> zone_words(const Mission& mission);
std::string zone_sample(ZoneKind kind, Rectangle box, double unit);

}  // namespace waybreaker::render
