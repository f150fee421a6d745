#include "site/demolition.hpp"

#include <fmt/format.h>

namespace waybreaker::site {

Demolition demolition(const Map& map, const Sections& sections, std::span<const ObstacleId> removed) {
    Demolition result{.removals = removed.size(), .structures = structures_of(sections, removed)};
    for (const ObstacleId id : removed) result.cells += map.obstacle(id).cells;
    return result;
}

std::string removals_text(const Demolition& demolition) {
    const std::size_t count = demolition.removals;
    const char* plural = count == 1 ? "" : "s";
    if (count == 0) return "no obstacle removed";
    return demolition.structures.empty() ? fmt::format("{} obstacle{} removed", count, plural)
                                         : fmt::format("{} opening{}", count, plural);
}

std::string removals_text(const Demolition& demolition, const Sections& sections) {
    if (demolition.structures.empty()) return removals_text(demolition);
    return removals_text(demolition) + " in " + structures_text(sections, demolition.structures);
}

std::string area_text(double square_metres) {
    constexpr double exact = 100;  // from here on whole square metres will do
    return square_metres < exact ? fmt::format("{:.3g} m\u00b2", square_metres)
                                 : fmt::format("{:.0f} m\u00b2", square_metres);
}

}  // namespace waybreaker::site
