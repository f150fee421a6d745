// Tuning: every constant of this folder that was chosen by measurement (bench_coalition). None changes what a plan or a
// bound means: larger limits take longer, and find better plans and bounds.
//
// Units: a share is relative; an expansion is a label taken from the open list of a crossing search.
#pragma once

#include <cstddef>
#include <cstdint>

namespace waybreaker::coalition::tuning {

// Steps of a planning (coalition.cpp, collision_free.cpp).

// Share of the time that is left, for the choice of sets; the rest is for paths past each other.
inline constexpr double share_of_choice = 0.6;
// The same where vehicles do not collide: then there is hardly anything else to do.
inline constexpr double share_of_choice_without_collisions = 0.95;
// Sets that vehicles are planned past each other for, beside "remove nothing", where the choice is exact: the next one
// may still be better, for its value leaves out collisions.
inline constexpr std::size_t most_collision_free = 4;
// Share of the objective, and share of what is not proven, that vehicles may lose to each other before their paths are
// improved: less than that is lost to the choice of sets anyway.
inline constexpr double tolerable_loss = 2e-4;
inline constexpr double tolerable_part_of_gap = 0.05;

// The exact choice (exact_choice.cpp). Gaps are shares of the bound.

// Rounds of prices and searches; most end before, for a round gains too little.
inline constexpr int most_price_rounds = 12;
// Share of the gap: when a round gains less, no other follows.
inline constexpr double least_gain_of_round = 0.1;
// Prices aim at the incumbent, but no farther above the bound than this factor, while there is none or a bad one.
inline constexpr double farthest_aim = 1.1;
// Gap at which prices are good enough, and sets are compared one by one.
inline constexpr double gap_for_prices = 6e-3;
// Gap above which sets are looked for that only the vehicles' own bodies need.
inline constexpr double gap_for_own_bodies = 5e-3;
// Gap above which the planner of one vehicle plans the one that decides, as if it were the only one.
inline constexpr double gap_for_own_mission = 2e-3;
// Of a sum: where that vehicle has at least this share of what all vehicles may gain.
inline constexpr double least_share_of_own_mission = 0.5;
// Gap at which the choice ends.
inline constexpr double gap_of_choice = 1e-3;
// Share of the incumbent: columns that cost up to so much more than the best are enumerated for branch and bound.
inline constexpr double margin_of_enumeration = 4e-3;
// Sets of branch and bound, one after the other, that do not improve the incumbent.
inline constexpr int most_sets_without_gain = 4;
// All sets are evaluated if they are no more, until so much effort is spent (Ways::effort).
inline constexpr std::size_t most_sets_evaluated = 128;
// The same while no set has led to a plan.
inline constexpr std::size_t most_sets_without_plan = 4096;
inline constexpr std::uint64_t most_effort_for_all_sets = 100'000;

// Pricing problems (columns.cpp, greedy.cpp). Larger limits raise the bound a little, and take longer on maps with
// thousands of obstacles.

// Columns that one enumeration adds, and expansions of one search: most end long before.
inline constexpr int most_columns_of_enumeration = 64;
inline constexpr std::uint64_t most_pricing_expansions = 6'000;
// Expansions of the first search in time of a vehicle, and of the later ones: they only sharpen what a search without
// times has proven.
inline constexpr std::uint64_t most_first_expansions_in_time = 5'000;
inline constexpr std::uint64_t most_pricing_expansions_in_time = 1'500;
// Expansions of the first searches of all vehicles together, where these never collide.
inline constexpr std::uint64_t most_first_expansions_of_all = 240'000;
// Vehicles that never collide: of more, searches heed when obstacles open only when prices gain no more without.
inline constexpr std::size_t most_vehicles_in_time_at_first = 10;
// Share of the best column's cost: no enumeration goes farther.
inline constexpr double most_margin = 0.03;
// For the vehicles' own bodies the best sets of up to so many obstacles are found, and the best of as many as may be.
inline constexpr int most_sizes_of_own_body = 3;
// Obstacles, and expansions, of a vehicle's search in one greedy step.
inline constexpr std::size_t most_greedy_obstacles = 256;
inline constexpr std::uint64_t most_greedy_expansions = 20'000;

// Prices: subgradient steps on the known columns (relaxation.cpp).

// Steps between two rounds of searches.
inline constexpr int most_subgradient_steps = 300;
// Steps without gain before the step length is halved, and share of the first length at which they end.
inline constexpr int steps_before_halving = 12;
inline constexpr double least_step_length = 1e-4;
// Share of the incumbent, times that of the step length: less is no gain.
inline constexpr double least_gain_of_step = 1e-6;
// Prices are proven this far from the stability centre towards the best on the known columns (Wentges smoothing).
inline constexpr double smoothing = 0.7;
// Share of the incumbent, over all vehicles: columns that cost up to so much more than the best are added in each round
// of few vehicles. Of more vehicles one column hardly matters to the sum.
inline constexpr double margin_of_round = 1e-3;
inline constexpr std::size_t most_vehicles_with_margin = 20;
// A vehicle of less weight is left out of the maximum.
inline constexpr double least_weight_of_vehicle = 1e-6;

// Branch and bound (joint.cpp).

// Nodes that are expanded.
inline constexpr int most_nodes = 2000;

// Evaluation of a set (sorties.cpp, ways.cpp).

// Up to so many obstacles all orders are tried in which the aircraft may breach them.
inline constexpr std::size_t most_targets_in_all_orders = 4;
// Rounds of paths for the times of sorties, and sorties for these paths.
inline constexpr int most_evaluation_rounds = 4;
// Paths of a vehicle for one set.
inline constexpr std::size_t most_paths = 16;
// Expansions of a search for these, and of one in time.
inline constexpr std::uint64_t most_path_expansions = 20'000;
inline constexpr std::uint64_t most_path_expansions_in_time = 2'000;
// Known paths that are bent to come later.
inline constexpr std::size_t most_bent_paths = 3;
// Effort of one expansion, where that of one judged path is 1: they take about as long.
inline constexpr std::uint64_t effort_of_expansion = 8;

}  // namespace waybreaker::coalition::tuning
