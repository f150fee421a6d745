// Exports of plans for who moves in the field: options of `waybreaker plan` and `waybreaker export`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "exports/mav_command.hpp"
#include "io/map_file.hpp"
#include "io/mission_document.hpp"
#include "io/output_file.hpp"
#include "named_files.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::apps {

// The files to write; empty where none is asked for.
struct FieldExports {
    std::string gpx;
    std::string kml;
    std::string qgc;
    std::string vda5050;
    std::int64_t starts_at = 0;           // seconds since 1970
    std::optional<double> altitude = {};  // of flights, in metres
    exports::MavAction breach = {};
};

void add_field_exports(CLI::App& command, FieldExports& exports);

// Throws InputError if an option is missing that a file needs.
void validate(const FieldExports& exports);

NamedFiles named_outputs(const FieldExports& exports);

// Precondition: the plan is one for this map, whatever was asked.
std::vector<io::OutputFile> export_plan(const FieldExports& exports, const Plan& plan, const io::MapFile& map,
                                        const io::MissionDocument& asked);

}  // namespace waybreaker::apps
