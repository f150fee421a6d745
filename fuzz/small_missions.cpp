// Missions on small label maps, anything that can be asked of them: plans are judged against all plans there are.
#include <array>
#include <cmath>
#include <vector>

#include "all_plans.hpp"
#include "laws.hpp"
#include "waybreaker/check.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

// The input as choices, one byte each; zeros once it has ended.
class Choices {
  public:
    Choices(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}

    int below(int count) { return next_ == end_ ? 0 : *next_++ % count; }
    bool one_in(int count) { return below(count) == count - 1; }
    template <class T, std::size_t count>
    T of(const std::array<T, count>& all) {
        return all[std::size_t(below(int(count)))];
    }
    Cell cell(const Map& map) { return {below(map.width()), below(map.height())}; }

  private:
    const std::uint8_t* next_;
    const std::uint8_t* end_;
};

constexpr int most_labels = 4;

Map any_map(Choices& choices) {
    const int width = 2 + choices.below(6);
    const int height = 2 + choices.below(4);
    std::array<ObstacleAttributes, most_labels + 1> attributes;
    for (ObstacleAttributes& known : attributes) {
        known.destructible = !choices.one_in(8);
        known.weight = choices.of(std::array{1.0, 1.0, 0.5, 3.0});
        known.breach_time = choices.of(std::array{0.0, 0.0, 2.0});
    }
    std::vector<std::uint32_t> labels(std::size_t(width * height));
    for (std::uint32_t& label : labels) label = choices.one_in(2) ? std::uint32_t(1 + choices.below(most_labels)) : 0;
    return Map::from_labels(width, height, labels, attributes);
}

Mission any_mission(Choices& choices, const Map& map) {
    Mission mission = ground_and_air(choices.cell(map), choices.cell(map));
    Agent& ground = mission.agents[0];
    Agent& air = mission.agents[1];
    if (choices.one_in(2)) air.start = choices.cell(map);
    if (choices.one_in(2)) air.goal = choices.cell(map);
    ground.speed = choices.of(std::array{1.0, 0.5, 2.0});
    air.speed = choices.of(std::array{1.0, 0.5, 3.0});
    Rules& rules = mission.rules;
    rules.removals = choices.below(3);
    rules.objective = choices.of(std::array{Objective::makespan, Objective::flowtime, Objective::ground_makespan});
    rules.breach_time = {choices.of(std::array{0.0, 1.0, 4.5}), choices.of(std::array{0.0, 0.0, 0.3})};
    if (choices.one_in(4)) rules.budget = choices.of(std::array{0.0, 1.0, 2.5, 4.0});
    for (const Obstacle& obstacle : map.obstacles()) {
        const int rule = choices.below(12);
        if (rule == 10) rules.force.push_back(obstacle.id);
        if (rule == 11) rules.protect.push_back(obstacle.id);
    }
    return mission;
}

}  // namespace
}  // namespace waybreaker

// A plan is legal, and no other plan of the mission, of all there are, is below its bound. Where there is one, there is
// a plan.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace waybreaker;
    Choices choices(data, size);
    const Map map = any_map(choices);
    const Mission mission = any_mission(choices, map);
    try {
        validate(map, mission);
    } catch (const InputError&) {
        return 0;
    }
    const Plan plan = MissionPlanner().plan(map, mission);
    law(check(map, mission, plan).empty());
    const double best = AllPlans(map, mission).best();
    law((plan.status == PlanStatus::solved) == std::isfinite(best));
    if (plan.status != PlanStatus::solved) return 0;
    const double reached = *value(plan.after, mission.rules.objective);
    law(*plan.bound <= best * (1 + 1e-9));
    law(best <= reached * (1 + 1e-6));
    return 0;
}
