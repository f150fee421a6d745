// `waybreaker map info`: what a map file holds.
#include "mapfile/map_info.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "background_summary.hpp"
#include "commands.hpp"
#include "geotiff/georeference.hpp"
#include "help.hpp"
#include "io/map_file.hpp"
#include "io/map_info.hpp"
#include "io/mission_document.hpp"
#include "io/output_file.hpp"
#include "mapfile/map_reader.hpp"
#include "option.hpp"
#include "progress.hpp"

namespace waybreaker::apps {
namespace {

struct MapInfoOptions {
    std::string file;
    Connectivity connectivity = Connectivity::four;
    io::ImageReading image;
    bool json = false;
};

// Who an obstacle is: " (OSM 4711, Town hall)".
std::string identity(const io::MapFile& file, const Obstacle& obstacle) {
    std::vector<std::string> words;
    if (obstacle.source_id != 0) words.push_back(fmt::format("OSM {}", obstacle.source_id));
    if (const std::string_view name = file.annotations.name_of(obstacle.id); !name.empty()) words.emplace_back(name);
    return words.empty() ? "" : fmt::format(" ({})", fmt::join(words, ", "));
}

// "61.2 % open, 25.5 % destructible, 3.1 % water": what there is of, in cells of the map.
std::string ground_text(const io::GroundSummary& ground) {
    const std::array<std::pair<const char*, std::uint64_t>, 8> parts{{{"open", ground.open},
                                                                      {"destructible", ground.destructible},
                                                                      {"protected", ground.protected_},
                                                                      {"water", ground.water},
                                                                      {"cliff", ground.cliff},
                                                                      {"forbidden", ground.forbidden},
                                                                      {"off road", ground.off_road},
                                                                      {"unknown", ground.unknown}}};
    std::uint64_t all = 0;
    for (const auto& part : parts) all += part.second;
    std::vector<std::string> words;
    for (const auto& [name, cells] : parts) {
        if (cells > 0) words.push_back(fmt::format("{:.1f} % {}", 100.0 * double(cells) / double(all), name));
    }
    return fmt::format("{}", fmt::join(words, ", "));
}

// "4711 cells, 12.3 %: without data": of what an import found no data. Robots' maps do not say why.
std::string unknown_text(const io::MapFile& file) {
    if (file.unknown == 0) return "";
    return fmt::format("{} cells, {:.1f} %{}", file.unknown,
                       100.0 * double(file.unknown) / double(file.map.grid().cell_count()),
                       file.annotations.kinds.empty() ? "" : ": without data");
}

// "3 building=church, 1 amenity=school": of what cannot be destroyed, the most frequent first. That something is a
// building goes without saying.
std::string protected_text(const io::MapFile& file) {
    constexpr std::size_t most = 8;
    std::vector<std::pair<std::size_t, std::string>> counts;
    for (const auto& [tag, count] : io::protected_tags(file)) {
        if (tag != "building=yes") counts.emplace_back(count, tag);
    }
    std::ranges::stable_sort(counts, std::ranges::greater(), &std::pair<std::size_t, std::string>::first);
    std::vector<std::string> words;
    for (const auto& [count, tag] : counts) words.push_back(fmt::format("{} {}", count, tag));
    if (words.size() > most) {
        words.resize(most);
        words.emplace_back("...");
    }
    return fmt::format("{}", fmt::join(words, ", "));
}

// "truck, 2.55 m wide: radius 0.638 cells unless a mission says another"
std::string profile_text(const io::MapFile& file) {
    const std::optional<site::Profile> profile = file.annotations.profile;
    return profile ? fmt::format("{}, {} m wide: radius {} cells unless a mission says another",
                                 site::profile_word(*profile), site::vehicle_width(*profile), io::usual_radius(file))
                   : "";
}

std::string as_text(const io::MapFile& file, const io::MapSummary& summary) {
    const Map& map = file.map;
    const auto line = [](const std::string& name, const std::string& value) {
        return value.empty() ? std::string() : fmt::format("{:<13}{}\n", name, value);
    };
    std::string text = line("file", file.source) + line("format", file.format) + line("title", file.annotations.title) +
                       line("profile", profile_text(file)) +
                       line("size", fmt::format("{} x {} cells", map.width(), map.height()));
    if (file.has_metres()) {
        text += line("cell size", fmt::format("{:.6g} m, in all {:.6g} m x {:.6g} m", file.cell_size,
                                              map.width() * file.cell_size, map.height() * file.cell_size));
    }
    text += line("blocked", fmt::format("{} cells, {:.1f} %", summary.blocked, 100 * summary.density));
    if (const auto ground = io::summarise_ground(file)) text += line("ground", ground_text(*ground));
    text += line("unknown", unknown_text(file));
    text += line("protected", protected_text(file));
    text += line("obstacles", std::to_string(map.obstacles().size()));
    if (!file.annotations.sections.empty()) {
        text += line("sections", fmt::format("{} of {}", site::section_count(file.annotations.sections),
                                             site::structures_text(file.annotations.sections,
                                                                   site::cut_structures(file.annotations.sections))));
    }
    if (const Obstacle* largest = summary.largest) {
        text += line("largest", fmt::format("obstacle {}{}, {} cells", largest->id.value, identity(file, *largest),
                                            largest->cells));
    }
    if (const std::size_t names = site::name_count(file.annotations.names); names > 0) {
        text += line("names", fmt::format("of {} obstacles", names));
    }
    text += line("background", fmt::format("{}", fmt::join(background_summary(file.annotations.background), ", ")));
    if (file.georeference) {
        const auto [longitude, latitude] = mapfile::center(file);
        const std::string name = geotiff::crs_name(*file.georeference);
        const std::string code = geotiff::crs_code(*file.georeference);
        text += line("projection", code == name ? name : fmt::format("{} ({})", name, code));
        text += line("centre", fmt::format("longitude {:.6f}, latitude {:.6f}", longitude, latitude));
        if (const auto box = geotiff::lon_lat_box(*file.georeference, map.width(), map.height())) {
            text += line("extent", fmt::format("longitude {:.6f} to {:.6f}, latitude {:.6f} to {:.6f}", box->at(0),
                                               box->at(2), box->at(1), box->at(3)));
        }
    }
    if (file.origin) {
        const auto [x, y] = *file.origin;
        text += line("origin", fmt::format("{:.10g}, {:.10g} (lower left, in metres)", x, y));
    }
    if (file.task && file.task->start)
        text += line("start", fmt::format("{},{}", file.task->start->x, file.task->start->y));
    if (file.task && file.task->goal)
        text += line("goal", fmt::format("{},{}", file.task->goal->x, file.task->goal->y));
    if (file.task && !file.task->agents.empty()) text += line("agents", fmt::format("{}", file.task->agents.size()));
    for (const std::string& note : file.all_notes()) text += line("note", note);
    return text + line("source", file.annotations.attribution) + line("digest", file.digest);
}

io::MapFile read_map(const MapInfoOptions& options) {
    const Progress progress("reading " + io::input_name(options.file));
    return mapfile::read_map_file(options.file, options.connectivity, options.image);
}

void run(const MapInfoOptions& options) {
    const io::MapFile file = read_map(options);
    const io::MapSummary summary = io::summarise(file.map);
    io::write_whole("-", options.json ? mapfile::map_info_json(file) : as_text(file, summary));
}

}  // namespace

void setup_map_info(CLI::App& map, Run& run_chosen) {
    auto options = std::make_shared<MapInfoOptions>();
    CLI::App* command = map.add_subcommand("info", "Print a map's size, density, obstacles, place on earth and origin");
    add_file(*command, "FILE", options->file,
             "A map: MovingAI, the authors' XML, GeoTIFF, the YAML of a ROS map, PNG, PGM, ...; - is standard input")
        ->required();
    add_connectivity(*command, options->connectivity);
    add_image_reading(*command, options->image);
    command->add_flag("--json", options->json, "Write JSON, for programs");
    set_examples(*command, {"waybreaker map info data/turin.tif",
                            "waybreaker map info data/turin.tif --json | jq .obstacles.count"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps
