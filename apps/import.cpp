// `waybreaker import`: a city map from building footprints.
#include <fmt/format.h>

#include "commands.hpp"
#include "geo/city_import.hpp"
#include "help.hpp"
#include "io/output_file.hpp"
#include "map_summary.hpp"
#include "option.hpp"
#include "progress.hpp"

namespace waybreaker::apps {
namespace {

struct ImportOptions {
    std::string source;
    std::string output;
    geo::ImportOptions window;
};

geo::ImportReport import_with_progress(const ImportOptions& options) {
    const Progress progress("reading " + options.source);
    return geo::import_city(options.source, options.window);
}

void run(const ImportOptions& options) {
    const geo::ImportReport report = import_with_progress(options);
    io::write_whole(options.output, geo::label_tiff_bytes(report.tiff));
    if (options.output == "-") return;
    const Map& map = report.tiff.map;
    io::write_whole("-", fmt::format("{}: {} x {} cells of {:.6g} m, {} buildings, {} obstacles, {:.1f} % blocked\n",
                                     options.output, map.width(), map.height(), report.tiff.cell_size, report.buildings,
                                     map.obstacles().size(), 100 * summarise(map).density));
}

}  // namespace

void setup_import(CLI::App& root, Run& run_chosen) {
    auto options = std::make_shared<ImportOptions>();
    CLI::App* command = root.add_subcommand("import",
                                            "Make a map from the buildings of a city\n\n"
                                            "Reads building footprints from any vector source GDAL knows "
                                            "(OpenStreetMap .osm.pbf, .osm, .osm.gz, shapefile, "
                                            "GeoJSON), projects them to the local UTM zone and writes a square window "
                                            "as a GeoTIFF label map. Every building "
                                            "is an obstacle and keeps its OpenStreetMap id.");
    add_file(*command, "SOURCE", options->source, "File with building footprints")->required();
    add_lon_lat(*command, "--center", options->window.longitude, options->window.latitude,
                "Centre of the window, in degrees east and north")
        ->required();
    add_number(
        *command, "--size", [window = &options->window](double size) { window->size = size; }, 0, "METRES",
        fmt::format("Side of the window (default: {})", options->window.size));
    add_number(
        *command, "--cell", [window = &options->window](double cell) { window->cell = cell; }, 0, "METRES",
        fmt::format("Side of a cell (default: {})", options->window.cell));
    command->add_flag("--merge-touching", options->window.merge_touching,
                      "Buildings that touch are one obstacle, as in the paper");
    add_file(*command, "-o,--output", options->output, "The map to write")->required();
    set_examples(*command, {"waybreaker import turin_buildings.shp --center 7.674,45.069 -o turin.tif",
                            "waybreaker import berlin-mitte.osm.gz --center 13.383,52.5213 --size 600 --cell 1.2 "
                            "--merge-touching -o berlin.tif"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps
