// Outcome: what became of a mission that was played to its end.
#pragma once

#include <vector>

#include "rehearse/actor.hpp"
#include "rehearse/executor.hpp"

namespace waybreaker::rehearsal {

// When who was where, and what was illegal, is added to `result`. `actors`: of the first plan, their trails up to
// `now`, the end.
void sum_up(const Scene& scene, std::vector<Actor> actors, const Events& events, double now, Rehearsed& result);

}  // namespace waybreaker::rehearsal
