// `waybreaker map generate`: generated maps.
#include <fmt/format.h>

#include "commands.hpp"
#include "experiment/terrain.hpp"
#include "format_losses.hpp"
#include "help.hpp"
#include "io/map_info.hpp"
#include "io/output_file.hpp"
#include "mapfile/map_writer.hpp"
#include "option.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

using experiment::Terrain;

const Choices<Terrain> terrains{{"maze", Terrain::maze},
                                {"rooms", Terrain::rooms},
                                {"spiral", Terrain::spiral},
                                {"blocks", Terrain::blocks},
                                {"random", Terrain::random}};

struct MapGenerateOptions {
    Terrain terrain = Terrain::maze;
    std::string output;
    experiment::TerrainOptions terrain_options;
};

void run(const MapGenerateOptions& options) {
    const bool has_share = options.terrain != Terrain::spiral && options.terrain != Terrain::blocks;
    if (options.terrain_options.share >= 0 && !has_share)
        throw InputError("--share is for maze, rooms and random; drop it");
    const io::MapFile file{.map = make_terrain(options.terrain, options.terrain_options)};
    const mapfile::WrittenMap written = mapfile::write_map(file, options.output);
    write_beside(written.files, {});
    report_losses(options.output, written.losses);
    if (options.output == "-") return;
    io::write_whole("-",
                    fmt::format("{}: {} x {} cells, {} obstacles, {:.1f} % blocked\n", options.output, file.map.width(),
                                file.map.height(), file.map.obstacles().size(), 100 * io::summarise(file.map).density));
}

}  // namespace

void setup_map_generate(CLI::App& map, Run& run_chosen) {
    auto options = std::make_shared<MapGenerateOptions>();
    CLI::App* command = map.add_subcommand(
        "generate",
        "Make up a map\n\n"
        "maze: corridors that are a tree, every wall between two of its rooms an obstacle; rooms: walls with doors; "
        "spiral: "
        "square spirals side by side, each an obstacle; blocks: city blocks between streets; random: cells blocked at "
        "random. Formats with labels (.tif) keep which wall is which; others join walls that touch. The same seed "
        "gives "
        "the same map everywhere.");
    experiment::TerrainOptions& terrain = options->terrain_options;
    add_choice(*command, "KIND", terrains, options->terrain, "maze, rooms, spiral, blocks or random")->required();
    add_count(
        *command, "--side", [&terrain](auto n) { terrain.side = int(n); }, experiment::least_terrain_side, max_side / 2,
        fmt::format("Cells on a side (default: {})", terrain.side));
    add_count(
        *command, "--share", [&terrain](auto n) { terrain.share = double(n) / 100; }, 0, 100,
        "In percent, of blocked cells (random, default: 25) or of walls open besides those of the tree (maze, "
        "default: 0; rooms, 10)");
    add_count(
        *command, "--seed", [&terrain](auto n) { terrain.seed = std::uint64_t(n); }, 0,
        std::numeric_limits<std::int64_t>::max(), fmt::format("Of the draw (default: {})", terrain.seed));
    add_file(*command, "-o,--output", options->output, "The map to write, in the format its name ends in")->required();
    set_examples(*command, {"waybreaker map generate maze -o maze.tif",
                            "waybreaker map generate random --share 35 --side 256 --seed 7 -o random.map"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps
