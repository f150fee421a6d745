// Summary: the numbers that a report shows of a results file.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiment/estimate.hpp"
#include "experiment/results.hpp"
#include "experiment/store.hpp"
#include "experiment/team_summary.hpp"

namespace waybreaker::experiment {

enum class Measure { nodes, search_ms, total_ms, path_a, path_b, flowtime, makespan, bound };
inline constexpr std::size_t measure_count = 8;

// The means of a method, planner and weight, by number of removals.
struct Series {
    Configuration configuration;  // its `removals` does not count
    std::string name;
    // By number of removals, up to the largest of the file; entry 0 is the mission before removal.
    std::vector<std::array<std::optional<Estimate>, measure_count>> at;

    const std::optional<Estimate>& of(Measure measure, std::size_t removals) const {
        return at[removals][std::size_t(measure)];
    }
};

// Makespan and bound are in percent of the straight line from start to goal, searches and totals in milliseconds, all
// else in cells or counts. Every mean is over the same missions: those that every configuration solved, and that have a
// way before removal.
struct SetSummary {
    std::string name;
    std::size_t missions = 0;
    std::size_t compared = 0;  // of them, those the means are over
    std::size_t maps = 0;      // those of the compared missions
    std::size_t places = 0;    // that these maps show
    std::vector<Series> series;
};

struct Summary {
    std::string name;
    std::string version;
    std::string digest;
    std::vector<std::pair<std::string, std::size_t>> statuses;
    Shard shard;              // that has been run; other missions are not in it
    std::size_t missing = 0;  // jobs without a result
    SetSummary all;           // over all sets; without teams
    std::vector<SetSummary> sets;
    std::size_t most_removals = 0;
    TeamSummary teams;
};

Summary summarise(Results& results);

}  // namespace waybreaker::experiment
