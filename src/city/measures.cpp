// [Map features/Units] of wiki.openstreetmap.org says which units tags have.
#include "city/measures.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

namespace waybreaker::city {
namespace {

struct Measured {
    double value;
    std::string_view unit;  // and what follows it
};

std::optional<Measured> measured(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    std::string_view unit = text.substr(std::size_t(end - text.data()));
    unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
    return Measured{value, unit};
}

template <std::size_t count>
std::optional<double> in_units(const Measured& said,
                               const std::array<std::pair<std::string_view, double>, count>& units) {
    const auto unit = std::find_if(units.begin(), units.end(), [&](const auto& one) { return one.first == said.unit; });
    return unit == units.end() ? std::nullopt : std::optional(said.value * unit->second);
}

}  // namespace

std::optional<double> metres_of(const std::string& text) {
    constexpr double foot = 0.3048;
    constexpr double inch = 0.0254;
    constexpr std::array<std::pair<std::string_view, double>, 5> units{
        {{"", 1}, {"m", 1}, {"cm", 0.01}, {"ft", foot}, {"'", foot}}};
    const std::optional<Measured> length = measured(text);
    if (!length) return std::nullopt;
    if (length->unit.size() > 1 && length->unit.front() == '\'') {  // feet and inches
        const std::optional<Measured> inches = measured(length->unit.substr(1));
        if (!inches || inches->unit != "\"") return std::nullopt;
        return length->value * foot + inches->value * inch;
    }
    return in_units(*length, units);
}

std::optional<double> tonnes_of(const std::string& text) {
    constexpr std::array<std::pair<std::string_view, double>, 5> units{
        {{"", 1}, {"t", 1}, {"kg", 0.001}, {"lbs", 0.00045359237}, {"st", 0.90718474}}};
    const std::optional<Measured> mass = measured(text);
    return mass ? in_units(*mass, units) : std::nullopt;
}

}  // namespace waybreaker::city
