#include "io/state_json.hpp"
#include "laws.hpp"
#include "waybreaker/check.hpp"
#include "waybreaker/revise.hpp"

// What is read comes back from what is written of it. A small mission can be revised by it, to a valid plan that goes
// on from the one before, or it is refused in one line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace waybreaker;
    static const Map map = Map::from_rows({"...A....", "...A..B.", "...A..B.", "......B."});
    static const Mission mission = [] {
        Mission asked{{vehicle("rover", {0, 0}, {7, 0}), vehicle("van", {0, 3}, {5, 3}), aircraft("heli", {0, 1})}};
        asked.rules.removals = 2;
        asked.rules.breach_time.per_obstacle = 1.5;
        asked.rules.retries = 1;
        return asked;
    }();
    static const Plan plan = Planner().plan(map, mission);
    read_or_refuse(data, size, [](std::string_view bytes) {
        const State state = io::parse_state(bytes, "input");
        const std::string text = io::state_json(state).dump();
        law(io::state_json(io::parse_state(text, "input")).dump() == text);
        Planner planner;
        const Revision next = [&] {
            try {
                return revise(planner, map, mission, plan, state, 0.5, {}, {.expansions = 20'000});
            } catch (const InputError& error) {
                throw InputError("input", 0, error.what());
            }
        }();
        for (const Violation& violation : check_continuity(mission, plan, state, next.mission, next.plan)) {
            law(!violation.message.empty());
        }
        if (next.plan.status != PlanStatus::solved) return;
        law(check(next.map, next.mission, next.plan).empty());
        law(check_continuity(mission, plan, state, next.mission, next.plan).empty());
    });
    return 0;
}
