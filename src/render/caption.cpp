#include "render/caption.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "render/picture.hpp"

namespace waybreaker::render {
namespace {

constexpr const char* arrow = "\u2192";
constexpr const char* minus = "\u2212";
constexpr const char* dash = "\u2013";

// With unit speeds times are lengths (paper, section 2), and so shown in the same unit; otherwise in units of time.
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

std::string removals(std::size_t count) {
    if (count == 0) return "no obstacle removed";
    return fmt::format("{} obstacle{} removed", count, count == 1 ? "" : "s");
}

std::string why_no_plan(PlanStatus status) {
    switch (status) {
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

}  // namespace

std::string time_text(double time, const Mission& mission, const PictureOptions& options) {
    return number(time, times_are_lengths(mission) ? options.cell_size : 1);
}

std::string headline(const Mission& mission, const Plan& plan, const PictureOptions& options) {
    if (plan.status != PlanStatus::solved) return why_no_plan(plan.status) + ", " + removals(plan.removed.size());
    const bool lengths = times_are_lengths(mission);
    const double factor = lengths ? options.cell_size : 1;
    const std::string unit = !lengths ? "" : options.metres ? " m" : " cells";
    const std::string after = number(plan.after.makespan, factor) + unit;
    if (plan.removed.empty()) return fmt::format("Makespan {}, {}{}", after, removals(0), gap(plan, options));
    const std::string difference = change(plan.before.makespan, plan.after.makespan);
    return fmt::format(
        "Makespan {} {} {}{}, {}{}", plan.before.makespan ? number(plan.before.makespan, factor) : "(no way)", arrow,
        after, difference.empty() ? "" : " (" + difference + ")", removals(plan.removed.size()), gap(plan, options));
}

std::vector<FigureRow> figures(const Mission& mission, const Plan& plan, const PictureOptions& options) {
    const double length_factor = options.cell_size;
    const double time_factor = times_are_lengths(mission) ? options.cell_size : 1;
    const auto row = [](const char* name, std::optional<double> before, std::optional<double> after, double factor) {
        return FigureRow{name, number(before, factor), number(after, factor), change(before, after)};
    };
    return {row("path A, ground", plan.before.ground.length, plan.after.ground.length, length_factor),
            row("path B, air", plan.before.air.length, plan.after.air.length, length_factor),
            row("makespan", plan.before.makespan, plan.after.makespan, time_factor),
            row("flowtime", plan.before.flowtime, plan.after.flowtime, time_factor),
            {"removals", "0", std::to_string(plan.removed.size()), ""}};
}

}  // namespace waybreaker::render
