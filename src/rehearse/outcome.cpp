#include "rehearse/outcome.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "model/objective.hpp"
#include "rehearse/trail.hpp"
#include "rehearse/zone_faults.hpp"

namespace waybreaker::rehearsal {
namespace {

// When it was at its goal; of who was not, when all ended.
double end_of(const Actor& actor, double now) {
    return actor.phase == Phase::arrived ? actor.arrived_at : now;
}

// Of a vehicle: not at its goal in time.
bool is_left(const Actor& actor, const Agent& agent, const Rules& rules, double now) {
    if (!rules.unreached || actor.kind == AgentKind::air) return false;
    return actor.at(now) != Point(agent.goal) || end_of(actor, now) > *rules.unreached;
}

}  // namespace

Ending ending_of(const Revision& revision, std::span<const Actor> actors) {
    const auto at_home = [](const Actor& actor) {
        return actor.kind == AgentKind::air || actor.phase == Phase::arrived;
    };
    if (std::ranges::all_of(actors, at_home)) return Ending::arrived;
    if (revision.status == RevisionStatus::broken) return Ending::broken;
    return revision.plan.status == PlanStatus::no_plan ? Ending::no_way : Ending::not_found;
}

void sum_up(const Scene& scene, std::vector<Actor> actors, const Events& events, double now, Rehearsed& result) {
    const Rules& rules = scene.mission.rules;
    std::vector<std::string> faults;
    std::vector<Trail> vehicles;
    Finish finish;
    for (Actor& actor : actors) {
        const Agent& agent = scene.mission.agents[actor.number];
        const bool left = is_left(actor, agent, rules, now);
        if (left) ++result.unreached;
        const double ended = left ? rules.unreached.value_or(now) : end_of(actor, now);
        if (actor.phase != Phase::lost) finish.add(actor.kind, ended, agent.weight);
        ZoneFaults zoned = zone_faults(rules.zones, actor.trail);
        if (zoned.fault) faults.push_back(*std::move(zoned.fault));
        result.caught += zoned.caught ? 1 : 0;
        if (actor.kind == AgentKind::ground) vehicles.push_back(std::move(actor.trail));
    }
    result.makespan = finish.makespan();
    result.ground_makespan = finish.ground;
    result.flowtime = finish.flowtime;
    const bool stay = rules.at_goal == AtGoal::stay;
    const auto separation = rules.collisions ? std::optional(rules.separation) : std::nullopt;
    std::ranges::move(faults_of(scene.map, events, vehicles, separation, stay), std::back_inserter(faults));
    result.illegal = int(faults.size());
    if (!faults.empty()) result.fault = faults.front();
}

}  // namespace waybreaker::rehearsal
