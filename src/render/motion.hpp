// Motion: a picture that plays its plan over and over. Agents move along their timed paths, and obstacles stand until
// they are breached. It is made of CSS animations, and only for readers who have not asked for less motion: all others,
// and programs that draw no animations, see the still picture.
#pragma once

#include <string>

#include "render/layout.hpp"
#include "site/annotations.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::render {

// SVG elements; all empty if the plan has no agents that move.
struct Motion {
    std::string style;     // what moves when
    std::string standing;  // obstacles that are breached later, to be drawn over those that are removed
    std::string agents;    // and rings where they breach
};

Motion motion(const Map& map, const Mission& mission, const Plan& plan, const Layout& layout,
              const site::Annotations& known);

}  // namespace waybreaker::render
