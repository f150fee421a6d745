#include "city/import_notes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>

#include "labels/obstacle_names.hpp"

namespace waybreaker::city {
namespace {

// By their names, or else by their numbers.
std::string names_of(const std::vector<CutArea>& areas) {
    constexpr std::size_t most = 8;
    std::vector<std::string> names;
    for (const CutArea& area : areas) {
        const std::string* const said = area.tags.find("name");
        std::string name = labels::clean_name(said ? *said : "");
        if (name.empty()) name = fmt::format("relation {}", -area.source_id);
        if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
    }
    const bool more = names.size() > most;
    names.resize(std::min(names.size(), most));
    return fmt::format("{}{}", fmt::join(names, ", "), more ? ", ..." : "");
}

// What the source lacks of what it begins to say.
void note_what_is_cut(const Footprints& footprints, const Survey& survey, std::vector<std::string>& notes) {
    const std::vector<CutArea>& cut = footprints.cut;
    if (!cut.empty()) {
        notes.push_back(fmt::format("{}: left out, for the source has no more than a part of {} outline{}",
                                    names_of(cut), cut.size() == 1 ? "its" : "their", cut.size() == 1 ? "" : "s"));
    }
    const auto count_of = [&](std::vector<std::int64_t> osm::Defects::*kind) {
        std::set<std::int64_t> ids((survey.defects.*kind).begin(), (survey.defects.*kind).end());
        ids.insert((footprints.defects.*kind).begin(), (footprints.defects.*kind).end());
        return ids.size();
    };
    if (const std::size_t ways = count_of(&osm::Defects::lacking_nodes); ways > 0) {
        notes.push_back(fmt::format("{} nodes that the source does not have: drawn without them",
                                    ways == 1 ? "1 way lacks" : fmt::format("{} ways lack", ways)));
    }
    if (const std::size_t areas = count_of(&osm::Defects::crossing); areas > 0) {
        notes.push_back(
            fmt::format("outlines of {} cross themselves or each other: what lies within an odd number of "
                        "them is taken for inside",
                        areas == 1 ? "1 relation" : fmt::format("{} relations", areas)));
    }
}

// Extracts for route planners have streets, but hardly a building.
void note_what_is_filtered(const Footprints& footprints, const Survey& survey, std::vector<std::string>& notes) {
    constexpr std::size_t few = 10;  // times more streets than buildings, and of streets
    const std::size_t streets = survey.streets;
    const auto buildings =
        std::size_t(std::ranges::count(footprints.list, site::ObstacleKind::building, &Footprint::kind));
    if (!footprints.from_osm || streets < few || streets < few * buildings) return;
    notes.push_back(fmt::format("{} beside {} streets: was the extract filtered?",
                                buildings == 1 ? "1 building" : fmt::format("{} buildings", buildings), streets));
}

}  // namespace

std::vector<std::string> import_notes(const Footprints& footprints, const Survey& survey) {
    std::vector<std::string> notes = survey.ground.notes;
    note_what_is_cut(footprints, survey, notes);
    note_what_is_filtered(footprints, survey, notes);
    if (const std::size_t count = footprints.shapeless; count > 0) {
        notes.push_back(fmt::format("{} left out: {} no coordinates, or such as are no numbers",
                                    count == 1 ? "1 feature is" : fmt::format("{} features are", count),
                                    count == 1 ? "it has" : "they have"));
    }
    return notes;
}

std::string note_of_gaps(double covered) {
    constexpr double nearly_all = 0.995;
    if (covered >= nearly_all) return "";
    return fmt::format("the source covers only {:.2g} % of the window; the rest is free on the map", 100 * covered);
}

}  // namespace waybreaker::city
