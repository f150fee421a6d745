// The words for options, as the command line, plan files and the service write them.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/ros_yaml.hpp"
#include "waybreaker/method.hpp"
#include "waybreaker/plan.hpp"
#include "waybreaker/words.hpp"

namespace waybreaker::io {

template <class Value>
using Words = std::vector<std::pair<std::string, Value>>;

// Those of the library (waybreaker/words.hpp).
template <class Enum>
Words<Enum> all_words() {
    Words<Enum> all;
    for (const std::string_view word : words_of<Enum>) all.emplace_back(word, *from_string<Enum>(word));
    return all;
}

inline const Words<Selection> selection_words = all_words<Selection>();
inline const Words<FlightRule> flight_words = all_words<FlightRule>();
inline const Words<Timing> timing_words = all_words<Timing>();
inline const Words<Objective> objective_words = all_words<Objective>();
inline const Words<Algorithm> planner_words = all_words<Algorithm>();
inline const Words<Heuristic> heuristic_words = all_words<Heuristic>();
inline const Words<TieBreak> tie_break_words = all_words<TieBreak>();
inline const Words<Corners> corner_words = all_words<Corners>();
inline const Words<AgentKind> agent_words = all_words<AgentKind>();
inline const Words<AtGoal> at_goal_words = all_words<AtGoal>();
inline const Words<ZoneKind> zone_words = all_words<ZoneKind>();
inline const Words<PlanStatus> status_words = all_words<PlanStatus>();
inline const Words<WaitReason> wait_words = all_words<WaitReason>();
inline const Words<OrderReason> order_words = all_words<OrderReason>();
inline const Words<RevisionStatus> revision_words = all_words<RevisionStatus>();
inline const Words<Nav2> nav2_words{{"jazzy", Nav2::jazzy}, {"humble", Nav2::humble}};
// The members of plan files that hold what these speak of.
inline const Words<Objective> objective_keys{{"makespan", Objective::makespan},
                                             {"flowtime", Objective::flowtime},
                                             {"ground_makespan", Objective::ground_makespan}};

// Precondition: there is a word for the value.
template <class Value>
std::string_view word_of(const Words<Value>& words, Value value) {
    for (const auto& [word, meaning] : words) {
        if (meaning == value) return word;
    }
    return "";
}

}  // namespace waybreaker::io
