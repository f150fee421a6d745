// What bars the way, and is seen, of areas that the edge of the data cuts.
#pragma once

#include <string>
#include <vector>

#include "city/cut_areas.hpp"
#include "city/features.hpp"
#include "city/ground.hpp"
#include "city/scenery.hpp"

namespace waybreaker::city {

// Adds what a feature in the system of the areas says of where water is, and where it is not.
void add_evidence(const Feature& feature, Evidence& evidence);

struct CutGround {
    std::vector<GroundPiece> pieces;  // where water may be, of unknown kind
    std::vector<Sight> scenery;
    std::vector<std::string> notes;  // of what lies in the window, a line each
};

// `data` is what the source says it has data of; empty if it does not say.
CutGround cut_ground(const std::vector<CutArea>& areas, const OGREnvelope& data, const Evidence& evidence,
                     const OGREnvelope& window, Profile profile);

}  // namespace waybreaker::city
