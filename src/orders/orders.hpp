// What waits for what, found from a finished plan alone, so that it can be executed however late anybody is. In the
// literature: a temporal plan graph, or action dependency graph.
#pragma once

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// Fills in Plan::orders. Of each obstacle that a vehicle enters, one: whatever another implies. Of two vehicles whose
// discs could touch, who passes first: those that no other order of the two implies. Laws, of any execution in which
// each agent goes along its path and keeps the orders, with any delays: discs do not overlap by more than
// `order_clearance`; no obstacle is touched before it is breached; nobody waits for ever.
// The plan itself keeps them. Only where two vehicles touch while both move, each step of one needs the other to be a
// step ahead: that order has a slack below 0, by no more than its agent drives in `order_step` cells.
// Orders are of agents whose paths begin at one time. Where timing is ignored obstacles never were there, and there are
// orders of vehicles only. REQUIRES: the plan is solved, and its agents are the mission's. Time O(n log n) for n moves,
// plus O(pairs of moves that come near each other).
void add_orders(const Map& map, const Mission& mission, Plan& plan);

inline constexpr double order_step = 0.25;       // cells
inline constexpr double order_clearance = 1e-8;  // cells

}  // namespace waybreaker
