#include "render/caption.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "render/picture.hpp"
#include "site/demolition.hpp"

namespace waybreaker::render {
namespace {

constexpr const char* arrow = "\u2192";
constexpr const char* minus = "\u2212";
constexpr const char* dash = "\u2013";

// With unit speeds times are lengths (paper, section 2): how long they take at one cell, or one metre, in a unit of
// time.
bool times_are_lengths(const Mission& mission) {
    return std::all_of(mission.agents.begin(), mission.agents.end(),
                       [](const Agent& agent) { return agent.speed == 1; });
}

std::string number(std::optional<double> value, double factor) {
    if (!value) return dash;
    const double shown = *value * factor;
    return fmt::format("{:.{}f}", shown, shown < 10000 ? 1 : 0);
}

// "−5.5 %", empty where there is nothing to compare.
std::string change(std::optional<double> before, std::optional<double> after) {
    if (!before || !after || *before == 0) return "";
    const std::string percent = fmt::format("{:.1f}", 100 * std::abs(*after / *before - 1));
    const char* sign = percent == "0.0" ? "" : *after < *before ? minus : "+";
    return fmt::format("{}{} %", sign, percent);
}

// "3 openings, 640 m²": there is no room for the buildings.
std::string removals(const Map& map, const Plan& plan, const PictureOptions& options) {
    std::vector<ObstacleId> removed;
    for (const Breach& breach : plan.breaches) removed.push_back(breach.obstacle);
    const site::Demolition demolition = site::demolition(map, options.annotations.sections, removed);
    std::string text = site::removals_text(demolition);
    if (!options.metres || removed.empty()) return text;
    return text + ", " + site::area_text(double(demolition.cells) * (options.cell_size * options.cell_size));
}

std::string why_no_plan(PlanStatus status) {
    switch (status) {
        case PlanStatus::not_found:
            return "No plan was found, nor that there is none";
        case PlanStatus::limit_reached:
            return "No plan: the search reached its limit";
        case PlanStatus::stopped:
            return "No plan: the search was stopped";
        default:
            return "No plan: the ground agent cannot reach its goal";
    }
}

// ", gap 0.2 %" to the best possible plan, where a bound is known.
std::string gap(const Plan& plan, const PictureOptions& options) {
    const std::optional<double> reached = value(plan.after, options.objective);
    if (!plan.bound || !reached || *plan.bound <= 0) return "";
    return fmt::format(", gap {:.1f} %", 100 * std::max(*reached / *plan.bound - 1, 0.0));
}

std::string capitalised(std::string_view words) {
    std::string text(words);
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = char(text[0] - 'a' + 'A');
    return text;
}

// Of the ground agents' paths together.
std::optional<double> length_of_all(const Outcome& outcome) {
    double sum = 0;
    for (const Route& route : outcome.routes) {
        if (route.kind == AgentKind::air) continue;
        if (!route.length) return std::nullopt;
        sum += *route.length;
    }
    return sum;
}

}  // namespace

double time_factor(const Mission& mission, const PictureOptions& options) {
    return times_are_lengths(mission) && !options.seconds ? options.cell_size : 1;
}

std::string time_text(double time, const Mission& mission, const PictureOptions& options) {
    return number(time, time_factor(mission, options));
}

std::string time_unit(const Mission& mission, const PictureOptions& options) {
    if (options.seconds) return "s";
    if (!times_are_lengths(mission)) return "units of time";
    return options.metres ? "s at 1 m/s" : "cells at speed 1";
}

std::string headline(const Map& map, const Mission& mission, const Plan& plan, const PictureOptions& options) {
    if (plan.status != PlanStatus::solved) return why_no_plan(plan.status) + ", " + removals(map, plan, options);
    const double factor = time_factor(mission, options);
    if (mission.is_team()) {
        const std::size_t agents = mission.agents.size();
        return fmt::format("{} agent{}: {} {} {}{}{}", agents, agents == 1 ? "" : "s",
                           name_of(options.objective, mission), number(value(plan.after, options.objective), factor),
                           time_unit(mission, options),
                           plan.breaches.empty() ? "" : ", " + removals(map, plan, options), gap(plan, options));
    }
    const std::string what = capitalised(name_of(options.objective, mission));
    const std::optional<double> before = value(plan.before, options.objective);
    const std::optional<double> reached = value(plan.after, options.objective);
    const std::string after = number(reached, factor) + " " + time_unit(mission, options);
    if (plan.breaches.empty())
        return fmt::format("{} {}, {}{}", what, after, removals(map, plan, options), gap(plan, options));
    const std::string difference = change(before, reached);
    return fmt::format("{} {} {} {}{}, {}{}", what, before ? number(before, factor) : "(no way)", arrow, after,
                       difference.empty() ? "" : " (" + difference + ")", removals(map, plan, options),
                       gap(plan, options));
}

std::vector<Objective> shown_times(Objective objective) {
    std::vector<Objective> times{objective};
    for (const Objective other : {Objective::makespan, Objective::flowtime}) {
        if (other != objective) times.push_back(other);
    }
    return times;
}

std::string_view name_of(Objective objective, const Mission& mission) {
    switch (objective) {
        case Objective::makespan:
            return "makespan";
        case Objective::flowtime:
            return "flowtime";
        case Objective::ground_makespan:
            break;
    }
    return mission.is_team() ? "last vehicle" : "ground arrival";
}

std::vector<FigureGroup> figures(const Mission& mission, const Plan& plan, const PictureOptions& options) {
    const auto row = [](std::string_view name, std::optional<double> before, std::optional<double> after,
                        double factor) {
        return FigureRow{std::string(name), number(before, factor), number(after, factor), change(before, after)};
    };
    const Outcome& before = plan.before;
    const Outcome& after = plan.after;
    const double of_length = options.cell_size;
    const double of_time = time_factor(mission, options);
    std::vector<FigureRow> lengths;
    if (mission.is_team()) {
        lengths = {row("all ground paths", length_of_all(before), length_of_all(after), of_length)};
    } else {
        lengths = {row("path A, ground", before.ground().length, after.ground().length, of_length),
                   row("path B, air", before.air().length, after.air().length, of_length)};
    }
    std::vector<FigureRow> times;
    for (const Objective time : shown_times(options.objective)) {
        times.push_back(row(name_of(time, mission), value(before, time), value(after, time), of_time));
        times.back().is_objective = time == options.objective;
    }
    return {{fmt::format("length in {}", options.metres ? "metres" : "cells"), std::move(lengths)},
            {fmt::format("time in {}", time_unit(mission, options)), std::move(times)}};
}

}  // namespace waybreaker::render
