// Lengths and masses as OpenStreetMap writes them.
#pragma once

#include <optional>
#include <string>

namespace waybreaker::city {

// Metres: "2.5", "2.5 m", "8 ft", 8'2". Empty if the text begins with no number, or has another unit.
std::optional<double> metres_of(const std::string& text);

// Tonnes: "7.5", "7.5 t", "3500 kg", "8000 lbs", "5 st" (short tons). Empty if the text begins with no number, or has
// another unit.
std::optional<double> tonnes_of(const std::string& text);

}  // namespace waybreaker::city
