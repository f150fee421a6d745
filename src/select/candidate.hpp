// Candidate: an opening put in time with all agents, so that candidates can be compared.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "drive/opening.hpp"
#include "schedule/joint_schedule.hpp"
#include "select/task.hpp"
#include "waybreaker/advanced/crossing.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// Whether the crossing search drives the ground agent itself, for its body is one that it moves.
bool drives_by_crossing(const Task& task);

struct Candidate {
    Opening opening;
    JointSchedule schedule = {};  // of the aircraft alone where there is no ground path
    double flight_seconds = 0;    // what it took to make the schedule
};

// Flies as the method says, with the time that is left to find out how. What the ground path does without stands again,
// but for what must be removed; not where obstacles do not stand in time (the paper).
Candidate candidate_of(const Task& task, Opening opening);

// Of the set that is needed in the end, with that set's own path.
Candidate candidate_of_needed(const Task& task, const Searchers& searchers, Opening opening);

// The same set; where the path leads through what opens late by itself, the best of that and of paths around the one
// that is waited for longest, then around that and the next, and so on.
Candidate around_late_openings(const Task& task, const Searchers& searchers, Candidate through);

// The objective; infinity where there is no ground path.
double cost(const Task& task, const Candidate& candidate);

// The first of the best, gains that are rounding aside; `start` removes nothing but what must be. By hits, where
// obstacles do not stand in time (the paper): the last candidate whatever it costs.
const Candidate& best_of(const Task& task, const Candidate& start, const std::vector<Candidate>& candidates);

}  // namespace waybreaker
