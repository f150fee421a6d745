#include "experiment/experiment.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "experiment/spec.hpp"
#include "io/map_file.hpp"
#include "io/output_file.hpp"
#include "mapfile/digest.hpp"
#include "mapfile/map_reader.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/movingai.hpp"

namespace waybreaker::experiment {
namespace {

namespace fs = std::filesystem;

// What results depend on, as text. File names do not count, except those of the sets that the report distinguishes.
std::string canonical(const Experiment& experiment) {
    std::string text = fmt::format("waybreaker-experiment/1\ntime_limit {}\n", experiment.time_limit);
    for (const Configuration& one : experiment.configurations) {
        text += fmt::format("configuration {} {} {} {}\n", word_for(one.method), word_for(one.planner), one.weight,
                            one.removals);
    }
    for (const std::string& set : experiment.sets) text += fmt::format("set {}\n", set);
    for (const ExperimentMap& map : experiment.maps) text += fmt::format("map {}\n", map.digest);
    for (const ExperimentMission& one : experiment.missions) {
        text += fmt::format("mission {} {} {} {} {} {}\n", one.set, one.map, one.start.x, one.start.y, one.goal.x,
                            one.goal.y);
    }
    return text;
}

// Adds the missions of a scenario file, and the maps that were not there yet.
class MissionReader {
  public:
    explicit MissionReader(Experiment& experiment) : experiment_(experiment) {}

    void add(const std::string& path) {
        const std::uint32_t set = std::uint32_t(experiment_.sets.size());
        experiment_.sets.push_back(fs::path(path).stem().string());
        for (const Scenario& scenario : read_movingai_scenarios(io::read_whole(path), path)) {
            const std::uint32_t map = map_of(scenario, path);
            experiment_.missions.push_back({set, map, scenario.start, scenario.goal, scenario.optimal_length});
        }
    }

  private:
    std::uint32_t map_of(const Scenario& scenario, const std::string& scenario_file) {
        const std::string path = (fs::path(scenario_file).parent_path() / scenario.map).lexically_normal().string();
        const auto [entry, is_new] = known_.try_emplace(path, std::uint32_t(experiment_.maps.size()));
        if (is_new) {
            experiment_.maps.push_back({fs::path(path).filename().string(), path, mapfile::read_map_file(path).digest,
                                        scenario.width, scenario.height});
        }
        const ExperimentMap& map = experiment_.maps[entry->second];
        if (scenario.width != map.width || scenario.height != map.height) {
            throw InputError(scenario_file, 0, fmt::format("gives {} two sizes", scenario.map));
        }
        return entry->second;
    }

    Experiment& experiment_;
    std::map<std::string, std::uint32_t> known_;  // by path
};

}  // namespace

Experiment read_experiment(const std::string& spec_path) {
    Experiment experiment;
    experiment.spec = io::read_whole(spec_path);
    Spec spec = parse_spec(experiment.spec, spec_path);
    experiment.name = std::move(spec.name);
    experiment.time_limit = spec.time_limit;
    experiment.configurations = std::move(spec.configurations);
    MissionReader missions(experiment);
    for (const std::string& file : spec.missions) missions.add((fs::path(spec_path).parent_path() / file).string());
    if (experiment.missions.empty()) throw InputError(spec_path, 0, "its scenario files hold no mission");
    experiment.digest = mapfile::sha256_digest(canonical(experiment));
    return experiment;
}

}  // namespace waybreaker::experiment
