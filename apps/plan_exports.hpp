// Export formats of plans: what `waybreaker plan` and `waybreaker export` have in common.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "field_exports.hpp"
#include "io/map_file.hpp"
#include "io/mission_document.hpp"
#include "io/output_file.hpp"
#include "named_files.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::apps {

// The files to write; empty where none is asked for.
struct PlanExports {
    std::string geojson;
    std::string csv;
    std::string ros_path;
    std::string ros_parts;
    std::optional<double> step;  // of ROS paths, in metres
    std::string opened_map;
    std::string xml;
    std::string reach;
    FieldExports field;
};

void add_plan_exports(CLI::App& command, PlanExports& exports);

// Throws InputError if an option is missing that another needs.
void validate(const PlanExports& exports);

NamedFiles named_outputs(const PlanExports& exports);

// Precondition: the plan is one for this map, whatever was asked.
std::vector<io::OutputFile> export_plan(const PlanExports& exports, const Plan& plan, const io::MapFile& map,
                                        const io::MissionDocument& asked);

}  // namespace waybreaker::apps
