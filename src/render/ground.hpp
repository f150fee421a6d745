// The background of a plan: water, green, streets and rails, faint, for orientation.
#pragma once

#include <string>

#include "render/layout.hpp"
#include "site/background.hpp"

namespace waybreaker::render {

// SVG elements, clipped to the map; nothing for an empty background. Of bends and lines below a pixel nothing is drawn.
std::string ground(const site::Background& background, const Layout& layout);

}  // namespace waybreaker::render
