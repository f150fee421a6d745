// Experiment: which missions are planned how. Read from a spec, a TOML file:
//
//     name = "The paper's section 4"
//     missions = ["cities.scen"]     # MovingAI scenario files, or lines of mission documents; they name their maps
//     time_limit = 60                # seconds for one mission; this is the default
//     places = ["berlin-*"]          # maps that show one place; * stands for any text
//
//     [[run]]                        # as often as one likes; lists are multiplied
//     methods = ["paper"]            # paper, exact, greedy, none
//     planners = ["theta"]
//     weights = [1, 2]
//     removals = [1, 2, 3, 4, 5]
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waybreaker/method.hpp"
#include "waybreaker/words.hpp"

namespace waybreaker::experiment {

// paper: the hits of its section 3. exact: the proven choice. greedy: again and again the obstacle whose removal
// shortens the ground path most. none: the mission without removal.
enum class Method { paper, exact, greedy, none };

}  // namespace waybreaker::experiment

template <>
inline constexpr std::array<std::string_view, 4> waybreaker::words_of<waybreaker::experiment::Method>{"paper", "exact",
                                                                                                      "greedy", "none"};

namespace waybreaker::experiment {

struct Configuration {
    Method method = Method::exact;
    Algorithm planner = Algorithm::optimal;
    double weight = 1;
    int removals = 0;
    friend bool operator==(const Configuration&, const Configuration&) = default;
};

struct ExperimentMap {
    std::string name;  // without folders
    std::string path;
    std::string digest;  // "sha256:..." as io::MapFile has it
    int width = 0;
    int height = 0;
};

struct ExperimentMission {
    std::uint32_t set = 0;  // of Experiment::sets: the file it comes from
    std::uint32_t map = 0;  // of Experiment::maps
    // Who and by which rules; a configuration says how many obstacles may be removed.
    Mission mission;
    std::optional<double> octile = {};  // length of the optimal octile path, as a scenario file says

    // Of the first ground agent.
    Cell start() const { return mission.first(AgentKind::ground).start; }
    Cell goal() const { return mission.first(AgentKind::ground).goal; }
    std::size_t count(AgentKind kind) const;
};

// Every mission is planned in every configuration; that is a job. Jobs are numbered mission by mission.
struct Experiment {
    std::string name;
    std::string spec;  // its text
    double time_limit = 60;
    std::vector<std::string> places;  // patterns of map names: maps that one fits are of one place (places.hpp)
    std::vector<std::string> sets;
    std::vector<ExperimentMap> maps;
    std::vector<ExperimentMission> missions;
    std::vector<Configuration> configurations;
    std::string digest;  // of all that decides the results: equal experiments have equal digests

    std::size_t job_count() const { return missions.size() * configurations.size(); }
};

// Reads a spec and the files of missions it names; maps are found from these files' folder, and are only digested here.
// Throws InputError with file and line.
Experiment read_experiment(const std::string& spec_path);

}  // namespace waybreaker::experiment
