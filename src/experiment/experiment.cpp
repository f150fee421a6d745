#include "experiment/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

#include "core/byte_order_mark.hpp"
#include "experiment/document.hpp"
#include "experiment/places.hpp"
#include "experiment/spec.hpp"
#include "io/map_file.hpp"
#include "io/mission_json.hpp"
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
        text += fmt::format("configuration {} {} {} {}\n", to_string(one.method), to_string(one.planner), one.weight,
                            one.removals);
    }
    for (const std::string& set : experiment.sets) text += fmt::format("set {}\n", set);
    for (const ExperimentMap& map : experiment.maps) text += fmt::format("map {}\n", map.digest);
    for (const ExperimentMission& one : experiment.missions) {
        text += fmt::format("mission {} {} {}\n", one.set, one.map, document_of(one.mission));
    }
    return text;
}

// Teams are planned in one way, if at all.
void require_plannable(const Experiment& experiment, const std::string& spec) {
    const auto is_team = [](const ExperimentMission& one) { return one.mission.is_team(); };
    if (std::ranges::none_of(experiment.missions, is_team)) return;
    for (const Configuration& one : experiment.configurations) {
        const bool usual = one == Configuration{Method::exact, Algorithm::optimal, 1, one.removals} ||
                           one == Configuration{Method::none, Algorithm::theta, 1, 0};
        if (usual) continue;
        throw InputError(spec, 0,
                         "teams are planned by exact and none, without planners and weights: give a spec of its own to "
                         "the rest");
    }
}

// Adds the missions of a file, and the maps that were not there yet.
class MissionReader {
  public:
    explicit MissionReader(Experiment& experiment) : experiment_(experiment) {}

    void add(const std::string& path) {
        const std::uint32_t set = std::uint32_t(experiment_.sets.size());
        experiment_.sets.push_back(fs::path(path).stem().string());
        const std::string text(without_byte_order_mark(io::read_whole(path)));
        if (text.starts_with('{')) {
            add_documents(text, path, set);
        } else {
            add_scenarios(text, path, set);
        }
    }

  private:
    void add_scenarios(const std::string& text, const std::string& path, std::uint32_t set) {
        for (const Scenario& scenario : read_movingai_scenarios(text, path)) {
            const std::uint32_t index = map_of(scenario.map, path);
            ExperimentMap& map = experiment_.maps[index];
            if (map.width == 0) {
                map.width = scenario.width;
                map.height = scenario.height;
            }
            if (scenario.width != map.width || scenario.height != map.height) {
                throw InputError(path, 0, fmt::format("gives {} two sizes", scenario.map));
            }
            experiment_.missions.push_back(
                {set, index, ground_and_air(scenario.start, scenario.goal), scenario.optimal_length});
        }
    }

    // A mission document on each line.
    void add_documents(const std::string& text, const std::string& path, std::uint32_t set) {
        std::istringstream lines(text);
        std::size_t number = 0;
        for (std::string line; std::getline(lines, line);) {
            ++number;
            const auto refuse = [&](const std::string& why) { throw InputError(path, number, why); };
            if (line.empty()) continue;
            io::MissionDocument document = io::parse_mission(line, fmt::format("{}, line {}", path, number));
            if (document.map.empty()) refuse("does not say its map");
            if (!document.overlays.empty()) {
                refuse("has overlays; name a map that has them already, as 'waybreaker map overlay' writes it");
            }
            if (document.area_budget)
                refuse("budget_m2 is not for experiments; weigh the map's obstacles and give budget");
            if (std::ranges::count(document.mission.agents, AgentKind::ground, &Agent::kind) == 0) {
                refuse("has no ground agent");
            }
            const std::uint32_t index = map_of(document.map, path);
            if (experiment_.maps[index].width == 0 || !document.protect_tags.empty() ||
                !document.can_breach_tags.empty()) {
                const io::MapFile file = mapfile::read_map_file(experiment_.maps[index].path);
                experiment_.maps[index].width = file.map.width();
                experiment_.maps[index].height = file.map.height();
                io::resolve(document, file);
            }
            experiment_.missions.push_back({set, index, std::move(document.mission), std::nullopt});
        }
    }

    // A map of no size yet, if it is new.
    std::uint32_t map_of(const std::string& name, const std::string& from) {
        const std::string path = (fs::path(from).parent_path() / name).lexically_normal().string();
        const auto [entry, is_new] = known_.try_emplace(path, std::uint32_t(experiment_.maps.size()));
        if (is_new) {
            experiment_.maps.push_back(
                {fs::path(path).filename().string(), path, mapfile::read_map_file(path).digest, 0, 0});
        }
        return entry->second;
    }

    Experiment& experiment_;
    std::map<std::string, std::uint32_t> known_;  // by path
};

}  // namespace

std::size_t ExperimentMission::count(AgentKind kind) const {
    return std::size_t(std::ranges::count(mission.agents, kind, &Agent::kind));
}

Experiment read_experiment(const std::string& spec_path) {
    Experiment experiment;
    experiment.spec = io::read_whole(spec_path);
    Spec spec = parse_spec(experiment.spec, spec_path);
    experiment.name = std::move(spec.name);
    experiment.time_limit = spec.time_limit;
    experiment.places = std::move(spec.places);
    experiment.configurations = std::move(spec.configurations);
    MissionReader missions(experiment);
    for (const std::string& file : spec.missions) missions.add((fs::path(spec_path).parent_path() / file).string());
    if (experiment.missions.empty()) throw InputError(spec_path, 0, "its files hold no mission");
    require_plannable(experiment, spec_path);
    places_of(experiment, spec_path);
    experiment.digest = mapfile::sha256_digest(canonical(experiment));
    return experiment;
}

}  // namespace waybreaker::experiment
