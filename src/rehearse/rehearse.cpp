#include "waybreaker/rehearse.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <string>

#include "core/parallel.hpp"
#include "core/range.hpp"
#include "rehearse/executor.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

void validate(const Mission& mission, const Plan& plan, const RehearsalOptions& options) {
    require_range(options.fail, 0, 1, "the chance that a breach fails");
    require_range(options.delay.mean, 0, most_delay, "the mean delay");
    require_range(options.blocked, 0, 1, "the chance that a street is blocked");
    require_range(options.sight, least_sight, 1000, "how far a vehicle sees");
    require_range(options.lost, 0, 1, "the chance that an aircraft is lost");
    require_range(options.runs, 1, most_runs, "the number of runs");
    const auto contradiction = [](const char* what) { throw InputError(ErrorCode::contradiction, "", what); };
    if (plan.status != PlanStatus::solved) contradiction("only a plan that is solved can be rehearsed");
    if (!std::ranges::equal(mission.agents, plan.agents, {}, &Agent::id, &Itinerary::id))
        contradiction("the agents of the plan are not the mission's");
    if (mission.rules.timing == Timing::ignore)
        contradiction(
            "a plan that enters obstacles before they are breached cannot be rehearsed: plan it with timing "
            "enforced");
}

Spread spread_of(std::vector<double> values) {
    if (values.empty()) return {};
    std::ranges::sort(values);
    double sum = 0;
    for (const double value : values) sum += value;
    return {sum / double(values.size()), quantile(values, 0.5), quantile(values, 0.95), values.back()};
}

}  // namespace

double quantile(const std::vector<double>& rising, double share) {
    if (rising.empty()) return 0;
    const double rank = std::ceil(share * double(rising.size()));
    return rising[std::size_t(std::clamp(rank, 1.0, double(rising.size()))) - 1];
}

Rehearsal rehearse(const Map& map, const Mission& mission, const Plan& plan, const RehearsalOptions& options,
                   const Method& method, const Limits& limits) {
    validate(mission, plan, options);
    Rehearsal rehearsal;
    rehearsal.planned = plan.after.makespan.value_or(0);
    rehearsal.ground_planned = plan.after.ground_makespan.value_or(0);
    rehearsal.flowtime_planned = plan.after.flowtime.value_or(0);
    rehearsal.unreached_planned = int(std::ranges::count(plan.agents, false, &Itinerary::reached));
    rehearsal.runs.resize(std::size_t(options.runs));
    const std::vector<rehearsal::Script> scripts = rehearsal::scripts_of(map, mission, plan, {});
    const rehearsal::Scene scene{map, mission, plan, scripts, options, method, limits};
    const std::size_t threads = std::min<std::size_t>(thread_count(options.threads), rehearsal.runs.size());
    std::vector<Planner> planners(threads);
    std::vector<std::vector<double>> times(threads);
    std::atomic<int> done = 0;
    for_each_index(rehearsal.runs.size(), unsigned(threads), [&](std::size_t run, std::size_t thread) {
        rehearsal.runs[run] = rehearsal::play(scene, run, planners[thread], times[thread]);
        const int count = ++done;
        if (options.progress) options.progress(count);
    });
    std::vector<double> makespans;
    std::vector<double> ground_makespans;
    std::vector<double> flowtimes;
    for (const Rehearsed& run : rehearsal.runs) {
        rehearsal.revisions += run.revisions;
        if (run.illegal > 0) ++rehearsal.illegal;
        if (run.on_reserve > 0) ++rehearsal.on_reserve;
        if (run.emptied > 0) ++rehearsal.emptied;
        if (run.caught > 0) ++rehearsal.caught;
        if (run.ending != Ending::arrived) continue;
        ++rehearsal.arrived;
        makespans.push_back(run.makespan);
        ground_makespans.push_back(run.ground_makespan);
        flowtimes.push_back(run.flowtime);
        rehearsal.unreached += run.unreached;
    }
    if (rehearsal.arrived > 0) rehearsal.unreached /= rehearsal.arrived;
    rehearsal.revisions /= double(rehearsal.runs.size());
    rehearsal.makespan = spread_of(std::move(makespans));
    rehearsal.ground_makespan = spread_of(std::move(ground_makespans));
    rehearsal.flowtime = spread_of(std::move(flowtimes));
    for (std::vector<double>& list : times) std::ranges::copy(list, std::back_inserter(rehearsal.revise_ms));
    std::ranges::sort(rehearsal.revise_ms);
    return rehearsal;
}

const Spread& spread_by(const Rehearsal& rehearsal, Objective objective) {
    if (objective == Objective::flowtime) return rehearsal.flowtime;
    return objective == Objective::ground_makespan ? rehearsal.ground_makespan : rehearsal.makespan;
}

std::size_t most_robust(std::span<const Rehearsal> rehearsals, Objective objective) {
    const auto mean = [objective](const Rehearsal& rehearsal) { return spread_by(rehearsal, objective).mean; };
    const auto is_better = [&](const Rehearsal& a, const Rehearsal& b) {
        return a.arrived != b.arrived ? a.arrived > b.arrived : mean(a) < mean(b);
    };
    return std::size_t(std::ranges::min_element(rehearsals, is_better) - rehearsals.begin());
}

}  // namespace waybreaker
