#include "experiment/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace waybreaker::experiment {
namespace {

using MissionResults = std::span<const std::optional<Result>>;
using Values = std::array<std::optional<double>, measure_count>;

std::optional<double> percent_of(const std::optional<double>& value, double of) {
    return value ? std::optional(100 * *value / of) : std::nullopt;
}

Values values(const Stage& stage, double straight) {
    Values values;
    values[std::size_t(Measure::nodes)] = double(stage.expanded);
    values[std::size_t(Measure::search_ms)] = 1000 * stage.seconds;
    values[std::size_t(Measure::path_a)] = stage.ground;
    values[std::size_t(Measure::path_b)] = stage.air;
    values[std::size_t(Measure::flowtime)] = stage.flowtime;
    values[std::size_t(Measure::makespan)] = percent_of(stage.makespan, straight);
    return values;
}

Values values(const Result& result, double straight) {
    Values values = experiment::values(result.after, straight);
    values[std::size_t(Measure::total_ms)] = 1000 * result.seconds;
    values[std::size_t(Measure::bound)] = percent_of(result.bound, straight);
    return values;
}

bool comparable(MissionResults row) {
    return std::ranges::all_of(row, [](const std::optional<Result>& result) {
        return result && result->status == ResultStatus::solved && result->before.makespan;
    });
}

std::string name_of(const Configuration& one, bool weights_differ) {
    const Algorithm usual =
        one.method == Method::paper || one.method == Method::none ? Algorithm::theta : Algorithm::optimal;
    std::string name(to_string(one.method));
    if (one.planner != usual) name += fmt::format(", {}", to_string(one.planner));
    if (weights_differ && one.planner != Algorithm::optimal) name += fmt::format(", w = {}", one.weight);
    return name;
}

// Adds up the missions of one set, or of all.
class Collector {
  public:
    Collector(const Experiment& experiment, const Places& places, std::string name)
        : experiment_(experiment), places_(places), name_(std::move(name)) {
        std::set<double> weights;
        for (const Configuration& one : experiment.configurations) {
            weights.insert(one.weight);
            most_ = std::max(most_, std::size_t(one.removals));
        }
        for (const Configuration& one : experiment.configurations) {
            const auto same = [&](const Configuration& other) {
                return other.method == one.method && other.planner == one.planner && other.weight == one.weight;
            };
            const std::size_t series = std::size_t(std::ranges::find_if(series_, same) - series_.begin());
            if (series == series_.size()) {
                series_.push_back(one);
                names_.push_back(name_of(one, weights.size() > 1));
            }
            series_of_.push_back(series);
        }
        const Estimators none(measure_count, Estimator(places.count));
        estimators_.assign(series_.size(), std::vector<Estimators>(most_ + 1, none));
    }

    void add(const ExperimentMission& mission, MissionResults row) {
        ++missions_;
        const double straight = distance(mission.start(), mission.goal());
        if (!comparable(row) || straight == 0) return;
        ++compared_;
        maps_.insert(mission.map);
        const std::size_t place = places_.of_map[mission.map];
        seen_places_.insert(place);
        std::vector<bool> has_before(series_.size(), false);
        for (std::size_t i = 0; i < row.size(); ++i) {
            const auto& result = row[i];
            if (!result) continue;  // not in a comparable row
            const std::size_t removals = std::size_t(experiment_.configurations[i].removals);
            if (!has_before[series_of_[i]]) {
                has_before[series_of_[i]] = true;
                add_values(series_of_[i], 0, place, values(result->before, straight));
            }
            if (removals == 0) {  // what there is to know without removal, a configuration of its own knows
                Values more;
                more[std::size_t(Measure::total_ms)] = 1000 * result->seconds;
                more[std::size_t(Measure::bound)] = percent_of(result->bound, straight);
                add_values(series_of_[i], 0, place, more);
            }
            if (removals > 0) add_values(series_of_[i], removals, place, values(*result, straight));
        }
    }

    std::size_t most_removals() const { return most_; }

    SetSummary summary() const {
        SetSummary summary{name_, missions_, compared_, maps_.size(), seen_places_.size(), {}};
        for (std::size_t i = 0; i < series_.size(); ++i) {
            Series series{series_[i], names_[i], {}};
            for (const Estimators& measures : estimators_[i]) {
                auto& at = series.at.emplace_back();
                for (std::size_t m = 0; m < measure_count; ++m) {
                    const Estimate estimate = measures[m].estimate();
                    if (estimate.count == compared_ && compared_ > 0) at[m] = estimate;
                }
            }
            summary.series.push_back(std::move(series));
        }
        return summary;
    }

  private:
    using Estimators = std::vector<Estimator>;  // by measure

    void add_values(std::size_t series, std::size_t removals, std::size_t place, const Values& given) {
        for (std::size_t m = 0; m < measure_count; ++m) {
            if (const auto& value = given[m]) estimators_[series][removals][m].add(place, *value);
        }
    }

    const Experiment& experiment_;
    const Places& places_;
    std::string name_;
    std::vector<Configuration> series_;
    std::vector<std::string> names_;
    std::vector<std::size_t> series_of_;  // by configuration
    std::size_t most_ = 0;
    std::vector<std::vector<Estimators>> estimators_;  // by series and removals
    std::size_t missions_ = 0;
    std::size_t compared_ = 0;
    std::set<std::uint32_t> maps_;
    std::set<std::size_t> seen_places_;
};

}  // namespace

Summary summarise(Results& results) {
    const Experiment& experiment = results.experiment();
    const Places places = places_of(experiment, results.path());
    Collector all(experiment, places, experiment.name);
    std::vector<Collector> sets;
    for (const std::string& set : experiment.sets) sets.emplace_back(experiment, places, set);
    TeamCollector teams(experiment, places);
    results.for_each_mission([&](const ExperimentMission& mission, MissionResults row) {
        teams.add(mission, row);
        if (mission.mission.is_team()) return;
        all.add(mission, row);
        sets[mission.set].add(mission, row);
    });
    Summary summary{experiment.name,     results.version(), experiment.digest, results.statuses(),
                    results.shard(),     results.missing(), all.summary(),     {},
                    all.most_removals(), teams.summary()};
    for (const Collector& set : sets) summary.sets.push_back(set.summary());
    return summary;
}

}  // namespace waybreaker::experiment
