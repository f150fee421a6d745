// Result: what one job gave, the row that is stored.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waybreaker/map.hpp"
#include "waybreaker/words.hpp"

namespace waybreaker::experiment {

// `timed_out`: the time limit ended it. `failed`: it threw. `crashed`: it took the program down twice.
enum class ResultStatus { solved, no_plan, timed_out, failed, crashed };

}  // namespace waybreaker::experiment

template <>
inline constexpr std::array<std::string_view, 5> waybreaker::words_of<waybreaker::experiment::ResultStatus>{
    "solved", "no plan", "timed out", "failed", "crashed"};

namespace waybreaker::experiment {

// The mission without removal, or as planned. Lengths in cells, makespan and flowtime in units of time. Of a team the
// sums over its agents.
struct Stage {
    std::optional<double> ground;  // length of path A
    std::uint64_t expanded = 0;
    std::uint64_t generated = 0;
    double seconds = 0;  // of the ground search
    double air = 0;      // length of path B
    std::optional<double> makespan;
    std::optional<double> flowtime;
};

struct Result {
    ResultStatus status = ResultStatus::no_plan;
    std::string message = {};  // why it failed
    Stage before = {};
    Stage after = {};
    std::optional<double> bound = {};      // proven: the objective is not below it
    std::optional<double> gap = {};        // objective / bound - 1
    std::vector<ObstacleId> removed = {};  // in flight order
    double seconds = 0;                    // of the whole mission's planning
};

struct Row {
    std::uint64_t job = 0;  // its number in the experiment
    Result result;
};

}  // namespace waybreaker::experiment
