// What is laid over a map, as options: --also FILE --as water, again and again.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "city/overlay_source.hpp"
#include "io/map_file.hpp"

namespace waybreaker::apps {

struct OverlayOptions {
    std::vector<std::string> files;
    std::vector<site::OverlayUse> uses;  // of the first file, the second, ...
    double width = 0;                    // metres
};

void add_overlay_options(CLI::App& command, OverlayOptions& options);

// Throws InputError unless each file has its use.
std::vector<city::OverlaySource> overlays_of(const OverlayOptions& options);

// What an option says that makes a number of each obstacle: WHAT or WHAT*FACTOR.
CLI::Option* add_quantity(CLI::App& command, const std::string& name, city::Quantity& quantity,
                          const std::string& text);

struct OverlaidMap {
    io::MapFile file;
    std::vector<city::OverlayReport> reports;
};

// Throws InputError if the map does not say where it lies, or an overlay cannot be read.
OverlaidMap lay_over(const std::vector<city::OverlaySource>& overlays, io::MapFile file,
                     const city::OverlayCosts& costs = {});

// The map that `waybreaker map overlay` would write, read back, so that plans on both are the same; the map itself if
// there are no overlays. Tells the user what is to be known of them.
io::MapFile to_plan_on(const std::vector<city::OverlaySource>& overlays, io::MapFile file);

// A line for each: "flood.geojson as water: 1 thing on 480 cells, 1920 m²".
std::string overlay_summary(const std::vector<city::OverlayReport>& reports, double cell_size);

// What the user should know of them.
void note_overlays(const std::vector<city::OverlayReport>& reports);

}  // namespace waybreaker::apps
