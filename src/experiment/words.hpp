// The words that specs and results use for methods and planners.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "experiment/experiment.hpp"
#include "experiment/result.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::experiment {

template <class Value>
struct Word {
    std::string_view word;
    Value value;
};

inline constexpr std::array<Word<Method>, 4> method_words{
    {{"paper", Method::paper}, {"exact", Method::exact}, {"greedy", Method::greedy}, {"none", Method::none}}};

inline constexpr std::array<Word<Planner>, 7> planner_words{{{"theta", Planner::theta},
                                                             {"lazy-theta", Planner::lazy_theta},
                                                             {"astar", Planner::astar},
                                                             {"jps", Planner::jps},
                                                             {"dijkstra", Planner::dijkstra},
                                                             {"bfs", Planner::bfs},
                                                             {"optimal", Planner::optimal}}};

inline constexpr std::array<Word<ResultStatus>, 5> status_words{{{"solved", ResultStatus::solved},
                                                                 {"no plan", ResultStatus::no_plan},
                                                                 {"timed out", ResultStatus::timed_out},
                                                                 {"failed", ResultStatus::failed},
                                                                 {"crashed", ResultStatus::crashed}}};

// The value of a word; throws InputError for a word that is none of them, as a results file from elsewhere may hold.
template <class Value, std::size_t count>
Value value_of(const std::array<Word<Value>, count>& words, std::string_view word) {
    const auto found = std::ranges::find(words, word, &Word<Value>::word);
    if (found == words.end()) throw InputError("the results hold a word that is unknown: '" + std::string(word) + "'");
    return found->value;
}

}  // namespace waybreaker::experiment
