// `waybreaker missions access`: a mission with many places, and a hospital that they are reached from.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <set>

#include "commands.hpp"
#include "geotiff/georeference.hpp"
#include "help.hpp"
#include "io/agent_json.hpp"
#include "io/map_file.hpp"
#include "io/mission_document.hpp"
#include "io/mission_json.hpp"
#include "io/output_file.hpp"
#include "io/places_json.hpp"
#include "mapfile/map_reader.hpp"
#include "model/nearest_place.hpp"
#include "named_files.hpp"
#include "note.hpp"
#include "option.hpp"
#include "waybreaker/advanced/search.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

struct MissionsAccessOptions {
    std::string map;
    std::string from;
    std::string to;
    std::string output = "-";
    bool inbound = false;
    int removals = Rules().removals;
    int aircraft = 1;
    std::optional<Cell> base;
    std::optional<double> unreached;
};

// A place, on the cell where a vehicle can stand.
struct Destination {
    Cell at;
    std::string name;
    double weight = 1;
};

io::PlaceCollection places_in_cells(const std::string& path, const io::MapFile& map) {
    io::PlaceCollection given = io::parse_places(io::read_whole(path, io::max_places_bytes), io::input_name(path));
    if (given.in_cells) return given;
    if (!map.georeference) {
        throw InputError(fmt::format(
            "{}: is in longitude and latitude, and {} does not say where on Earth it lies; give cells, and \"crs\": "
            "\"cells\" beside \"features\"",
            io::input_name(path), map.source));
    }
    std::vector<Point> points;
    for (const io::Place& place : given.places) points.push_back(place.at);
    points = geotiff::FromLonLat(*map.georeference)(std::move(points));
    for (std::size_t i = 0; i < points.size(); ++i) given.places[i].at = points[i];
    return given;
}

// Those on the map, each on the nearest free cell: houses are obstacles.
std::vector<Destination> destinations_of(const std::string& path, const io::MapFile& map) {
    const OpenedMap closed(map.map);
    std::vector<Destination> found;
    std::size_t outside = 0;
    const std::vector<io::Place> places = places_in_cells(path, map).places;
    for (const io::Place& place : places) {
        const bool on_map = place.at.x >= -0.5 && place.at.x < map.map.width() - 0.5 && place.at.y >= -0.5 &&
                            place.at.y < map.map.height() - 0.5;
        if (!on_map) {
            ++outside;
            continue;
        }
        const Cell at{int(std::lround(place.at.x)), int(std::lround(place.at.y))};
        if (const auto free = nearest_place(closed, at, {io::usual_radius(map)}))
            found.push_back({*free, place.name, place.weight});
    }
    if (outside > 0) note(io::input_name(path), fmt::format("{} of {} places lie off the map", outside, places.size()));
    if (found.empty()) throw InputError(io::input_name(path), 0, "has no place on the map");
    return found;
}

// The one with the shortest way as the map is; where there is none, the nearest in a straight line.
const Destination& nearest(const std::vector<Destination>& all, Cell to, const OpenedMap& closed, Searcher& searcher) {
    const Destination* best = &all.front();
    double least = std::numeric_limits<double>::infinity();
    double least_straight = least;
    for (const Destination& one : all) {
        if (all.size() == 1) break;
        const SearchResult way = searcher.find(closed, one.at, to, {.planner = Algorithm::astar});
        const double length = way.status == SearchStatus::found ? way.length : least;
        const double straight = distance(one.at, to);
        const bool is_nearer = length < least || (std::isinf(least) && straight < least_straight);
        if (!is_nearer) continue;
        best = &one;
        least = length;
        least_straight = straight;
    }
    return *best;
}

std::string aircraft_id(const MissionsAccessOptions& options, int number) {
    return options.aircraft == 1 ? "air" : fmt::format("air{}", number);
}

// The name, cut where it would be too long for an id with the number behind it, were all its bytes characters.
std::string numbered(std::string name, int number) {
    const std::string behind = fmt::format(" ({})", number);
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };  // a character
    while (name.size() + behind.size() > io::longest_id) {
        while (continues(name.back())) name.pop_back();
        name.pop_back();
    }
    return name + behind;
}

Mission mission_of(const MissionsAccessOptions& options, const io::MapFile& map) {
    const std::vector<Destination> hospitals = destinations_of(options.from, map);
    const std::vector<Destination> places = destinations_of(options.to, map);
    const OpenedMap closed(map.map);
    Searcher searcher;
    Mission mission;
    std::set<std::string> ids;
    for (int i = 1; i <= options.aircraft; ++i) ids.insert(aircraft_id(options, i));
    for (const Destination& place : places) {
        const Cell hospital = nearest(hospitals, place.at, closed, searcher).at;
        const std::string number = std::to_string(mission.agents.size() + 1);
        const std::string name = place.name.empty() ? number : place.name;
        std::string id = name;
        for (int again = 2; !ids.insert(id).second; ++again) id = numbered(name, again);
        Agent& agent = mission.agents.emplace_back(options.inbound ? vehicle(id, place.at, hospital)
                                                                   : vehicle(id, hospital, place.at));
        agent.weight = place.weight;
        agent.body.radius = io::usual_radius(map);
    }
    for (int i = 1; i <= options.aircraft; ++i) {
        Agent& agent =
            mission.agents.emplace_back(aircraft(aircraft_id(options, i), options.base.value_or(hospitals.front().at)));
        agent.weight = 0;
    }
    mission.rules.objective = Objective::flowtime;
    mission.rules.removals = options.removals;
    mission.rules.collisions = false;
    mission.rules.unreached = options.unreached.value_or(2.0 * (map.map.width() + map.map.height()));
    validate(map.map, mission);
    return mission;
}

void run(const MissionsAccessOptions& options) {
    require_ending("--output", options.output, {".json"});
    keep_inputs({{"--output", options.output}}, {{"MAP", options.map}, {"--from", options.from}, {"--to", options.to}});
    const io::MapFile map = mapfile::read_map_file(options.map);
    const io::MissionDocument document{.mission = mission_of(options, map), .limits = {.seconds = 10}};
    io::write_whole(options.output, io::mission_text(document));
    if (options.output == "-") return;
    double weight = 0;
    for (const Agent& agent : document.mission.agents) weight += agent.weight;
    io::write_whole("-", fmt::format("{}: {} places that count for {:g} together\n", options.output,
                                     document.mission.agents.size() - std::size_t(options.aircraft), weight));
}

}  // namespace

void setup_missions_access(CLI::App& missions, Run& run_chosen) {
    auto options = std::make_shared<MissionsAccessOptions>();
    CLI::App* command = missions.add_subcommand(
        "access",
        "Make a mission with many places\n\n"
        "Writes the mission file that asks which openings bring a vehicle from a hospital, or a depot, to many places "
        "soonest: one vehicle for each place, which counts for the place's weight, and aircraft that count for "
        "nothing. Vehicles do not collide. What they make small is the sum of all arrivals, each times its weight. A "
        "place inside an obstacle stands for the nearest free cell.");
    add_file(*command, "MAP", options->map, "Map file of any kind")->required();
    add_file(*command, "--from", options->from,
             "GeoJSON points, in longitude and latitude or with \"crs\": \"cells\": hospitals. Of several each place "
             "has the one with the shortest way as the map is")
        ->required();
    add_file(*command, "--to", options->to,
             "GeoJSON points: places, each with a weight, such as its people (default: 1), and a name")
        ->required();
    command->add_flag("--inbound", options->inbound, "Vehicles drive from the places to the hospital");
    add_count(
        *command, "-n,--removals", [options](std::int64_t n) { options->removals = int(n); }, 0, 1000,
        fmt::format("How many obstacles may be removed (default: {})", options->removals));
    add_count(
        *command, "--aircraft", [options](std::int64_t n) { options->aircraft = int(n); }, 1, 1000,
        "So many aircraft remove them (default: 1)");
    add_cell(*command, "--base", options->base, "Where aircraft start, and return to (default: the first hospital)");
    add_number(
        *command, "--unreached", [options](double time) { options->unreached = time; }, {1e-6, most_breach_time},
        "TIME",
        "A place that is not reached by then counts as if it were reached then (default: the time it takes to drive "
        "once around the map)");
    add_file(*command, "-o,--output", options->output, "The mission file to write (default: standard output)");
    set_examples(*command,
                 {"waybreaker missions access data/berlin-mitte.tif --from data/berlin-mitte-hospital.geojson --to "
                  "data/berlin-mitte-places.geojson -o access.json",
                  "waybreaker plan data/berlin-mitte.tif --mission access.json -n 3 --svg access.svg"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps
