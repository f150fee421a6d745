// Who passes first where two vehicles could touch.
#pragma once

#include <cstddef>
#include <vector>

#include "orders/track.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::orders {

// A vehicle with all its moves.
struct Track {
    double radius = 0;
    std::vector<Stretch> stretches;
};

// Where two vehicles touch while both move, no number of orders is enough: some step has to be the last.
struct Precision {
    double step = 0;    // of the second, in cells, at least
    bool kept = false;  // by the plan all the same: then two discs may overlap by a step
};

// Two moves of two vehicles that may come near each other, and how near they may not come.
struct Pair {
    const Stretch* one = nullptr;
    const Stretch* other = nullptr;
    double reach = 0;
};

// All that do not lie apart by their bounds.
std::vector<Pair> near_pairs(const std::vector<Track>& tracks, double separation);

// Adds the orders of two moves: none where they do not touch, wherever they are.
void add_passing_orders(const Pair& pair, const Precision& precision, std::vector<Order>& orders);

// Leaves those that no other order of the same two agents implies, sorted by agents and `after`.
void leave_out_implied(std::vector<Order>& orders);

// The agents that would wait for ever if all kept the orders: those of a cycle, and who waits for them; by agent.
std::vector<bool> stuck_agents(const std::vector<Order>& orders, std::size_t agents);

}  // namespace waybreaker::orders
