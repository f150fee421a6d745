// Teams on small label maps, with anything that can be asked of them: plans are judged, and simulated.
#include <array>
#include <string>
#include <vector>

#include "abilities.hpp"
#include "choices.hpp"
#include "laws.hpp"
#include "team/simulation.hpp"
#include "waybreaker/check.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

bool is_possible(const Map& map, const Mission& mission) {
    try {
        validate(map, mission, {});
        return true;
    } catch (const InputError&) {
        return false;
    }
}

Agent any_vehicle(Choices& choices, const std::vector<Cell>& free) {
    Agent agent;
    agent.start = free[std::size_t(choices.below(int(free.size())))];
    agent.goal = free[std::size_t(choices.below(int(free.size())))];
    agent.body.radius = choices.of(std::array{0.5, 0.5, 0.35, 0.0, 0.2, 0.7, 1.2});
    agent.speed = choices.of(std::array{1.0, 1.0, 0.5, 3.0});
    if (choices.one_in(4)) agent.ready_at = 2.5;
    return agent;
}

Agent any_aircraft(Choices& choices, const Map& map) {
    Agent agent;
    agent.kind = AgentKind::air;
    agent.start = choices.cell(map);
    agent.goal = choices.cell(map);
    agent.speed = choices.of(std::array{1.0, 0.5, 3.0});
    if (choices.one_in(3)) agent.breaches = choices.below(3);
    return agent;
}

Mission any_team(Choices& choices, const Map& map) {
    Mission mission;
    Rules& rules = mission.rules;
    rules.separation = choices.of(std::array{0.0, 0.0, 0.5});
    std::vector<Cell> free;
    for (Cell c; c.y < map.height(); ++c.y) {
        for (c.x = 0; c.x < map.width(); ++c.x) {
            if (!map.grid().blocked(c)) free.push_back(c);
        }
    }
    const int vehicles = free.empty() ? 0 : 1 + choices.below(4);
    const int aircraft = choices.below(3);
    for (int i = 0; i < vehicles + aircraft; ++i) {
        mission.agents.push_back(i < vehicles ? any_vehicle(choices, free) : any_aircraft(choices, map));
        mission.agents.back().id = std::to_string(i);
        if (i < vehicles && !is_possible(map, mission)) mission.agents.pop_back();
    }
    rules.at_goal = choices.one_in(3) ? AtGoal::leave : AtGoal::stay;
    set_rules(choices, map, 3, rules);
    if (choices.one_in(3)) give_abilities(map, mission, [&](int count) { return choices.below(count); });
    return mission;
}

}  // namespace
}  // namespace waybreaker

// A plan is legal, for the judge and for a simulation that knows neither judge nor planner, and never below its bound.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace waybreaker;
    constexpr double step = 0.05;
    Choices choices(data, size);
    const Map map = any_map(choices, 10, 8);
    const Mission mission = any_team(choices, map);
    if (!is_possible(map, mission)) return 0;
    const Plan plan = Planner().plan(map, mission);
    law(check(map, mission, plan).empty());
    if (plan.status != PlanStatus::solved) return 0;
    law(!plan.bound || *plan.bound <= *value(plan.after, mission.rules.objective) * (1 + 1e-9));
    if (mission.is_team()) law(simulate(map, mission, plan, step).empty());
    return 0;
}
