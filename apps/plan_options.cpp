#include "plan_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <climits>
#include <iterator>
#include <string_view>
#include <utility>

#include "core/range.hpp"
#include "io/option_words.hpp"
#include "io/weights.hpp"
#include "option.hpp"
#include "range_options.hpp"
#include "team_options.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

using Document = io::MissionDocument;

const Choices<bool> move_counts{{"8", true}, {"4", false}};

constexpr int most_auto_removals = 32;

// A whole number, or "auto".
void add_removals(CLI::App& command, PlanOptions& options) {
    CLI::Option* option = add_count(
        command, "-n,--removals", [&options](std::int64_t n) { options.removals = int(n); }, 0, INT_MAX,
        "How many obstacles may be removed; 0 means none, auto as many as gain anything (default: 3)");
    option->transform([&options](const std::string& given) {
        options.removals_auto = given == "auto";
        return options.removals_auto ? std::to_string(most_auto_removals) : given;
    });
    option->type_name("N|auto");
}

// Ids at the beginning of a list: "17,4,amenity=hospital"; what comes behind is left in `text`.
std::vector<ObstacleId> take_ids(std::string_view& text) {
    std::vector<ObstacleId> ids;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(','), text.size());
        std::uint32_t id = 0;
        const auto [rest, error] = std::from_chars(text.data(), text.data() + end, id);
        if (error != std::errc() || id == 0 || rest != text.data() + end || end + 1 == text.size()) break;
        ids.push_back({id});
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return ids;
}

bool begins_tag(std::string_view text) {
    const char c = text.empty() ? ' ' : text.front();
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '*';
}

void add_protect(CLI::App& command, PlanOptions& options) {
    const auto read = [&options](const std::string& given) {
        std::string_view tags = given;
        const std::vector<ObstacleId> ids = take_ids(tags);
        options.protect.insert(options.protect.end(), ids.begin(), ids.end());
        if (tags.empty() && !ids.empty()) return;
        try {
            if (!begins_tag(tags)) {
                throw InputError(
                    fmt::format("'{}' is not a list of obstacles: give their numbers, such as 17,4, or tags, such as "
                                "amenity=hospital,school",
                                shown(given)));
            }
            std::ranges::move(site::parse_tag_filters(std::string(tags)), std::back_inserter(options.protect_tags));
        } catch (const InputError& error) {
            throw CLI::ValidationError("--protect", error.what());
        }
    };
    command
        .add_option_function<std::string>(
            "--protect", read,
            "Obstacles that must stay: their numbers, or tags and names of what they are: amenity=hospital,school or "
            "'name=St. Mary*'; can be given several times")
        ->type_name("ID,...|TAG,...")
        ->trigger_on_parse();
}

void add_mission_options(CLI::App& command, PlanOptions& options) {
    add_file(command, "--mission", options.mission,
             "Read the mission from a mission file (JSON); other options override what it says");
    add_team_options(command, options);
    add_place(command, "--start", options.start,
              "Where both agents start: a cell, or the name of a street or an obstacle that the map knows (default: as "
              "the map file says)");
    add_place(command, "--goal", options.goal, "Where both agents end (default: as the map file says)");
    add_place(command, "--air-start", options.air_start, "Where the air agent starts, if elsewhere");
    add_place(command, "--air-goal", options.air_goal, "Where the air agent ends, if elsewhere");
    command.add_flag("--lonlat", options.lon_lat,
                     "These places are longitude and latitude, in degrees: 13.3777,52.5163; not cells");
    command
        .add_flag("--map-metres", options.map_metres,
                  "These places are metres of the map's frame, x to the right and y up, as a robot knows them: "
                  "-1.5,0.25; not cells")
        ->excludes("--lonlat");
    add_measure(command, "--ground-speed", options.ground_speed, speeds, speed_units, "SPEED",
                "How fast the ground agent drives, in cells per unit of time, or as 1.5m/s or 5km/h: a unit of time is "
                "then a second (default: 1)");
    add_measure(command, "--air-speed", options.air_speed, speeds, speed_units, "SPEED",
                "How fast the air agent flies, likewise (default: 1)");
    add_range_options(command, options);
    add_measure(command, "--breach-time", options.breach_time, breach_times, time_units, "TIME",
                "How long the air agent stays to breach an obstacle, beside what the map says of each; with a "
                "unit, such as 30s or 2min, in seconds, at 1 m/s if no speeds are given (default: 0)");
    add_measure(command, "--breach-time-per-cell", options.breach_time_per_cell, breach_times, time_units, "TIME",
                "How much longer for each cell of the obstacle (default: 0)");
    add_measure(command, "--rubble", options.rubble, breach_times, time_units, "TIME",
                "How much longer a ground agent takes for each removed obstacle that it drives through; with units as "
                "--breach-time (default: 0)");
    add_protect(command, options);
    add_obstacles(command, "--force", options.force, "Obstacles that must go; they count among the removals");
    add_file(
        command, "--zones", options.zones,
        "Where nobody may go, in place of what the mission file says: polygons as GeoJSON, each with a property "
        "\"zone\": \"no_fly\" for aircraft, which fly round it, or \"keep_out\" for ground agents, and where wanted "
        "\"from\" and \"until\", between which it holds; longitude and latitude, or cells where the file has "
        "\"crs\": \"cells\"");
    add_overlay_options(command, options.overlays);
    add_connectivity(command, options.connectivity);
    add_image_reading(command, options.image);
    add_number(
        command, "--cell-size", [&options](double size) { options.cell_size = size; },
        {io::least_cell_size, io::most_cell_size}, "METRES",
        "Side of a cell, for lengths in metres (default: as the map file says)");
}

// A weight, or an area such as 800m2.
void add_budget(CLI::App& command, PlanOptions& options) {
    const auto read = [&options](const std::string& given) {
        std::string_view text = given;
        for (const std::string_view unit : {"m2", "m\u00B2"}) {
            if (!text.ends_with(unit)) continue;
            text.remove_suffix(unit.size());
            break;
        }
        const std::optional<double> budget = number_from(text);
        if (!budget || !(*budget >= least_weight && *budget <= most_weight)) {
            throw CLI::ValidationError(
                "--budget",
                fmt::format("'{}' is not a number from {} to {}, nor an area in square metres such as 800m2",
                            shown(given), number_text(least_weight), number_text(most_weight)));
        }
        options.budget = budget;
        options.area_budget = text.size() < given.size();
    };
    command
        .add_option_function<std::string>(
            "--budget", read,
            "What the removed obstacles may weigh together, each 1 unless the map or --weights says otherwise; or how "
            "many square metres they may cover: 800m2. Alone it stands in place of a count")
        ->type_name("WEIGHT|AREA");
}

// Behind "=", so that what follows the option is never taken for it.
void add_minimise_demolition(CLI::App& command, PlanOptions& options) {
    const auto read = [&options](const std::string& given) {
        constexpr double usual = 0.005;
        const bool alone = given == "true";  // as CLI11 calls it
        const std::optional<double> tolerance = alone ? usual : share_from(given);
        if (!tolerance) {
            throw CLI::ValidationError(
                "--minimise-demolition",
                fmt::format("'{}' is not a share from 0 to 1, such as =0.005 or =0.5%", shown(given)));
        }
        says(options, [](Document& d) -> auto& { return d.mission.rules.minimise_demolition; })(tolerance);
    };
    command
        .add_option_function<std::string>("--minimise-demolition", read,
                                          "Of the plans that are at most that much worse than the best one, take the "
                                          "one that demolishes the smallest "
                                          "area (default: 0.5%, of the objective)")
        ->type_name("TOLERANCE")
        ->expected(0);
}

void add_gap(CLI::App& command, PlanOptions& options) {
    const auto read = [&options](const std::string& given) {
        const std::optional<double> gap = share_from(given);
        if (!gap) {
            throw CLI::ValidationError(
                "--gap", fmt::format("'{}' is not a share from 0 to 1, such as 0.01 or 1%", shown(given)));
        }
        says(options, [](Document& d) -> auto& { return d.limits.gap; })(*gap);
    };
    command
        .add_option_function<std::string>("--gap", read,
                                          "Stop planning as soon as the plan is proven to be above the best possible "
                                          "by no more than that (default: 0)")
        ->type_name("SHARE");
}

void add_method_options(CLI::App& command, PlanOptions& options) {
    command.add_flag("--paper", options.paper,
                     "The paper's method: --select hits --flight nearest --timing ignore --planner theta; for -n 1 its "
                     "exact flight past one obstacle");
    add_removals(command, options);
    add_choice(command, "--select", io::selection_words, options.select,
               "Obstacles chosen with a proven bound on every other choice; those that the search ran into most "
               "often, as in the paper; again and again the one that shortens the ground path most, or the objective "
               "of a team; or none (default: exact)");
    add_budget(command, options);
    add_minimise_demolition(command, options);
    add_file(command, "--weights", options.weights,
             "Weights of obstacles: a file with lines \"ID WEIGHT\", or the word cells for each obstacle's number of "
             "cells");
    add_time_limit(
        command, "--time-limit", says(options, [](Document& d) -> auto& { return d.limits.seconds; }),
        "Stop planning so long after the start, with the best plan known and how far it can be from the best; none "
        "takes the time it needs (default: 10)");
    add_gap(command, options);
    add_count(
        command, "--threads", [&options](auto n) { options.threads = unsigned(n); }, 1, 1024,
        "How many threads plan a team with aircraft; the plan is the same (default: one on each core)");
    command.add_flag("--bound", options.bound, "Prove a limit that no plan can beat also where the method proves none");
    command.add_flag(
        "--explain", options.explain,
        "Say what each removal saves, which obstacle one removal more would take, what each ground agent of a "
        "team gains, and who waits for whom");
    command.add_flag("--plan-b", options.plan_b,
                     "Say of each removal what the mission comes to if it fails when it is tried, and what is removed "
                     "then; needs the timing enforced");
    add_choice(command, "--flight", io::flight_words, options.flight,
               "Shortest flight that touches every removed obstacle, or the paper's: past the cells nearest to the "
               "straight line (default: optimal)");
    add_choice(command, "--timing", io::timing_words,
               says(options, [](Document& d) -> auto& { return d.mission.rules.timing; }),
               "An obstacle is solid until it has been breached, so that the ground agent waits or drives around; or, "
               "as in the paper, removed obstacles are taken as never there (default: enforce)");
    add_choice(command, "--objective", io::objective_words,
               says(options, [](Document& d) -> auto& { return d.mission.rules.objective; }),
               "What the plan makes small: when the last agent arrives, the sum of all arrival times, or when the "
               "ground agent "
               "arrives, whenever the aircraft is home (default: makespan)");
}

void add_search_options(CLI::App& command, PlanOptions& options) {
    add_choice(
        command, "--planner", io::planner_words, options.planner,
        "Search of the ground agent (default: optimal; theta where the way to select, the agent or its moves need it)");
    add_choice(command, "--heuristic", io::heuristic_words, options.heuristic,
               "Estimate of the way to go (default: euclidean for theta and lazy-theta, octile for astar and jps)");
    add_number(
        command, "--weight", [&options](double weight) { options.weight = weight; }, {1, most_heuristic_weight}, "W",
        "Weight of the heuristic, at least 1 (default: 1)");
    add_choice(
        command, "--tie-break", io::tie_break_words, options.tie_break,
        "Of two equally promising nodes take the one farther from (g-max) or nearer to the start (default: g-max)");
    add_choice(command, "--corners", io::corner_words, options.corners,
               "Diagonal steps pass no blocked cell at their side, one, or two (default: none)");
    add_measure(command, "--radius", options.radius, radii, length_units, "LENGTH",
                "Radius of the ground agent, in cells, or metres such as 0.8m; 0 for a point (default: 0.5, or half "
                "the width of the "
                "vehicle that the map was made for, if that is more)");
    add_choice(command, "--moves", move_counts, says(options, [](Document& d) -> auto& { return d.method.diagonal; }),
               "Steps from a cell (default: 8)");
    add_count(
        command, "--expansion-limit",
        [&options](std::int64_t n) {
            says(options, [](Document& d) -> auto& { return d.limits.expansions; })(std::uint64_t(n));
        },
        1, INT64_MAX, "Give up a search after so many expansions");
}

void add_output_options(CLI::App& command, PlanOptions& options) {
    add_file(command, "--json", options.json, "Write the plan; - is standard output, here and below");
    add_file(command, "--save-mission", options.save_mission,
             "Write the mission, options included, as a mission file for --mission");
    add_file(command, "--svg", options.svg, "Write a picture");
    command.add_flag("--animate", options.animate,
                     "The picture of --svg plays the plan over and over, except for readers who ask for less motion");
    add_file(command, "--png", options.png, "Write a picture");
    add_file(command, "--html", options.html,
             "Write a page for a browser that plays the plan: one file, no network needed");
    add_steerable(command, options.steerable);
    add_file(command, "--trace", options.trace,
             "Write every step of the first ground search, for the Posthoc search visualiser (NAME.trace.json)");
    add_plan_exports(command, options.exports);
    command.add_flag("--no-timing", options.no_timing,
                     "Leave out measured times, so that equal input gives equal bytes");
}

// Before the map is read.
void validate_places(const PlanOptions& options) {
    std::vector<GivenPlace> places = options.bases;
    for (const auto* place : {&options.start, &options.goal, &options.air_start, &options.air_goal}) {
        if (*place) places.push_back(**place);
    }
    for (const GivenPlace& place : places) {
        if (place.is_name) continue;
        if (options.lon_lat) {
            validate_lon_lat(place);
        } else if (options.map_metres) {
            validate_metres(place);
        } else {
            cell_of(place);
        }
    }
}

}  // namespace

bool needs_search(const PlanOptions& options) {
    return options.heuristic || options.weight || options.tie_break || !options.trace.empty();
}

void add_plan_options(CLI::App& command, PlanOptions& options) {
    add_file(command, "MAP", options.map,
             "A map: MovingAI, the authors' XML, GeoTIFF, the YAML of a ROS map, PNG, PGM, ...; - is standard input")
        ->required();
    command.option_defaults()->group("Mission");
    add_mission_options(command, options);
    command.option_defaults()->group("Method");
    add_method_options(command, options);
    command.option_defaults()->group("Ground search");
    add_search_options(command, options);
    command.option_defaults()->group("Rehearsal");
    add_robust_options(command, options.robust);
    command.option_defaults()->group("Output");
    add_output_options(command, options);
}

void say(const PlanOptions& options, io::MissionDocument& document) {
    if (options.paper) follow_paper(document.mission.rules, document.method);
    for (const auto& one : options.said) one(document);
}

void validate(const PlanOptions& options) {
    validate_places(options);
    io::MissionDocument said;
    say(options, said);
    const Rules& rules = said.mission.rules;
    if (options.planner == Algorithm::optimal && needs_search(options)) {
        throw InputError("--planner optimal has no --heuristic, --weight, --tie-break or --trace; use theta for them");
    }
    if (options.paper && options.planner && *options.planner != Algorithm::theta) {
        throw InputError(
            fmt::format("--paper stands for --planner theta, which --planner {} contradicts; drop one of them",
                        to_string(*options.planner)));
    }
    if (options.paper && options.select && *options.select != Selection::hits) {
        throw InputError(
            fmt::format("--paper stands for --select hits, which --select {} contradicts; drop one of them",
                        to_string(*options.select)));
    }
    if (options.paper && options.flight == FlightRule::optimal && options.removals.value_or(3) > 1) {
        throw InputError("--paper stands for --flight nearest, which --flight optimal contradicts; drop one of them");
    }
    if (options.paper && rules.timing == Timing::enforce) {
        throw InputError("--paper stands for --timing ignore, which --timing enforce contradicts; drop one of them");
    }
    if (options.paper && rules.minimise_demolition) {
        throw InputError("--minimise-demolition needs --select exact, which --paper contradicts; drop one of them");
    }
    if (options.robust.share && (options.explain || options.removals_auto || rules.minimise_demolition)) {
        throw InputError(
            fmt::format("--robust may take a plan that is not the best, which {} compares others with; drop "
                        "one of them",
                        options.explain         ? "--explain"
                        : options.removals_auto ? "--removals auto"
                                                : "--minimise-demolition"));
    }
    if (options.animate && options.svg.empty()) {
        throw InputError("--animate moves the picture that --svg writes; add --svg FILE");
    }
    if (said.limits.gap > 0 && (options.explain || rules.minimise_demolition)) {
        throw InputError(fmt::format("{} compares plans that are best, which --gap contradicts; drop one of them",
                                     options.explain ? "--explain" : "--minimise-demolition"));
    }
    validate(options.exports);
    NamedFiles outputs = named_outputs(options.exports);
    outputs.insert(outputs.begin(), {{"--json", options.json},
                                     {"--svg", options.svg},
                                     {"--png", options.png},
                                     {"--html", options.html},
                                     {"--trace", options.trace},
                                     {"--save-mission", options.save_mission}});
    NamedFiles inputs{{"MAP", options.map},
                      {"--weights", options.weights},
                      {"--mission", options.mission},
                      {"--zones", options.zones},
                      {"--agents", options.agents}};
    for (const site::OverlaySource& overlay : overlays_of(options.overlays))
        inputs.emplace_back("--also", overlay.file);
    validate_inputs(inputs);
    validate_outputs(outputs, inputs);
}

}  // namespace waybreaker::apps
