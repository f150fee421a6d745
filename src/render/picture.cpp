#include "render/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "render/caption.hpp"
#include "render/ground.hpp"
#include "render/legend.hpp"
#include "render/motion.hpp"
#include "render/name_places.hpp"
#include "render/note_lines.hpp"
#include "render/palette.hpp"
#include "render/reach.hpp"
#include "render/sample.hpp"
#include "render/scene.hpp"
#include "render/signs.hpp"
#include "render/waits.hpp"
#include "render/xml_text.hpp"
#include "render/zones.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::render {
namespace {

void validate(const PictureOptions& options) {
    if (options.width < least_width || options.width > most_width) {
        throw InputError(
            fmt::format("a picture cannot be {} pixels wide: choose {} to {}", options.width, least_width, most_width));
    }
    if (!(options.cell_size > 1e-6 && options.cell_size < 1e6)) {
        throw InputError(fmt::format("a cell cannot measure {} metres: give 0.000001 to 1000000", options.cell_size));
    }
}

std::string draw_obstacles(const Scene& scene) {
    const Layout& layout = scene.layout;
    std::string out = rectangle(layout.map, fmt::format(R"(fill="{}")", colour::street)) +
                      (scene.options.reach ? draw_bands(scene) : ground(scene.options.annotations.background, layout));
    for (const Style style : {Style::water, Style::off_road, Style::forbidden, Style::cliff, Style::unknown,
                              Style::obstacle, Style::barrier, Style::fixed_obstacle, Style::removed}) {
        out += obstacle_sign(style, scene.outline(style), {layout.map.x, layout.map.y}, scene.raster_scale(),
                             scene.unit());
    }
    return out + rectangle(layout.map, fmt::format(R"(fill="none" stroke="{}" stroke-width="{:.4g}")", colour::frame,
                                                   1.2 * scene.unit()));
}

// Each ground agent in a colour of its own; no paths before, which would hide the others.
std::string draw_team(const Scene& scene) {
    std::string out;
    std::size_t vehicle = 0;
    std::size_t aircraft = 0;
    for (const Itinerary& agent : scene.plan.agents) {
        const std::vector<Point> path = scene.on_map(agent.path);
        out += agent.kind == AgentKind::air ? aircraft_sign(aircraft++, path, scene.unit())
               : scene.options.reach        ? drive_sign(path, scene.unit())
                                            : vehicle_sign(vehicle++, path, scene.unit());
    }
    return out;
}

std::string draw_paths(const Scene& scene) {
    if (scene.mission.is_team()) return draw_team(scene);
    const Outcome& before = scene.plan.before;
    const Outcome& after = scene.plan.after;
    const auto draw = [&](PathSign sign, const auto& path) {
        return path_sign(sign, scene.on_map(path), scene.unit());
    };
    std::string out;
    if (before.air().path != after.air().path) out += draw(PathSign::air_before, before.air().path);
    if (before.ground().path != after.ground().path) out += draw(PathSign::ground_before, before.ground().path);
    return out + draw(PathSign::ground, after.ground().path) + draw(PathSign::air, after.air().path);
}

// A few words beside a sign.
Name note(const Scene& scene, Point sign, const std::string& text, std::size_t letters) {
    return {sign, text, text_width(letters, size::small_text * scene.unit()), (size::breach_label + 4) * scene.unit()};
}

// When it is over, and by whom.
Name breach_note(const Scene& scene, Point sign, const Breach& breach) {
    const std::string time = time_text(breach.cleared_at, scene.mission, scene.options);
    if (!scene.opener(breach)) return note(scene, sign, time, time.size());
    constexpr std::size_t most = 12;
    return note(scene, sign, fmt::format("{} {}", time, xml_text(breach.by, most)),
                time.size() + 1 + std::min(breach.by.size(), most + 1));
}

Name wait_note(const Scene& scene, Point sign, const Wait& wait) {
    const std::string time = fmt::format("+{}", time_text(wait.until - wait.from, scene.mission, scene.options));
    return note(scene, sign, time, time.size());
}

// Breaches, then waits, with their signs aside where they would cover each other. Many are neither numbered nor timed.
struct Moments {
    std::string signs;
    std::vector<Point> labels;
    std::vector<Name> notes;
};

Moments moments(const Scene& scene, const std::vector<Point>& taken) {
    const std::vector<Breach>& removed = scene.plan.breaches;
    const std::vector<Wait> waiting = waits(scene.plan);
    std::vector<waybreaker::Point> places;
    for (const Breach& breach : removed) places.emplace_back(breach.at);
    for (const Wait& wait : waiting) places.push_back(wait.at);
    const std::vector<Point> points = scene.on_map(places);
    const bool numbered = points.size() <= 99;
    const bool with_times = points.size() <= 12;
    Moments result;
    result.labels =
        numbered ? spread_labels(points, taken, size::breach_label * scene.unit(), scene.layout.window) : points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        result.signs += breach_leader(points[i], result.labels[i], scene.unit());
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool breach = i < removed.size();
        const Point at = result.labels[i];
        if (with_times) {
            result.notes.push_back(breach ? breach_note(scene, at, removed[i])
                                          : wait_note(scene, at, waiting[i - removed.size()]));
        }
        if (const auto aircraft = breach && numbered ? scene.opener(removed[i]) : std::nullopt) {
            result.signs += opener_sign(at, *aircraft, scene.unit());
        }
        result.signs += breach ? breach_label(at, numbered ? std::to_string(i + 1) : "", scene.unit())
                               : wait_sign(at, scene.unit());
    }
    return result;
}

// Whose start and goal it is, as long as names are few.
std::vector<Name> place_names(const Scene& scene) {
    constexpr std::size_t most_named = 30;
    if (!scene.mission.is_team() || scene.mission.agents.size() > most_named) return {};
    return names_at_places(scene.mission, scene.layout);
}

// What is written beside signs: notes come first. `places`: starts and goals.
std::string draw_written(const Scene& scene, const Moments& at, const std::vector<Point>& places) {
    constexpr double tips = 1.3;  // of the star reach beyond the square that a sign takes
    std::vector<Mark> signs;
    for (const Point place : places) {
        const bool both = std::ranges::count(places, place) > 1;
        signs.push_back({place, tips * (both ? size::start_at_goal : size::goal) * scene.unit()});
    }
    for (const Point label : at.labels) signs.push_back({label, size::breach_label * scene.unit()});
    std::vector<Name> names = at.notes;
    for (Name& name : place_names(scene)) names.push_back(std::move(name));
    const auto begins = name_places(names, signs, size::small_text * scene.unit(), scene.layout.room());
    std::string out;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (const auto& begin = begins[i]) out += words(*begin, names[i].text, scene.unit());
    }
    return out;
}

// Start and goal above everything; what else there is to mark keeps clear of them.
std::string draw_marks(const Scene& scene) {
    const std::vector<Point> starts = scene.places(&Agent::start);
    const std::vector<Point> goals = scene.places(&Agent::goal);
    std::vector<Point> taken = starts;
    taken.insert(taken.end(), goals.begin(), goals.end());
    const std::vector<Point> bases = scene.bases();
    taken.insert(taken.end(), bases.begin(), bases.end());
    std::string out;
    if (scene.options.reach) {
        const std::vector<Point> places = scene.on_map(places_of(scene));
        taken.insert(taken.end(), places.begin(), places.end());
        out += draw_places(scene);
    }
    const Moments all = moments(scene, taken);
    out += all.signs;
    for (const Point base : bases) out += base_sign(base, scene.unit());
    for (const Point start : starts) {
        out += start_sign(start, scene.unit(), std::find(goals.begin(), goals.end(), start) != goals.end());
    }
    for (const Point goal : goals) out += goal_sign(goal, scene.unit());
    return out + draw_written(scene, all, taken);
}

std::string draw_figures(const Scene& scene, double top) {
    const double unit = scene.unit();
    const double left = 550 * unit;
    const double columns[] = {775 * unit, 868 * unit, (1000 - size::margin) * unit};  // right ends
    double y = top + 0.5 * size::row * unit + 0.36 * size::text * unit;
    const auto cell = [&](int column, std::string_view content, bool bold, std::string_view colour) {
        const Point at = {column == 0 ? left : columns[column - 1], y};
        return text(at, content, size::text * unit, colour, column == 0 ? Anchor::start : Anchor::end, bold);
    };
    std::string out = cell(1, scene.mission.is_team() ? "alone" : "before", false, colour::faded_ink) +
                      cell(2, scene.mission.is_team() ? "together" : "after", false, colour::faded_ink);
    for (const FigureGroup& group : figures(scene.mission, scene.plan, scene.options)) {
        out += cell(0, group.name, false, colour::faded_ink);
        y += size::row * unit;
        for (const FigureRow& row : group.rows) {
            const bool bold = row.is_objective;
            out += cell(0, row.name, bold, colour::ink) + cell(1, row.before, bold, colour::ink) +
                   cell(2, row.after, bold, colour::ink) + cell(3, row.change, bold, colour::ink);
            y += size::row * unit;
        }
    }
    return out;
}

std::string draw_scale_bar(const Scene& scene) {
    const Layout& layout = scene.layout;
    const double unit = scene.unit();
    const ScaleBar bar = scale_bar(layout, scene.options);
    const double right = layout.window.x + layout.window.width;
    const double y = layout.window.y + layout.window.height + 22 * unit;
    const double tick = 5 * unit;
    const std::string line = fmt::format(
        R"(<path d="M{0:.6g} {1:.6g}v{2:.4g}h{3:.6g}v-{2:.4g}" fill="none" stroke="{4}" stroke-width="{5:.4g}"/>)"
        "\n",
        right - bar.length, y - tick, 2 * tick, bar.length, colour::ink, 1.8 * unit);
    const double baseline = y + 0.36 * size::small_text * unit;
    const std::string extent = fmt::format("{} \u00D7 {} cells", scene.map.width(), scene.map.height());
    return line +
           text({right - bar.length - 10 * unit, baseline}, bar.label, size::small_text * unit, colour::ink,
                Anchor::end) +
           text({layout.window.x, baseline}, extent, size::small_text * unit, colour::faded_ink);
}

// Of their table.
std::size_t figure_rows(const Scene& scene) {
    std::size_t rows = 0;
    for (const FigureGroup& group : figures(scene.mission, scene.plan, scene.options)) rows += 1 + group.rows.size();
    return rows;
}

// Long ones, such as names of files, in smaller letters.
std::string draw_title(const Scene& scene) {
    constexpr double bold_width = 0.68;  // of a bold letter's height
    const double room = (1000 - 2 * size::margin) / bold_width;
    const std::size_t letters = letter_count(scene.options.annotations.title);
    const double height = std::clamp(room / double(std::max<std::size_t>(letters, 1)), size::text, size::title);
    return text({size::margin * scene.unit(), 44 * scene.unit()},
                xml_text(scene.options.annotations.title, std::size_t(room / height)), height * scene.unit(),
                colour::ink, Anchor::start, true);
}

std::string draw_words(const Scene& scene, const std::vector<LegendEntry>& entries) {
    const Layout& layout = scene.layout;
    const double unit = scene.unit();
    const double left = size::margin * unit;
    const double rows = double(std::max(figure_rows(scene), rows_of(entries))) * size::row;
    const Point small_print{left, layout.height - 14 * unit};
    const std::vector<std::string> notes = note_lines(scene.options.annotations.notes);
    const double footer = small_print.y - (double(notes.size()) * size::note_row + rows + 30) * unit;
    return draw_title(scene) +
           text({left, 75 * unit}, headline(scene.map, scene.mission, scene.plan, scene.options), size::headline * unit,
                colour::ink) +
           draw_scale_bar(scene) + draw_legend(scene, entries, footer) + draw_figures(scene, footer) +
           draw_notes(notes, small_print, unit) +
           text(small_print, xml_text(scene.options.annotations.attribution, 110), size::small_text * unit,
                colour::faded_ink);
}

}  // namespace

std::string svg(const Map& map, const Mission& mission, const Plan& plan, const PictureOptions& options) {
    validate(options);
    Scene scene = {map, mission, plan, options, lay_out(map, options, 0), {}};
    const Sample sample(map, plan.breaches, scene.layout.sample_step, options.annotations);
    scene.outlines = outlines(sample.raster(), sample.styles());
    const std::vector<LegendEntry> entries = legend(scene);
    scene.layout = lay_out(map, options, std::max(figure_rows(scene), rows_of(entries)));
    const Layout& layout = scene.layout;
    const std::string head = fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0:g}" height="{1:g}" viewBox="0 0 {0:g} {1:g}" role="img" font-family="DejaVu Sans, Verdana, Helvetica, sans-serif">)"
        "\n<title>{2}</title>\n<desc>{3}</desc>\n<defs>\n{4}</defs>\n",
        layout.width, layout.height, xml_text(options.annotations.title, 200), headline(map, mission, plan, options),
        patterns(layout.unit, scene.raster_scale()) +
            (options.reach ? reach_patterns(layout.unit, scene.raster_scale()) : ""));
    const Motion moving = options.animate ? motion(map, mission, plan, layout, options.annotations) : Motion{};
    return head + moving.style +
           rectangle({0, 0, layout.width, layout.height}, fmt::format(R"(fill="{}")", colour::paper)) +
           draw_obstacles(scene) + draw_zones(mission, layout) + moving.standing + draw_paths(scene) +
           draw_marks(scene) + moving.agents + draw_words(scene, entries) + "</svg>\n";
}

}  // namespace waybreaker::render
