// What `waybreaker import` says of what it wrote.
#pragma once

#include <string>
#include <vector>

#include "city/city_import.hpp"
#include "waybreaker/zone.hpp"

namespace waybreaker::apps {

// One line: size, buildings or features ("things"), obstacles, ground, and what helps a reader recognise the place.
std::string summary_line(const std::string& file, const city::ImportReport& report, const char* things);

// One line: how many zones there are, and of what.
std::string zones_line(const std::string& file, const std::vector<Zone>& zones);

}  // namespace waybreaker::apps
