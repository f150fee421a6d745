// Missions on small label maps, anything that can be asked of them: plans are judged against all plans there are.
#include <array>
#include <cmath>

#include "all_plans.hpp"
#include "choices.hpp"
#include "laws.hpp"
#include "waybreaker/check.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

Mission any_mission(Choices& choices, const Map& map) {
    Mission mission = ground_and_air(choices.cell(map), choices.cell(map));
    Agent& ground = mission.agents[0];
    Agent& air = mission.agents[1];
    if (choices.one_in(2)) air.start = choices.cell(map);
    if (choices.one_in(2)) air.goal = choices.cell(map);
    ground.speed = choices.of(std::array{1.0, 0.5, 2.0});
    air.speed = choices.of(std::array{1.0, 0.5, 3.0});
    set_rules(choices, map, 2, mission.rules);
    return mission;
}

}  // namespace
}  // namespace waybreaker

// A plan is legal, and no other plan of the mission, of all there are, is below its bound. Where there is one, there is
// a plan.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace waybreaker;
    Choices choices(data, size);
    const Map map = any_map(choices, 7, 5);
    const Mission mission = any_mission(choices, map);
    try {
        validate(map, mission);
    } catch (const InputError&) {
        return 0;
    }
    const Plan plan = Planner().plan(map, mission);
    law(check(map, mission, plan).empty());
    const double best = AllPlans(map, mission).best();
    law((plan.status == PlanStatus::solved) == std::isfinite(best));
    if (plan.status != PlanStatus::solved) return 0;
    const double reached = *value(plan.after, mission.rules.objective);
    law(*plan.bound <= best * (1 + 1e-9));
    law(best <= reached * (1 + 1e-6));
    return 0;
}
