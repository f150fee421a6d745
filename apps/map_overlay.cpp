// `waybreaker map overlay`: a map with what the day brings laid over it.
#include <fmt/format.h>

#include <utility>

#include "city/overlay_source.hpp"
#include "commands.hpp"
#include "format_losses.hpp"
#include "help.hpp"
#include "io/map_info.hpp"
#include "io/output_file.hpp"
#include "mapfile/map_reader.hpp"
#include "mapfile/map_writer.hpp"
#include "named_files.hpp"
#include "option.hpp"
#include "overlay_options.hpp"
#include "progress.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

struct MapOverlayOptions {
    std::string in;
    std::string file;  // the first
    std::string out;
    OverlayOptions overlays;
    city::OverlayCosts costs;
};

io::MapFile read_map(const std::string& path) {
    const Progress progress("reading " + io::input_name(path));
    return mapfile::read_map_file(path);
}

void run(const MapOverlayOptions& options) {
    OverlayOptions given = options.overlays;
    given.files.insert(given.files.begin(), options.file);
    const std::vector<city::OverlaySource> overlays = overlays_of(given);
    if (!mapfile::holds_obstacles(options.out)) {
        throw InputError(options.out + ": its format does not hold what the obstacles are; end the name in .tif");
    }
    NamedFiles inputs{{"MAP", options.in}};
    for (const city::OverlaySource& overlay : overlays) inputs.emplace_back("--also", overlay.file);
    keep_inputs({{"--output", options.out}}, inputs);
    const auto [file, reports] = lay_over(overlays, read_map(options.in), options.costs);
    const mapfile::WrittenMap written = mapfile::write_map(file, options.out);
    write_beside(written.files, inputs);
    report_losses(options.out, written.losses);
    note_overlays(reports);
    io::write_whole("-", overlay_summary(reports, file.cell_size) +
                             fmt::format("{}: {} obstacles, {:.1f} % blocked\n", options.out,
                                         file.map.obstacles().size(), 100 * io::summarise(file.map).density));
}

}  // namespace

void setup_map_overlay(CLI::App& map, Run& run_chosen) {
    auto options = std::make_shared<MapOverlayOptions>();
    CLI::App* command = map.add_subcommand(
        "overlay",
        "Lay what the day brings over a map: a flood, debris, a closed street\n\n"
        "The map must say where it lies, as imported maps do. Each area or line of FILE becomes an obstacle with its "
        "name. Water and closures take what they cover, open or not; debris and walls take open ground. The rest of "
        "the map stays as it is.");
    add_file(*command, "MAP", options->in, "A GeoTIFF map; - is standard input")->required();
    add_file(*command, "FILE", options->file, "Areas and lines: GeoJSON, or any vector format GDAL reads")->required();
    add_overlay_options(*command, options->overlays);
    add_quantity(*command, "--obstacle-weight", options->costs.weight,
                 "What debris and walls weigh against a budget: area (square metres), or the number that a property "
                 "says, volume for one; with *FACTOR if it is to be scaled (default: 1 each)");
    add_quantity(*command, "--obstacle-breach-time", options->costs.breach_time,
                 "How long it takes to remove them, as above (default: 0)");
    add_file(*command, "-o,--output", options->out, "The map to write, as GeoTIFF (.tif)")->required();
    set_examples(*command, {"waybreaker map overlay data/krems.tif data/krems-flood.geojson --as water -o flooded.tif",
                            "waybreaker map overlay city.tif closed.gpkg --as closed --width 8 -o today.tif",
                            "waybreaker map overlay city.tif debris.geojson --as debris "
                            "--obstacle-breach-time volume*1.5 --also flood.shp --as water -o today.tif"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps
