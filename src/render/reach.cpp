#include "render/reach.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "render/bands.hpp"
#include "render/caption.hpp"
#include "render/outline.hpp"
#include "render/palette.hpp"
#include "render/signs.hpp"

namespace waybreaker::render {
namespace {

Bands bands_of(const Scene& scene) {
    return {*scene.options.reach, scene.mission, time_factor(scene.mission, scene.options)};
}

BandRaster raster_of(const Scene& scene, const Bands& bands) {
    return band_raster(scene.map, scene.plan, *scene.options.reach, bands, scene.layout.sample_step);
}

constexpr std::array<std::string_view, 2> gain_fills{"url(#sooner)", "url(#onlynow)"};

// "reached by 400 s"
std::string time_words(double time, const Scene& scene) {
    const bool seconds = scene.options.seconds || scene.options.metres;
    return fmt::format("{:g}{}", time, seconds ? " s" : "");
}

// `path`: in drawn cells.
std::string area(const std::string& path, std::string_view fill, Point origin, double scale) {
    if (path.empty()) return "";
    return fmt::format(
        R"svg(<path transform="translate({:.6g} {:.6g}) scale({:.6g})" fill="{}" fill-rule="evenodd" d="{}"/>)svg"
        "\n",
        origin.x, origin.y, scale, fill, path);
}

enum class Gain { none, sooner, only_now, never };

struct Place {
    Cell at;
    Gain gain;
    double weight;
};

std::vector<Place> gains_of_places(const Scene& scene) {
    const Reach& reach = *scene.options.reach;
    const Bands bands = bands_of(scene);
    std::vector<Place> places;
    for (std::size_t i = 0; i < scene.mission.agents.size(); ++i) {
        const Agent& agent = scene.mission.agents[i];
        if (agent.kind == AgentKind::air) continue;
        const Cell at = reach.inbound ? agent.start : agent.goal;
        const std::size_t cell = std::size_t(at.y) * std::size_t(scene.map.width()) + std::size_t(at.x);
        const float before = reach.before[cell];
        const float after = reach.after[cell];
        const Gain gain = !scene.plan.agents[i].reached   ? Gain::never
                          : bands.only_now(before, after) ? Gain::only_now
                          : bands.sooner(before, after)   ? Gain::sooner
                                                          : Gain::none;
        places.push_back({at, gain, agent.weight});
    }
    return places;
}

std::string place_sign(Point at, Gain gain, double radius, double unit) {
    const bool filled = gain == Gain::only_now;
    const std::string_view fill = filled ? colour::removed : gain == Gain::sooner ? colour::removed_tint : colour::halo;
    const std::string_view edge = filled ? colour::halo : gain == Gain::sooner ? colour::breach : colour::ink;
    std::string sign =
        fmt::format(R"(<circle cx="{:.6g}" cy="{:.6g}" r="{:.4g}" fill="{}" stroke="{}" stroke-width="{:.4g}"/>)"
                    "\n",
                    at.x, at.y, radius * unit, fill, edge, 2.4 * unit);
    if (gain == Gain::never) {
        const double arm = 0.75 * radius * unit;
        sign += fmt::format(R"(<path d="M{0:.6g} {1:.6g}l{2:.4g} {2:.4g}m0 -{2:.4g}l-{2:.4g} {2:.4g}" stroke="{3}" )"
                            R"(stroke-width="{4:.4g}" stroke-linecap="round"/>)"
                            "\n",
                            at.x - arm, at.y - arm, 2 * arm, colour::ink, 2.4 * unit);
    }
    return sign;
}

}  // namespace

std::string draw_bands(const Scene& scene) {
    const Bands bands = bands_of(scene);
    const BandRaster raster = raster_of(scene, bands);
    const std::vector<std::string> grounds = outlines({raster.width, raster.height, raster.after}, bands.count() + 1);
    const Point origin{scene.layout.map.x, scene.layout.map.y};
    const double scale = scene.raster_scale();
    std::string drawn;
    for (std::size_t i = 0; i < grounds.size(); ++i)
        drawn += area(grounds[i], i < bands.count() ? colour::bands[i] : "url(#unreached)", origin, scale);
    const std::vector<std::string> gains = outlines({raster.width, raster.height, raster.gains}, gain_fills.size());
    for (std::size_t i = 0; i < gains.size(); ++i) drawn += area(gains[i], gain_fills[i], origin, scale);
    return drawn;
}

std::vector<Cell> places_of(const Scene& scene) {
    std::vector<Cell> cells;
    for (const Place& place : gains_of_places(scene)) cells.push_back(place.at);
    return cells;
}

std::string draw_places(const Scene& scene) {
    std::vector<Place> places = gains_of_places(scene);
    double most = 0;
    for (const Place& place : places) most = std::max(most, place.weight);
    std::ranges::stable_sort(places, std::greater(), &Place::weight);  // small ones above large ones
    std::string drawn;
    for (const Place& place : places) {
        const double share = most > 0 ? place.weight / most : 1;
        drawn += place_sign(scene.layout.at(place.at), place.gain, size::place * (0.5 + 0.5 * std::sqrt(share)),
                            scene.unit());
    }
    return drawn;
}

std::string drive_sign(const std::vector<Point>& path, double unit) {
    std::string data;
    for (const Point& p : path) data += fmt::format("{}{:.6g} {:.6g}", data.empty() ? "M" : "L", p.x, p.y);
    const auto line = [&](std::string_view colour, double width) {
        return fmt::format(R"(<path d="{}" fill="none" stroke="{}" stroke-width="{:.4g}" stroke-linejoin="round"/>)"
                           "\n",
                           data, colour, width * unit);
    };
    return line(colour::halo, 3.6) + line(colour::ink, 1.6);
}

std::vector<LegendEntry> reach_legend(const Scene& scene) {
    const double unit = scene.unit();
    const Bands bands = bands_of(scene);
    const BandRaster raster = raster_of(scene, bands);
    const double scale = scene.raster_scale();
    const auto swatch = [&](std::string_view fill) {
        const std::string box = fmt::format("M0 0h{0:.4g}v{1:.4g}h-{0:.4g}z", 34 * unit / scale, 16 * unit / scale);
        return area(box, fill, {6 * unit, -8 * unit}, scale);
    };
    std::vector<LegendEntry> entries;
    for (std::size_t i = 0; i < bands.count(); ++i)
        entries.push_back({swatch(colour::bands[i]), "reached by " + time_words(bands.end(i), scene)});
    if (std::ranges::count(raster.after, bands.count() + 1) > 0)
        entries.push_back({swatch("url(#unreached)"), "not reached"});
    const std::array<std::string, 2> words{fmt::format("{} or more sooner", time_words(bands.clear_gain(), scene)),
                                           "reached only now"};
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (std::ranges::count(raster.gains, i + 1) > 0)
            entries.push_back({swatch(colour::bands[3]) + swatch(gain_fills[i]), words[i]});
    }
    std::map<Gain, std::size_t> counts;
    for (const Place& place : gains_of_places(scene)) ++counts[place.gain];
    for (const auto& [gain, count] : counts) {
        constexpr std::array<std::string_view, 4> kinds{"", " sooner", " only now", " not reached"};
        entries.push_back({place_sign({23 * unit, 0}, gain, 0.8 * size::place, unit),
                           fmt::format("{} place{}{}", count, count == 1 ? "" : "s", kinds[std::size_t(gain)])});
    }
    return entries;
}

std::string reach_patterns(double unit, double scale) {
    const auto pattern = [&](std::string_view id, double size, int turn, const std::string& content) {
        return fmt::format(
            R"svg(<pattern id="{0}" width="{1:.4g}" height="{1:.4g}" patternUnits="userSpaceOnUse" patternTransform="rotate({2})">{3}</pattern>)svg"
            "\n",
            id, size, turn, content);
    };
    const auto stripe = [](double width, double height, std::string_view colour) {
        return fmt::format(R"(<rect width="{:.4g}" height="{:.4g}" fill="{}"/>)", width, height, colour);
    };
    const double wide = 9 * unit / scale;
    const double narrow = 6 * unit / scale;
    const double sparse = 14 * unit / scale;
    // Beside white each shows on light and on dark ground.
    const auto hatch = [&](double step) {
        return stripe(0.4 * step, step, colour::halo) + stripe(0.22 * step, step, colour::removed);
    };
    return pattern("sooner", wide, -45, hatch(wide)) + pattern("onlynow", narrow, -45, hatch(narrow)) +
           pattern("unreached", sparse, 0,
                   stripe(sparse, sparse, colour::street) +
                       fmt::format(R"(<circle cx="{0:.4g}" cy="{0:.4g}" r="{1:.4g}" fill="{2}"/>)", sparse / 2,
                                   1.3 * unit / scale, colour::faded_ink));
}

}  // namespace waybreaker::render
