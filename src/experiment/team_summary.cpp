#include "experiment/team_summary.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace waybreaker::experiment {
namespace {

constexpr double percent = 100;

bool is_solved(const std::optional<Result>& result) {
    return result && result->status == ResultStatus::solved;
}

std::string series_name(const Configuration& one) {
    if (one.method == Method::none) return "no removal";
    return fmt::format("{}, {} {}", to_string(one.method), one.removals, one.removals == 1 ? "removal" : "removals");
}

}  // namespace

void TeamCollector::add(const ExperimentMission& mission, std::span<const std::optional<Result>> row) {
    has_team_ = has_team_ || mission.mission.is_team();
    ++missions_;
    const Size size{mission.count(AgentKind::ground), mission.count(AgentKind::air)};
    const Measures none(team_measure_count, Estimator(places_.count));
    std::vector<Measures>& measures = sizes_.try_emplace(size, row.size(), none).first->second;
    const bool compared = std::ranges::all_of(row, is_solved);
    compared_ += compared ? 1 : 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const std::optional<Result>& result = row[i];
        if (!result) continue;
        const auto add = [&](TeamMeasure measure, double value) {
            measures[i][std::size_t(measure)].add(places_.of_map[mission.map], value);
        };
        add(TeamMeasure::solved, is_solved(result) ? percent : 0);
        if (!compared) continue;
        add(TeamMeasure::seconds, result->seconds);
        if (result->gap) add(TeamMeasure::gap, percent * *result->gap);
        const auto& alone = result->before.flowtime;
        if (alone && *alone > 0) add(TeamMeasure::flowtime, percent * result->after.flowtime.value_or(0) / *alone);
    }
}

TeamSummary TeamCollector::summary() const {
    TeamSummary summary;
    if (!has_team_) return summary;
    summary.missions = missions_;
    summary.compared = compared_;
    for (const Configuration& one : experiment_.configurations) summary.series.push_back({series_name(one)});
    for (const auto& [size, measures] : sizes_) {
        summary.sizes.push_back(fmt::format("{}+{}", size.first, size.second));
        for (std::size_t i = 0; i < measures.size(); ++i) {
            auto& at = summary.series[i].at.emplace_back();
            for (std::size_t m = 0; m < team_measure_count; ++m) {
                const Estimate estimate = measures[i][m].estimate();
                if (estimate.count > 0) at[m] = estimate;
            }
        }
    }
    return summary;
}

}  // namespace waybreaker::experiment
