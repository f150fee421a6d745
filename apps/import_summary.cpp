#include "import_summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "background_summary.hpp"
#include "city/ground_rules.hpp"
#include "io/map_info.hpp"
#include "site/obstacle_kinds.hpp"
#include "site/unknown_ground.hpp"

namespace waybreaker::apps {
namespace {

// How many things have one: sections have those of their structures.
std::size_t name_count(const geotiff::LabelTiff& tiff) {
    const site::Sections& sections = tiff.annotations.sections;
    if (sections.empty()) return site::name_count(tiff.annotations.names);
    std::size_t count = 0;
    for (const std::uint32_t one : site::cut_structures(sections)) {
        if (!sections.structures[one].name.empty()) ++count;
    }
    for (std::size_t id = 1; id < tiff.annotations.names.size(); ++id) {
        if (sections.parts[id].empty() && !tiff.annotations.names[id].empty()) ++count;
    }
    return count;
}

// What helps a reader recognise the place: "; 120 names, 85 streets, 2 waters"; empty if the source has none.
std::string kept(const geotiff::LabelTiff& tiff) {
    std::vector<std::string> counts = background_summary(tiff.annotations.background);
    const std::size_t names = name_count(tiff);
    if (names > 0) counts.insert(counts.begin(), fmt::format("{} {}", names, names == 1 ? "name" : "names"));
    return counts.empty() ? "" : fmt::format("; {}", fmt::join(counts, ", "));
}

// What a profile adds: ", 3.1 % water, 0.8 % forbidden; 4 protected (hospitals, ...; ...)".
std::string ground_of(const city::ImportReport& report) {
    if (report.profile == city::Profile::paper) return "";
    const Map& map = report.tiff.map;
    const auto cells = site::cells_by_kind(map, report.tiff.annotations.kinds);
    const auto share = [&map](std::uint64_t count, std::string_view what) {
        return fmt::format(", {:.1f} % {}", 100 * double(count) / double(map.grid().cell_count()), what);
    };
    std::string text;
    constexpr std::array<std::pair<site::ObstacleKind, const char*>, 4> grounds{
        {{site::ObstacleKind::water, "water"},
         {site::ObstacleKind::cliff, "cliff"},
         {site::ObstacleKind::forbidden, "forbidden"},
         {site::ObstacleKind::off_road, "off road"}}};
    for (const auto& [kind, word] : grounds) {
        const std::uint64_t count = cells[std::size_t(kind)];
        if (count == 0) continue;
        text += share(count, word);
    }
    if (const std::uint64_t count = site::unknown_cells(map, report.tiff.annotations.tags); count > 0) {
        text += share(count, "unknown");
    }
    if (report.sheltered == 0) return text;
    return text + fmt::format("; {} protected ({}; --destructible and --protected choose others)", report.sheltered,
                              city::protection(report.profile).text);
}

}  // namespace

std::string summary_line(const std::string& file, const city::ImportReport& report, const char* things) {
    const Map& map = report.tiff.map;
    return fmt::format(
        "{}: {} x {} cells of {:.6g} m, {} {}{}, {} obstacles, {:.1f} % blocked{}{}\n", file, map.width(), map.height(),
        report.tiff.cell_size, report.buildings, things,
        report.tiff.annotations.sections.empty() ? "" : ", " + site::sections_summary(report.tiff.annotations.sections),
        map.obstacles().size(), 100 * io::summarise(map).density, ground_of(report), kept(report.tiff));
}

std::string zones_line(const std::string& file, const std::vector<Zone>& zones) {
    std::vector<std::string> names;
    for (const Zone& zone : zones) {
        if (std::ranges::find(names, zone.name) == names.end()) names.push_back(zone.name);
    }
    return fmt::format("{}: {} no-fly {}{}{}\n", file, zones.size(), zones.size() == 1 ? "zone" : "zones",
                       names.empty() ? "" : ": ", fmt::join(names, ", "));
}

}  // namespace waybreaker::apps
