#include "render/zones.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "render/palette.hpp"

namespace waybreaker::render {
namespace {

std::string zone_sign(ZoneKind kind, const std::string& path, double unit) {
    const bool dashed = kind == ZoneKind::no_fly;
    const std::string dashes = dashed ? fmt::format(" stroke-dasharray=\"{:.4g} {:.4g}\"", 7 * unit, 4 * unit) : "";
    const std::string_view colour = dashed ? colour::no_fly : colour::keep_out;
    return fmt::format(
        "<path d=\"{0}\" fill=\"{1}\" fill-opacity=\"0.16\" fill-rule=\"evenodd\" stroke=\"{1}\" "
        "stroke-width=\"{2:.4g}\"{3}/>\n",
        path, colour, 1.8 * unit, dashes);
}

}  // namespace

std::string draw_zones(const Mission& mission, const Layout& layout) {
    std::string signs;
    for (const Zone& zone : mission.rules.zones) {
        std::string path;
        for (const auto& ring : zone.polygon) {
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point at = layout.at(ring[i].x, ring[i].y);
                path += fmt::format("{}{:.2f} {:.2f}", i == 0 ? 'M' : 'L', at.x, at.y);
            }
            path += 'z';
        }
        signs += zone_sign(zone.kind, path, layout.unit);
    }
    if (signs.empty()) return "";
    // A picture within the picture shows what lies on the map, and no more.
    const Rectangle& map = layout.map;
    return fmt::format(
        "<svg x=\"{0:.6g}\" y=\"{1:.6g}\" width=\"{2:.6g}\" height=\"{3:.6g}\" viewBox=\"{0:.6g} {1:.6g} "
        "{2:.6g} {3:.6g}\">\n{4}</svg>\n",
        map.x, map.y, map.width, map.height, signs);
}

std::vector<std::pair<ZoneKind, std::string_view>> zone_words(const Mission& mission) {
    std::vector<std::pair<ZoneKind, std::string_view>> words{{ZoneKind::no_fly, "no-fly zone"},
                                                             {ZoneKind::keep_out, "keep-out zone"}};
    std::erase_if(words, [&](const auto& entry) {
        return std::ranges::count(mission.rules.zones, entry.first, &Zone::kind) == 0;
    });
    return words;
}

std::string zone_sample(ZoneKind kind, Rectangle box, double unit) {
    const std::string path =
        fmt::format("M{:.4g} {:.4g}h{:.4g}v{:.4g}h-{:.4g}z", box.x, box.y, box.width, box.height, box.width);
    return zone_sign(kind, path, unit);
}

}  // namespace waybreaker::render
