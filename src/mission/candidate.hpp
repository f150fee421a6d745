// Candidate: obstacles to remove and the ground path that this opens; every way of selecting hands candidates on.
// Draft: a candidate with the times of both agents, so that candidates can be compared.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/stopwatch.hpp"
#include "waybreaker/planner.hpp"
#include "waybreaker/schedule.hpp"

namespace waybreaker {

// What all steps of a mission's planning work on.
struct Task {
    const Map& map;
    const Agent& driver;
    const Agent& flyer;
    const Rules& rules;
    const Method& method;
    const Limits& limits;
    Deadline deadline;  // of the whole call
    // When the air agent ends at the earliest: straight, or past what must be removed.
    double least_flight;
    bool reports = true;  // its progress

    // The planner that drives the ground agent.
    Planner planner() const { return planner_of(method, driver.body); }
    // When a ground path and a flight end, as the objective counts it.
    double objective(double ground_time, double air_time) const;
    // How many obstacles may be removed beside those that must be.
    int spare_removals() const { return rules.removals - int(rules.force.size()); }
    void report(double best, double bound) const {
        if (reports && limits.progress) limits.progress({best, bound});
    }
    // What must be removed, and others.
    std::vector<ObstacleId> with_forced(std::span<const ObstacleId> others) const;
    // The same mission under other rules, without reports of progress. The rules must outlive it.
    Task under(const Rules& others) const;
};

// The task of a valid mission. The call's time begins now. All arguments must outlive it.
Task task_of(const Map& map, const Mission& mission, const Method& method, const Limits& limits);

// A lower bound of the time that the air agent takes to breach all these, and to get home.
double least_flight_time(const Task& task, std::span<const ObstacleId> removed);

struct Candidate {
    std::vector<ObstacleId> removed;  // each once
    SearchStatus status = SearchStatus::no_path;
    Route ground;
    bool limited = false;  // a limit ended the search: there may be a shorter path
};

// The options of a ground search on cells that ends with the call's time: Theta*, for an agent that goes as the task's
// does, where the task's planner is the optimal one.
SearchOptions cell_search(const Task& task);

// A ground path found by a search on the map without some obstacles.
Candidate candidate_of(std::vector<ObstacleId> removed, const SearchResult& search, double seconds);

struct Draft {
    Candidate candidate;
    Schedule schedule;          // of the air agent alone where there is no ground path
    double flight_seconds = 0;  // what it took to make the schedule
};

// Flies as the options say, with the time that is left to find out how.
Draft draft_of(const Task& task, Candidate candidate);

// The objective; infinity where there is no ground path.
double cost(const Task& task, const Draft& draft);

// The first of the best, gains that are rounding aside; `nothing` removes nothing. Where obstacles do not stand in time
// (the paper), the last draft whatever it costs.
const Draft& best_of(const Task& task, const Draft& nothing, const std::vector<Draft>& drafts);

}  // namespace waybreaker
