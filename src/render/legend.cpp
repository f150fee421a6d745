#include "render/legend.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "render/outline.hpp"
#include "render/palette.hpp"
#include "render/reach.hpp"
#include "render/signs.hpp"
#include "render/waits.hpp"
#include "render/zones.hpp"

namespace waybreaker::render {
namespace {

std::string path_sample(const Scene& scene, PathSign sign) {
    return path_sign(sign, {{2 * scene.unit(), 0}, {44 * scene.unit(), 0}}, scene.unit());
}

std::vector<LegendEntry> single_paths(const Scene& scene) {
    const Outcome& before = scene.plan.before;
    const Outcome& after = scene.plan.after;
    std::vector<LegendEntry> entries;
    if (!after.ground().path.empty()) entries.push_back({path_sample(scene, PathSign::ground), "ground path"});
    if (before.ground().path != after.ground().path && !before.ground().path.empty()) {
        entries.push_back({path_sample(scene, PathSign::ground_before), "ground path before"});
    }
    entries.push_back({path_sample(scene, PathSign::air), "air path"});
    if (before.air().path != after.air().path && !before.air().path.empty()) {
        entries.push_back({path_sample(scene, PathSign::air_before), "air path before"});
    }
    return entries;
}

std::vector<LegendEntry> team_paths(const Scene& scene) {
    const double unit = scene.unit();
    const std::string drives = scene.options.reach ? drive_sign({{2 * unit, 0}, {44 * unit, 0}}, unit)
                                                   : vehicle_sign(0, {{2 * unit, 0}, {22 * unit, 0}}, unit) +
                                                         vehicle_sign(1, {{24 * unit, 0}, {44 * unit, 0}}, unit);
    std::vector<LegendEntry> entries{{drives, "ground paths"}};
    const auto flies = [](const Agent& agent) { return agent.kind == AgentKind::air; };
    if (std::ranges::any_of(scene.mission.agents, flies)) {
        entries.push_back({path_sample(scene, PathSign::air), "air path"});
    }
    return entries;
}

}  // namespace

std::vector<LegendEntry> legend(const Scene& scene) {
    const double unit = scene.unit();
    const Point middle = {23 * unit, 0};
    const auto swatch = [&](Style style) {
        const double scale = scene.raster_scale();
        const double width = 34 * unit / scale;
        const double height = 16 * unit / scale;
        return obstacle_sign(style, fmt::format("M0 0h{0:.4g}v{1:.4g}h-{0:.4g}z", width, height), {6 * unit, -8 * unit},
                             scale, unit);
    };
    std::vector<LegendEntry> entries;
    if (!scene.places(&Agent::start).empty()) entries.push_back({start_sign(middle, unit), "start"});
    if (!scene.places(&Agent::goal).empty()) entries.push_back({goal_sign(middle, unit), "goal"});
    if (!scene.bases().empty()) entries.push_back({base_sign(middle, unit), "recharging base"});
    for (LegendEntry& entry : scene.mission.is_team() ? team_paths(scene) : single_paths(scene)) {
        entries.push_back(std::move(entry));
    }
    if (scene.options.reach) {
        for (LegendEntry& entry : reach_legend(scene)) entries.push_back(std::move(entry));
    }
    for (std::size_t i = 0; i < std::size_t(Style::removed); ++i) {
        if (!scene.outline(Style(i)).empty()) entries.push_back({swatch(Style(i)), std::string(style_words[i])});
    }
    for (const auto& [kind, words] : zone_words(scene.mission))
        entries.push_back({zone_sample(kind, {6 * unit, -8 * unit, 34 * unit, 16 * unit}, unit), std::string(words)});
    if (!scene.plan.breaches.empty()) {
        entries.push_back({swatch(Style::removed), std::string(style_words[std::size_t(Style::removed)])});
        const bool has_opener = scene.opener(scene.plan.breaches.front()).has_value();
        entries.push_back({breach_label(middle, "1", unit), has_opener ? "breach, when, who" : "breach, when"});
    }
    if (!waits(scene.plan).empty()) entries.push_back({wait_sign(middle, unit), "wait, how long"});
    return entries;
}

std::size_t rows_of(const std::vector<LegendEntry>& entries) {
    return (entries.size() + 1) / 2;
}

std::string draw_legend(const Scene& scene, const std::vector<LegendEntry>& entries, double top) {
    const double unit = scene.unit();
    const std::size_t rows = rows_of(entries);
    std::string out;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const bool is_left = i < rows;
        const double x = (size::margin + (is_left ? 0 : 265)) * unit;
        const double y = top + (double(is_left ? i : i - rows) + 0.5) * size::row * unit;
        out += fmt::format("<g transform=\"translate({:.6g} {:.6g})\">\n{}</g>\n", x, y, entries[i].sign);
        out += text({x + 58 * unit, y + 0.36 * size::text * unit}, entries[i].name, size::text * unit, colour::ink);
    }
    return out;
}

}  // namespace waybreaker::render
