// Outcome: what became of a mission that was played to its end.
#pragma once

#include <span>
#include <vector>

#include "rehearse/actor.hpp"
#include "rehearse/executor.hpp"
#include "waybreaker/revise.hpp"

namespace waybreaker::rehearsal {

// What becomes of a mission whose plan could not be revised.
Ending ending_of(const Revision& revision, std::span<const Actor> actors);

// When who was where, and what was illegal, is added to `result`. `actors`: of the first plan, their trails up to
// `now`, the end.
void sum_up(const Scene& scene, std::vector<Actor> actors, const Events& events, double now, Rehearsed& result);

}  // namespace waybreaker::rehearsal
