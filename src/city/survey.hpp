// Survey: what a vector source knows of a window beside its buildings, by OpenStreetMap's tags.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "city/features.hpp"
#include "city/ground.hpp"
#include "city/premises.hpp"
#include "city/scenery.hpp"
#include "city/vector_source.hpp"

namespace waybreaker::city {

struct SurveyOptions {
    bool scenery = true;
    Profile profile = Profile::rover;  // of the ground
    double cell = 1;                   // least width of a strip of ground, in metres
    ObstacleChoice choice = {};        // which barriers can be destroyed
    OGREnvelope data = {};             // what the source has data of, in the window's system; empty: of everything
};

struct Survey {
    std::vector<Sight> scenery;  // in the source's order; nothing in tunnels
    Ground ground;
    std::vector<Premises> premises;  // by premises_filters(), in the source's order
    osm::Defects defects = {};
    std::size_t streets = 0;  // ways for anybody, in the window
};

// One scan of the source; none if nothing in it can have such tags. Throws InputError if the source cannot be read.
Survey read_survey(const std::string& source, const Window& window, const SurveyOptions& options);

}  // namespace waybreaker::city
