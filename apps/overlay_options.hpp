// What is laid over a map, as options: --also FILE --as water, again and again.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "city/overlay_source.hpp"

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

// A line for each: "flood.geojson as water: 1 thing on 480 cells, 1920 m²".
std::string overlay_summary(const std::vector<city::OverlayReport>& reports, double cell_size);

// What the user should know of them.
void note_overlays(const std::vector<city::OverlayReport>& reports);

}  // namespace waybreaker::apps
