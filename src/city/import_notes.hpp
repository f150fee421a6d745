// What an import noticed of its source, for whoever uses the map: a line each.
#pragma once

#include <string>
#include <vector>

#include "city/footprints.hpp"
#include "city/survey.hpp"

namespace waybreaker::city {

std::vector<std::string> import_notes(const Footprints& footprints, const Survey& survey);

// That ground without data is free, if that is more than a trace; else empty.
std::string note_of_gaps(double covered);

}  // namespace waybreaker::city
