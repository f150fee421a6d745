// `waybreaker map convert`: a map in another format.
#include <fmt/format.h>

#include <cstdio>

#include "commands.hpp"
#include "help.hpp"
#include "io/map_writer.hpp"
#include "io/output_file.hpp"
#include "option.hpp"
#include "progress.hpp"

namespace waybreaker::apps {
namespace {

struct MapConvertOptions {
    std::string in;
    std::string out;
    Connectivity connectivity = Connectivity::four;
    io::ImageReading image;
};

io::MapFile read_map(const MapConvertOptions& options) {
    const Progress progress("reading " + options.in);
    return io::read_map_file(options.in, options.connectivity, options.image);
}

void run(const MapConvertOptions& options) {
    const io::WrittenMap written = io::write_map(read_map(options), options.out);
    for (const io::OutputFile& file : written.files) io::write_whole(file.path, file.bytes);
    for (const std::string& loss : written.losses) {
        std::fputs(fmt::format("waybreaker: note: {}: {}\n", options.out, loss).c_str(), stderr);
    }
}

}  // namespace

void setup_map_convert(CLI::App& map, Run& run_chosen) {
    auto options = std::make_shared<MapConvertOptions>();
    CLI::App* command = map.add_subcommand(
        "convert",
        "Write a map in another format\n\n"
        "The end of OUT's name says which: .map (MovingAI), .xml (the authors' task file), .tif (labels), .geojson, "
        ".yaml (ROS, "
        "with a .pgm beside it), .png, .pgm. What the format cannot hold of the map is told on standard error. A ROS "
        "map comes back as it was, to the byte.");
    add_file(*command, "IN", options->in, "A map of any format that is read")->required();
    add_file(*command, "OUT", options->out, "The map to write")->required();
    add_connectivity(*command, options->connectivity);
    add_image_reading(*command, options->image);
    set_examples(*command, {"waybreaker map convert data/turin.tif turin.yaml",
                            "waybreaker map convert floor.png floor.map --threshold 0.8"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps
