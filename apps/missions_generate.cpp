// `waybreaker missions generate`: the missions of an experiment, drawn as the paper draws them.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "commands.hpp"
#include "core/parallel.hpp"
#include "experiment/document.hpp"
#include "experiment/missions.hpp"
#include "help.hpp"
#include "io/excerpt.hpp"
#include "io/map_file.hpp"
#include "io/option_words.hpp"
#include "io/output_file.hpp"
#include "mapfile/map_reader.hpp"
#include "named_files.hpp"
#include "option.hpp"
#include "progress.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

namespace fs = std::filesystem;

struct MissionsGenerateOptions {
    std::vector<std::string> maps;
    std::string output;
    std::optional<double> min_distance;
    experiment::MissionRules rules;
    std::optional<experiment::TeamSize> team;
    std::optional<Objective> objective;
};

// "5+2"
experiment::TeamSize team_size(const std::string& given) {
    experiment::TeamSize size;
    const char* const end = given.data() + given.size();
    const auto vehicles = std::from_chars(given.data(), end, size.vehicles);
    const bool joined = vehicles.ec == std::errc() && vehicles.ptr != end && *vehicles.ptr == '+';
    const auto aircraft = joined ? std::from_chars(vehicles.ptr + 1, end, size.aircraft) : vehicles;
    const int most = int(most_agents) / 2;
    if (!joined || aircraft.ec != std::errc() || aircraft.ptr != end || size.vehicles < 1 || size.vehicles > most ||
        size.aircraft < 0 || size.aircraft > most) {
        throw CLI::ValidationError(
            "--team", fmt::format("'{}' is no team: K+M are vehicles and aircraft, such as 5+2", shown(given)));
    }
    return size;
}

// As seen from the scenario file, so that the two can be moved together.
std::string name_of(const std::string& map, const std::string& scenarios) {
    if (scenarios == "-") return map;
    return fs::proximate(map, fs::absolute(scenarios).parent_path()).generic_string();
}

// Of one map.
struct Drawn {
    experiment::DrawnMissions missions;
    std::string teams = {};  // a document on each line
    std::size_t team_count = 0;
};

Drawn draw(const std::string& path, const MissionsGenerateOptions& options) {
    const io::MapFile file = mapfile::read_map_file(path);
    try {
        experiment::DrawnMissions missions = experiment::draw_missions(file.map, options.rules);
        for (Scenario& scenario : missions.kept) scenario.map = name_of(path, options.output);
        Drawn drawn{std::move(missions)};
        if (!options.team) return drawn;
        Rules rules;
        rules.objective = options.objective.value_or(rules.objective);
        for (const Mission& team : experiment::teams_of(file.map, drawn.missions.kept, *options.team, rules)) {
            drawn.teams += experiment::document_of(team, name_of(path, options.output)) + "\n";
            ++drawn.team_count;
        }
        return drawn;
    } catch (const InputError& error) {
        throw InputError(path, 0, error.what());
    }
}

void run(const MissionsGenerateOptions& options) {
    if (options.objective && !options.team) throw InputError("--objective is for --team: scenario files have none");
    NamedFiles maps;
    for (const std::string& map : options.maps) {
        const bool is_named = std::ranges::find(maps, map, &NamedFiles::value_type::second) != maps.end();
        if (is_named) throw InputError(fmt::format("{} is named twice", io::excerpt(map)));
        maps.emplace_back("MAP", map);
    }
    require_ending(
        "--output", options.output,
        options.team ? std::vector<std::string_view>{".jsonl", ".json"} : std::vector<std::string_view>{".scen"});
    keep_inputs({{"--output", options.output}}, maps);
    std::vector<Drawn> of_map(options.maps.size());
    {
        const Progress progress(fmt::format("drawing missions on {} maps", options.maps.size()));
        for_each_index(options.maps.size(), 0,
                       [&](std::size_t i, std::size_t) { of_map[i] = draw(options.maps[i], options); });
    }
    experiment::DrawnMissions all;
    std::string teams;
    std::size_t team_count = 0;
    for (const auto& [missions, of_teams, count] : of_map) {
        teams += of_teams;
        team_count += count;
        all.kept.insert(all.kept.end(), missions.kept.begin(), missions.kept.end());
        all.drawn += missions.drawn;
        all.without_way += missions.without_way;
    }
    io::write_whole(options.output, options.team ? teams : movingai_scenarios(all.kept));
    if (options.output == "-") return;
    const std::string made =
        options.team ? fmt::format("{} {}, ", team_count, team_count == 1 ? "team" : "teams") : std::string();
    io::write_whole(
        "-", fmt::format("{}: {}{} of {} pairs kept; {} have no way, {} too small a detour\n", options.output, made,
                         all.kept.size(), all.drawn, all.without_way, all.drawn - all.kept.size() - all.without_way));
}

}  // namespace

void setup_missions_generate(CLI::App& missions, Run& run_chosen) {
    auto options = std::make_shared<MissionsGenerateOptions>();
    CLI::App* command = missions.add_subcommand(
        "generate",
        "Draw missions at random, as the paper does\n\n"
        "On each map pairs of a start and a goal that lie far apart are drawn; those are kept whose Theta* path is "
        "clearly longer than the straight line. They are written as a MovingAI scenario file: maps are named as seen "
        "from its folder, the last column is the length of the optimal octile path. The same maps and seed give the "
        "same missions everywhere.");
    experiment::MissionRules& rules = options->rules;
    add_files(*command, "MAP", options->maps, "Map files of any kind");
    add_count(
        *command, "--pairs", [&rules](auto n) { rules.pairs = int(n); }, 1, 10'000'000,
        fmt::format("Pairs to draw on each map (default: {})", rules.pairs));
    add_length(*command, "--min-distance", options->min_distance, 2 * max_side,
               fmt::format("Start and goal are farther apart (default: {})", rules.min_distance));
    add_count(
        *command, "--min-detour", [&rules](auto n) { rules.min_detour = double(n) / 100; }, 0, 10'000,
        fmt::format("Theta* paths are longer than the straight line by more than that many percent "
                    "(default: {})",
                    100 * rules.min_detour));
    add_count(
        *command, "--seed", [&rules](auto n) { rules.seed = std::uint64_t(n); }, 0,
        std::numeric_limits<std::int64_t>::max(), fmt::format("Of the draw (default: {})", rules.seed));
    command
        ->add_option_function<std::string>(
            "--team", [options](const std::string& given) { options->team = team_size(given); },
            "Join the pairs of each map to teams of so many vehicles and aircraft, each aircraft with a vehicle's "
            "start "
            "and goal; the file then has a mission document on each line")
        ->type_name("K+M");
    add_choice(*command, "--objective", io::objective_words, options->objective,
               "With --team: what their plans make small (default: makespan)");
    add_file(*command, "-o,--output", options->output, "The scenario file to write, or with --team the missions")
        ->required();
    set_examples(*command, {"waybreaker missions generate data/berlin-mitte.tif data/turin.tif -o cities.scen",
                            "waybreaker missions generate maze.map --pairs 1000 --min-distance 100 --min-detour 0 "
                            "--seed 7 -o maze.scen",
                            "waybreaker missions generate data/turin.tif --team 5+2 --objective flowtime -o "
                            "teams.jsonl"});
    command->callback([options, &run_chosen] {
        options->rules.min_distance = options->min_distance.value_or(options->rules.min_distance);
        run_chosen = [options] { run(*options); };
    });
}

}  // namespace waybreaker::apps
