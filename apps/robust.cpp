#include "robust.hpp"

#include <fmt/format.h>

#include <vector>

#include "draw_options.hpp"
#include "help.hpp"
#include "option.hpp"
#include "progress.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::apps {
namespace {

constexpr double seconds_of_revision = 10;

std::string figures(const Rehearsal& rehearsal, Objective objective) {
    const std::size_t runs = rehearsal.runs.size();
    const bool all = std::size_t(rehearsal.arrived) == runs;
    return fmt::format("mean {} {:.3f}{}", to_string(objective), spread_by(rehearsal, objective).mean,
                       all ? "" : fmt::format(", {} of {} arrive", rehearsal.arrived, runs));
}

std::string report_of(const std::vector<Rehearsal>& rehearsals, std::size_t chosen, Objective objective,
                      const RobustOptions& options) {
    const std::string within = fmt::format("within {:g}%", 100 * *options.share);
    const std::string best = figures(rehearsals[chosen], objective);
    const std::string runs = fmt::format("{} rehearsals", options.rehearsal.runs);
    if (rehearsals.size() == 1) return fmt::format("no other plan {} was evaluated; in {}: {}\n", within, runs, best);
    std::string text = fmt::format("of {} plans {} this one is best in {}: {}", rehearsals.size(), within, runs, best);
    if (chosen != 0) text += fmt::format("; the plan that it replaces: {}", figures(rehearsals.front(), objective));
    return text + "\n";
}

}  // namespace

void add_robust_options(CLI::App& command, RobustOptions& options) {
    const auto read = [&options](const std::string& given) {
        options.share = share_from(given);
        if (options.share) return;
        throw CLI::ValidationError("--robust",
                                   fmt::format("'{}' is not a share from 0 to 1, such as 0.01 or 1%", shown(given)));
    };
    command
        .add_option_function<std::string>(
            "--robust", read,
            "Of the plans that were evaluated and are at most that much worse than the best one, take the one that "
            "rehearses best: the most missions arrive, then the mean of what --objective says is the least. Takes time "
            "beyond --time-limit")
        ->type_name("SHARE");
    for (CLI::Option* draw : add_draws(command, options.rehearsal)) draw->needs("--robust");
}

RobustPlan robust_plan(const io::MapFile& map, const io::MissionDocument& asked, const RobustOptions& options) {
    std::vector<Plan> plans = [&] {
        const Progress progress("planning");
        return Planner().alternatives(map.map, asked.mission, options.share.value(), asked.method, asked.limits);
    }();
    plans.front().seconds.label = map.label_seconds;
    for (Plan& plan : plans) plan.seconds.total += map.label_seconds;
    if (plans.front().status != PlanStatus::solved) return {std::move(plans.front()), ""};
    Progress progress("rehearsing");
    std::vector<Rehearsal> rehearsals;
    for (const Plan& plan : plans) {
        progress.update(fmt::format("plan {} of {}", rehearsals.size() + 1, plans.size()));
        rehearsals.push_back(rehearse(map.map, asked.mission, plan, options.rehearsal,
                                      method_of_revisions(asked.method),
                                      {.seconds = seconds_of_revision, .threads = 1}));
    }
    const Objective objective = asked.mission.rules.objective;
    const std::size_t chosen = most_robust(rehearsals, objective);
    return {std::move(plans[chosen]), report_of(rehearsals, chosen, objective, options)};
}

}  // namespace waybreaker::apps
