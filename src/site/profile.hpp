// Who drives on a map, and the body that it has there.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace waybreaker::site {

// `paper`: nobody in particular; buildings are all there is, as in the paper.
enum class Profile : std::uint8_t { rover, truck, walker, paper };

std::string_view profile_word(Profile profile);

// Empty if no profile is called that.
std::optional<Profile> profile_called(std::string_view word);

// Metres; 0 for `paper`. A rover is a robot on wheels that pavements are made for; a truck is as wide as the law lets
// one be (Directive 96/53/EC); a walker has legs.
double vehicle_width(Profile profile);

// The radius of the vehicle's disc in cells of that many metres: half its width, rounded up to a thousandth of a cell,
// and at least half a cell, which is the radius where nobody knows who drives.
double body_radius(std::optional<Profile> profile, double cell);

}  // namespace waybreaker::site
