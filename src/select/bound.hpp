// Bound: what no plan that keeps to the rules is below, and the crossing searches that tell.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "crossing/access.hpp"
#include "select/opening_times.hpp"
#include "select/task.hpp"
#include "waybreaker/advanced/crossing.hpp"

namespace waybreaker {

// What is known of all plans that keep to the rules.
struct Bound {
    double objective = 0;                  // no plan is below it, whatever the agent's radius
    std::vector<ObstacleId> removed = {};  // of the best way that the proof has found: worth a try
    bool limited = false;                  // a limit ended the proof
    bool by_steps = false;                 // it is no lower than what steps prove
};

// Of a point, the air agent on its shortest way. `reached`: the objective of a plan; the bound is never above. A proof
// that a limit ends is a bound as well.
Bound prove_bound(const Task& task, CrossingSearcher& crossing, double reached, const Deadline& deadline);
// `proven`: no plan is below that. `expected`: about what the best path costs, in cells. `expansions`: of the search,
// at most.
Bound prove_bound(const Task& task, CrossingSearcher& crossing, double reached, const Deadline& deadline,
                  OpeningTimes& opening_times, double proven, double expected, std::uint64_t expansions = UINT64_MAX);

// What a path may cost, in cells, that could still lead to an objective. Where obstacles open in time, the cost is the
// whole objective.
double costliest_path(const Task& task, double objective, const OpeningTimes& opening_times);

// No plan with such a path is below.
double least_objective(const Task& task, double path_cost, const OpeningTimes& opening_times);

// `relaxed`: for a lower limit of all paths. The opening times must outlive the options.
CrossingOptions crossing_options(const Task& task, bool relaxed, double objective, double seconds,
                                 OpeningTimes& opening_times);

// What such a search knows of the flights, where obstacles open in time. The opening times must outlive it.
crossing::Opener opener_of(const Task& task, OpeningTimes& opening_times);
// The search itself.
CrossingResult find_path(const Task& task, CrossingSearcher& crossing, const CrossingOptions& options,
                         OpeningTimes& opening_times);
CrossingResult enumerate_paths(const Task& task, CrossingSearcher& crossing, const CrossingOptions& options,
                               OpeningTimes& opening_times, const std::function<bool(const CrossingPath&)>& accept);

// Seconds that are left, or a little more: for a search among few obstacles, which is short.
double a_little_more(const Task& task);

// The shortest path that crosses none but some obstacles: that is quickly found.
CrossingResult find_within(const Task& task, CrossingSearcher& crossing, std::span<const ObstacleId> obstacles,
                           double objective, OpeningTimes& opening_times);

// A path that is at most 15 % longer than the shortest (weighted A*): in a fraction of the time. Not where obstacles
// open in time.
CrossingResult find_good(const Task& task, CrossingSearcher& crossing, double objective, double seconds,
                         OpeningTimes& opening_times);

// The best path if nobody waited but each obstacle that it crosses cost this share of the time that its breach takes.
// None if no breach takes time.
CrossingResult find_priced(const Task& task, CrossingSearcher& crossing, double share, double objective,
                           double seconds);

// How many sets of an enumeration are looked at: a search for each takes long, and so do schedules of many obstacles.
int most_sets(const Task& task);

}  // namespace waybreaker
