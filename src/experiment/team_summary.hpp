// Team summary: what teams reach, by their size.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "experiment/estimate.hpp"
#include "experiment/places.hpp"
#include "experiment/results.hpp"

namespace waybreaker::experiment {

// solved: percent of all missions of that size. The others are means over those of them that every configuration
// solved: the proven gap in percent, seconds of planning, and the flowtime in percent of that of all agents alone
// without removal (of the missions where each has a way then).
enum class TeamMeasure { solved, gap, seconds, flowtime };
inline constexpr std::size_t team_measure_count = 4;

struct TeamSeries {
    std::string name;                                                              // of a configuration
    std::vector<std::array<std::optional<Estimate>, team_measure_count>> at = {};  // by size

    const std::optional<Estimate>& of(TeamMeasure measure, std::size_t size) const {
        return at[size][std::size_t(measure)];
    }
};

struct TeamSummary {
    std::vector<std::string> sizes;  // "5+2" is five vehicles and two aircraft; from small to large
    std::size_t missions = 0;
    std::size_t compared = 0;  // of them, those that every configuration solved
    std::vector<TeamSeries> series;
};

// Adds up missions, teams and pairs.
class TeamCollector {
  public:
    TeamCollector(const Experiment& experiment, const Places& places) : experiment_(experiment), places_(places) {}

    void add(const ExperimentMission& mission, std::span<const std::optional<Result>> row);
    // Empty if there was no team.
    TeamSummary summary() const;

  private:
    using Size = std::pair<std::size_t, std::size_t>;  // vehicles, aircraft
    using Measures = std::vector<Estimator>;           // by measure

    const Experiment& experiment_;
    const Places& places_;
    std::map<Size, std::vector<Measures>> sizes_;  // by configuration
    std::size_t missions_ = 0;
    std::size_t compared_ = 0;
    bool has_team_ = false;
};

}  // namespace waybreaker::experiment
