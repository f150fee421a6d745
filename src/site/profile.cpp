#include "site/profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace waybreaker::site {
namespace {

constexpr std::array<std::string_view, 4> profile_words{"rover", "truck", "walker", "paper"};
constexpr std::array<double, 4> widths{0.8, 2.55, 0.6, 0};

}  // namespace

std::string_view profile_word(Profile profile) {
    return profile_words[std::size_t(profile)];
}

std::optional<Profile> profile_called(std::string_view word) {
    const auto* const found = std::find(profile_words.begin(), profile_words.end(), word);
    return found == profile_words.end() ? std::nullopt : std::optional(Profile(found - profile_words.begin()));
}

double vehicle_width(Profile profile) {
    return widths[std::size_t(profile)];
}

double body_radius(std::optional<Profile> profile, double cell) {
    constexpr double least = 0.5;
    constexpr double thousandths = 1000;
    if (!profile) return least;
    const double cells = vehicle_width(*profile) / 2 / cell;
    return std::max(least, std::ceil(cells * thousandths * (1 - 1e-12)) / thousandths);
}

}  // namespace waybreaker::site
