// Rehearse: a plan played many times, with breaches that fail, agents that are late, streets that turn out to be
// blocked and aircraft that are lost. How likely is it that the plan holds?
//
//     Rehearsal rehearsal = rehearse(map, mission, plan, {.fail = 0.1, .runs = 10'000});
//     rehearsal.makespan.p95;   // 95 of 100 missions are over by then
//
// Agents keep to the plan's orders, not to its times: each goes on as early as those allow. Only agents for whom a zone
// holds for a time go on no earlier than planned; late ones look ahead whether they would be in one that holds.
// Whenever that is so, or something has happened that makes the plan another one, it is revised (revise.hpp), and they
// go on with that. The executor judges by geometry of its own, and counts what no execution may have: discs that
// overlap, bodies in obstacles that stand, and agents in zones.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "waybreaker/limits.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/method.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"
#include "waybreaker/words.hpp"

namespace waybreaker {

// How late an agent leaves for the next point of its path, each time that it moves on: `fixed`: always that;
// `exponential`: that on average, most often less; `poisson`: a whole number of units of time, that on average.
enum class DelayKind { fixed, exponential, poisson };
template <>
inline constexpr std::array<std::string_view, 3> words_of<DelayKind>{"fixed", "exponential", "poisson"};

struct Delay {
    DelayKind kind = DelayKind::exponential;
    double mean = 0;  // units of time, 0 to most_delay
};
inline constexpr double most_delay = 1000;

struct RehearsalOptions {
    double fail = 0;  // the chance that a breach leaves the obstacle standing, known when it ends
    Delay delay = {};
    // The chance that a vehicle meets a blocked street, once. Where: when it has driven a share of the length of its
    // first path, all shares equally likely, what lies `sight` ahead of it on its path turns out to be blocked, three
    // cells wide. Nothing happens where its path ends before, or where the cells are a vehicle's place or a goal.
    double blocked = 0;
    double sight = 10;  // cells, least_sight to 1000
    // The chance that an aircraft is lost: when it has flown a share of the length of its first flight, likewise. One
    // is lost as well when its battery is empty, reserve and all, or would be before it is home.
    double lost = 0;
    int runs = 1000;
    std::uint64_t seed = 1;
    unsigned threads = 0;  // 0: all cores
    // Called after each run with how many are done, on the thread that has done it; by several at a time.
    std::function<void(int)> progress = {};
};
inline constexpr double least_sight = 3;
inline constexpr int most_runs = 10'000'000;

// How a mission ended. `arrived`: all vehicles are at their goals, or count as not reached; `no_way`: the plan could
// not be revised, there is none any more; `not_found`: a plan may exist, and none was found; `broken`: a vehicle was
// bound to meet what is in its way; `stuck`: everybody waits for somebody.
enum class Ending { arrived, no_way, not_found, broken, stuck };
template <>
inline constexpr std::array<std::string_view, 5> words_of<Ending>{"arrived", "no_way", "not_found", "broken", "stuck"};

struct Rehearsed {
    Ending ending = Ending::arrived;
    // When the last agent that was not lost got to its goal, and the last vehicle; where it ended otherwise, when that
    // was.
    double makespan = 0;
    double ground_makespan = 0;
    double flowtime = 0;     // the weighted sum over all agents that were not lost
    int unreached = 0;       // vehicles that were not at their goals by Rules::unreached, and count as if then
    int failed = 0;          // breaches
    int blocked = 0;         // streets
    int lost = 0;            // aircraft
    int on_reserve = 0;      // landings on what was to be kept in reserve
    int emptied = 0;         // aircraft whose battery did not bring them home
    int caught = 0;          // agents, late in a zone, that were still there when it began to hold
    int revisions = 0;       // plans made, whether others came out of it or not
    int illegal = 0;         // pairs of vehicles that overlapped, vehicles in what stood, agents in zones: each once
    std::string fault = {};  // the first of these, for a person
    friend bool operator==(const Rehearsed&, const Rehearsed&) = default;
};

// Of the runs that arrived; 0 where none did.
struct Spread {
    double mean = 0;
    double median = 0;
    double p95 = 0;
    double worst = 0;
};

struct Rehearsal {
    std::vector<Rehearsed> runs = {};
    int arrived = 0;
    int illegal = 0;     // runs
    int on_reserve = 0;  // runs in which an aircraft landed on its reserve
    int emptied = 0;     // runs in which the battery of one did not bring it home
    int caught = 0;      // runs in which an agent was still in a zone when that began to hold
    double planned = 0;
    double ground_planned = 0;
    double flowtime_planned = 0;
    int unreached_planned = 0;  // vehicles
    Spread makespan = {};
    Spread ground_makespan = {};
    Spread flowtime = {};
    double unreached = 0;                // vehicles, on average over the runs that arrived
    double revisions = 0;                // on average over all runs
    std::vector<double> revise_ms = {};  // how long each revision took, in rising order
};

// The same for the same arguments, whatever the number of threads, but for `revise_ms`: run i is drawn from the seed
// and i alone, and what happens to an agent or an obstacle from its number besides, so that two plans of one mission
// can be compared. `limits` and `method` are those of revisions; time limits can make runs differ. Throws InputError if
// the plan is not solved or not the mission's, or an option is out of range.
[[nodiscard]] Rehearsal rehearse(const Map& map, const Mission& mission, const Plan& plan,
                                 const RehearsalOptions& options = {}, const Method& method = {},
                                 const Limits& limits = {});

// Of what the objective counts.
[[nodiscard]] const Spread& spread_by(const Rehearsal& rehearsal, Objective objective);

// Of rehearsals of plans of one mission on the same draws, the place of the one to prefer: the most runs arrive; of
// those, the mean of the objective is the least; of those, the first.
//
//     std::vector<Rehearsal> rehearsals;
//     for (const Plan& plan : planner.alternatives(map, mission, 0.01))
//         rehearsals.push_back(rehearse(map, mission, plan, {.fail = 0.1}));
//     most_robust(rehearsals, mission.rules.objective);
//
// REQUIRES: there is one, and all have as many runs.
[[nodiscard]] std::size_t most_robust(std::span<const Rehearsal> rehearsals, Objective objective);

// The share'th smallest of values in rising order (nearest rank); 0 of none.
[[nodiscard]] double quantile(const std::vector<double>& rising, double share);

}  // namespace waybreaker
