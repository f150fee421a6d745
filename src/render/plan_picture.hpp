// The picture of a plan file on its map, and the plan in one sentence.
#pragma once

#include <optional>
#include <string>

#include "io/map_file.hpp"
#include "io/plan_file.hpp"
#include "render/picture.hpp"

namespace waybreaker::render {

// How a plan on this map is drawn. What its vehicles drive over is the first of the notes.
PictureOptions picture_options(const io::MapFile& map, const io::MissionDocument& asked, const Plan& plan);

// An SVG document. `reach`: of a plan of many places (mission/reach.hpp).
std::string plan_svg(const io::MapFile& map, const io::PlanFile& plan, std::optional<Reach> reach);

// Text of XML or HTML.
std::string plan_sentence(const io::MapFile& map, const io::PlanFile& plan);

}  // namespace waybreaker::render
