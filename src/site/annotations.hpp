// Annotations: what people know a map by. Of these planning uses the profile, for the body that a mission does not say.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "site/background.hpp"
#include "site/cell_run.hpp"
#include "site/obstacle_kinds.hpp"
#include "site/obstacle_names.hpp"
#include "site/obstacle_tags.hpp"
#include "site/profile.hpp"
#include "site/sections.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::site {

struct Annotations {
    std::string title = {};               // place and window, for captions; any bytes, may be empty
    std::optional<Profile> profile = {};  // whom it was made for, if it says so
    std::string attribution = {};         // of the source data: "© OpenStreetMap contributors, ODbL 1.0"; any bytes
    std::vector<std::string> notes = {};  // of its ground, a line each: what the source lacks, what was guessed
    ObstacleNames names = {};             // what people call the obstacles
    ObstacleKinds kinds = {};             // what the obstacles are: buildings, water, ...
    ObstacleTags tags = {};               // what the source says of them: amenity=school, ...
    Sections sections = {};               // what they are parts of, where they are cut
    Background background = {};           // streets, water, ...
    std::vector<CellRun> bridges = {};    // open cells that a flood does not reach, row by row, like those below
    std::vector<CellRun> ways = {};       // open cells of ways that are for the profile; empty if nobody knows
    std::vector<CellRun> unknown = {};    // cells that are open though nobody knows what is there

    // Empty where it is unknown.
    std::string_view name_of(ObstacleId id) const {
        return id.value < names.size() ? names[id.value] : std::string_view();
    }
};

}  // namespace waybreaker::site
