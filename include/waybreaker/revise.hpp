// Revise: the rest of a mission planned anew, from what has happened to its plan.
//
//     Revision next = revise(planner, map, mission, plan, state);
//     if (next.status == RevisionStatus::revised) send(next.plan);
//
// In the words of VDA 5050: what lies before an agent's decision point is its base and stays; what lies behind is its
// horizon and is free.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waybreaker/limits.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/method.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"
#include "waybreaker/planner.hpp"
#include "waybreaker/state.hpp"
#include "waybreaker/words.hpp"

namespace waybreaker {

// `unchanged`: the state is one that the plan knows already. `kept`: the rest of the plan is the best still, on new
// times where agents are late. `revised`: it is another. `no_plan`: none is left, or was found (Revision::plan says
// which). `broken`: an agent is bound to meet what was found, unless it stops (Revision::stops).
enum class RevisionStatus { unchanged, kept, revised, no_plan, broken };
template <>
inline constexpr std::array<std::string_view, 5> words_of<RevisionStatus>{"unchanged", "kept", "revised", "no_plan",
                                                                          "broken"};

// Where an agent's base ends: that point of its path in the new plan.
struct Decision {
    std::string agent = {};
    std::size_t point = 0;
    double time = 0;
};

// An agent must stop before it gets to that point of its old path, by then.
struct Halt {
    std::string agent = {};
    std::size_t point = 0;
    double by = 0;
};

struct Revision {
    RevisionStatus status = RevisionStatus::unchanged;
    Map map;                               // as it is known now; what was found is laid over
    Mission mission = {};                  // what is left of it
    Plan plan = {};                        // of that, from `now` on
    std::vector<Decision> decisions = {};  // of each agent that is left
    std::vector<Halt> halts = {};          // if broken
};

// Pure: the same arguments, the same revision. `plan` is one of that mission on that map, or a revision of one.
// `reaction`: how long it takes until agents know of the new plan, in units of time; until then they keep to the old
// one. Throws InputError, naming what is wrong, if the state cannot be one of the plan.
[[nodiscard]] Revision revise(Planner& planner, const Map& map, const Mission& mission, const Plan& plan,
                              const State& state, double reaction = 0, const Method& method = {},
                              const Limits& limits = {});

}  // namespace waybreaker
