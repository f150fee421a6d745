// `waybreaker map split`: a map whose obstacles are cut into sections.
#include <fmt/format.h>

#include <cmath>

#include "commands.hpp"
#include "format_losses.hpp"
#include "help.hpp"
#include "io/output_file.hpp"
#include "mapfile/map_reader.hpp"
#include "mapfile/map_writer.hpp"
#include "mapfile/relabelled_map.hpp"
#include "named_files.hpp"
#include "option.hpp"
#include "progress.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

struct MapSplitOptions {
    std::string in;
    std::string out;
    double section = 0;
    std::optional<Cell> origin;
    Connectivity connectivity = Connectivity::four;
    io::ImageReading image;
};

io::MapFile read_map(const MapSplitOptions& options) {
    const Progress progress("reading " + io::input_name(options.in));
    return mapfile::read_map_file(options.in, options.connectivity, options.image);
}

// In cells.
int side_on(const io::MapFile& file, double section) {
    const double cell = file.has_metres() ? file.cell_size : 1;
    if (section < cell) {
        throw InputError(
            file.has_metres()
                ? fmt::format("--section {}: cells have {:.6g} m; give at least that", section, cell)
                : fmt::format("--section {}: of a map without metres it is a number of cells, at least 1", section));
    }
    return int(std::round(std::min(section / cell, double(max_side))));
}

void require_format(const std::string& path) {
    if (mapfile::holds_obstacles(path)) return;
    throw InputError(path + ": its format does not hold which cell belongs to which section; end the name in .tif");
}

std::string split_summary(const io::MapFile& file, const std::string& path, int side) {
    const std::string length =
        file.has_metres() ? fmt::format("{:.6g} m", side * file.cell_size) : fmt::format("{} cells", side);
    const std::string sections =
        file.annotations.sections.empty() ? "nothing to cut" : site::sections_summary(file.annotations.sections);
    return fmt::format("{}: {}, squares of {}\n", path, sections, length);
}

void run(const MapSplitOptions& options) {
    require_format(options.out);
    keep_inputs({{"OUT", options.out}}, {{"MAP", options.in}});
    io::MapFile file = read_map(options);
    const int side = side_on(file, options.section);
    file = mapfile::in_sections(std::move(file), {.side = side, .origin = options.origin.value_or(Cell{})});
    const mapfile::WrittenMap written = mapfile::write_map(file, options.out);
    write_beside(written.files, {{"MAP", options.in}});
    report_losses(options.out, written.losses);
    io::write_whole("-", split_summary(file, options.out, side));
}

}  // namespace

void setup_map_split(CLI::App& map, Run& run_chosen) {
    auto options = std::make_shared<MapSplitOptions>();
    CLI::App* command = map.add_subcommand(
        "split",
        "Cut what can be destroyed into sections\n\n"
        "One breach then clears everything destructible inside one square of a lattice, and no longer a whole building "
        "or wall. Obstacles that cannot be destroyed, such as water and unknown ground, stay whole. OUT "
        "keeps names, kinds and source ids, and of which buildings each section has parts. A square that would clear "
        "less than a twentieth of its area joins a neighbour.");
    add_file(*command, "MAP", options->in, "A map of any format that is read; - is standard input")->required();
    add_file(*command, "OUT", options->out, "The map to write, as GeoTIFF (.tif); .geojson holds its sections, too")
        ->required();
    add_number(
        *command, "--section", [options](double side) { options->section = side; }, {0.001, 1e6}, "METRES",
        "Side of a square, rounded to whole cells; cells, if the map does not say how many metres a cell has: "
        "GeoTIFFs and ROS maps do")
        ->required();
    add_cell(*command, "--section-origin", options->origin,
             "A cell whose upper-left corner is a corner of the lattice (default: 0,0)");
    add_connectivity(*command, options->connectivity);
    add_image_reading(*command, options->image);
    set_examples(*command, {"waybreaker map split data/turin.tif turin-sections.tif --section 20",
                            "waybreaker map split floor.yaml floor.tif --section 0.5",
                            "waybreaker map split Berlin_0_512.map berlin.tif --section 8"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps
