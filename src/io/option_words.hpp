// The words for options, as the command line, plan files and the service write them.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/ros_yaml.hpp"
#include "waybreaker/method.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::io {

template <class Value>
using Words = std::vector<std::pair<std::string, Value>>;

inline const Words<Selection> selection_words{
    {"exact", Selection::exact}, {"hits", Selection::hits}, {"greedy", Selection::greedy}, {"none", Selection::none}};
inline const Words<FlightRule> flight_words{{"optimal", FlightRule::optimal}, {"nearest", FlightRule::nearest}};
inline const Words<Timing> timing_words{{"enforce", Timing::enforce}, {"ignore", Timing::ignore}};
inline const Words<Objective> objective_words{{"makespan", Objective::makespan},
                                              {"flowtime", Objective::flowtime},
                                              {"ground-makespan", Objective::ground_makespan}};
// The members of plan files that hold what these speak of.
inline const Words<Objective> objective_keys{{"makespan", Objective::makespan},
                                             {"flowtime", Objective::flowtime},
                                             {"ground_makespan", Objective::ground_makespan}};
inline const Words<Planner> planner_words{{"theta", Planner::theta},       {"lazy-theta", Planner::lazy_theta},
                                          {"astar", Planner::astar},       {"jps", Planner::jps},
                                          {"dijkstra", Planner::dijkstra}, {"bfs", Planner::bfs},
                                          {"optimal", Planner::optimal}};
inline const Words<Heuristic> heuristic_words{{"euclidean", Heuristic::euclidean},
                                              {"octile", Heuristic::octile},
                                              {"chebyshev", Heuristic::chebyshev},
                                              {"manhattan", Heuristic::manhattan},
                                              {"zero", Heuristic::zero}};
inline const Words<TieBreak> tie_break_words{{"g-max", TieBreak::g_max}, {"g-min", TieBreak::g_min}};
inline const Words<Corners> corner_words{{"none", Corners::none}, {"cut", Corners::cut}, {"squeeze", Corners::squeeze}};
inline const Words<AgentKind> agent_words{{"ground", AgentKind::ground}, {"air", AgentKind::air}};
inline const Words<AtGoal> at_goal_words{{"stay", AtGoal::stay}, {"leave", AtGoal::leave}};
inline const Words<Nav2> nav2_words{{"jazzy", Nav2::jazzy}, {"humble", Nav2::humble}};
inline const Words<PlanStatus> status_words{{"solved", PlanStatus::solved},
                                            {"no_plan", PlanStatus::no_plan},
                                            {"not_found", PlanStatus::not_found},
                                            {"limit_reached", PlanStatus::limit_reached},
                                            {"stopped", PlanStatus::stopped}};
inline const Words<WaitReason> wait_words{{"nothing", WaitReason::nothing},
                                          {"readiness", WaitReason::readiness},
                                          {"opening", WaitReason::opening},
                                          {"agent", WaitReason::agent}};

// Precondition: there is a word for the value.
template <class Value>
std::string_view word_of(const Words<Value>& words, Value value) {
    for (const auto& [word, meaning] : words) {
        if (meaning == value) return word;
    }
    return "";
}

}  // namespace waybreaker::io
