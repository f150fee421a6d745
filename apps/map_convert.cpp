// `waybreaker map convert`: a map in another format.
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

namespace waybreaker::apps {
namespace {

struct MapConvertOptions {
    std::string in;
    std::string out;
    Connectivity connectivity = Connectivity::four;
    io::ImageReading image;
    std::vector<ObstacleId> without;
};

io::MapFile read_map(const MapConvertOptions& options) {
    const Progress progress("reading " + io::input_name(options.in));
    return mapfile::read_map_file(options.in, options.connectivity, options.image);
}

void run(const MapConvertOptions& options) {
    keep_inputs({{"OUT", options.out}}, {{"IN", options.in}});
    const io::MapFile map = read_map(options);
    const mapfile::WrittenMap written =
        mapfile::write_map(mapfile::without_obstacles(map, options.without), options.out);
    write_beside(written.files, files_of_map(options.in, map));
    report_losses(options.out, written.losses);
}

}  // namespace

void setup_map_convert(CLI::App& map, Run& run_chosen) {
    auto options = std::make_shared<MapConvertOptions>();
    CLI::App* command = map.add_subcommand(
        "convert",
        "Write a map in another format\n\n"
        "The end of OUT's name says which: .map (MovingAI), .xml (the authors' task file), .tif (labels), .geojson, "
        ".yaml (ROS, "
        "with a .pgm beside it), .png, .pgm. What the format cannot hold of the map is reported on standard error. A "
        "ROS "
        "map comes back as it was, to the byte.");
    add_file(*command, "IN", options->in, "A map of any format that is read; - is standard input")->required();
    add_file(*command, "OUT", options->out, "The map to write")->required();
    add_connectivity(*command, options->connectivity);
    add_image_reading(*command, options->image);
    add_obstacles(*command, "--without", options->without, "Leave these obstacles out: the map after their removal");
    set_examples(*command, {"waybreaker map convert data/turin.tif turin.yaml",
                            "waybreaker map convert floor.yaml opened.yaml --without 4,17",
                            "waybreaker map convert floor.png floor.map --threshold 0.8"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps
