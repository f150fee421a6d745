#include "field_exports.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "exports/plan_gpx.hpp"
#include "exports/plan_kml.hpp"
#include "exports/plan_qgc.hpp"
#include "exports/plan_vda5050.hpp"
#include "exports/utc_time.hpp"
#include "geotiff/georeference.hpp"
#include "note.hpp"
#include "option.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

void add_start_time(CLI::App& command, FieldExports& exports) {
    command
        .add_option_function<std::string>(
            "--starts-at",
            [&exports](const std::string& given) {
                const auto seconds = exports::parse_utc(given);
                if (!seconds) {
                    throw CLI::ValidationError(
                        "--starts-at",
                        fmt::format("'{}' is no time in UTC, such as 2026-05-01T08:00:00Z", shown(given)));
                }
                exports.starts_at = *seconds;
            },
            "When the plan begins, in UTC, for formats that have dates: 2026-05-01T08:00:00Z (default: "
            "1970-01-01T00:00:00Z, so that times count from the start)")
        ->type_name("TIME");
}

void add_breach_command(CLI::App& command, FieldExports& exports) {
    command
        .add_option_function<std::string>(
            "--breach-command",
            [&exports](const std::string& given) {
                const auto action = exports::parse_mav_action(given);
                if (!action) {
                    throw CLI::ValidationError(
                        "--breach-command",
                        fmt::format("'{}' is no command of MAVLink with up to seven parameters, such as "
                                    "DO_SET_RELAY:0,1 or 181:0,1; names are {}",
                                    shown(given), fmt::join(exports::mav_action_names(), ", ")));
                }
                exports.breach = *action;
            },
            "What --qgc has an aircraft do where it breaches: a command of MAVLink by its name or number, with its "
            "parameters (default: DO_SET_RELAY:0,1)")
        ->type_name("COMMAND[:P,...]")
        ->needs("--qgc");
}

// The first option that names a file.
std::string option_of(const FieldExports& exports) {
    for (const auto& [option, file] : named_outputs(exports)) {
        if (!file.empty()) return option;
    }
    return {};
}

}  // namespace

void add_field_exports(CLI::App& command, FieldExports& exports) {
    add_file(command, "--gpx", exports.gpx,
             "Write a track with times for each agent and a way point for each breach, as GPX");
    add_file(
        command, "--kml", exports.kml,
        "Write tracks with times, breaches, obstacles until and after they open, and zones, as KML, for Google Earth");
    add_file(command, "--qgc", exports.qgc,
             "Write the flight of each aircraft, and a fence round its no-fly zones, as a .plan file of "
             "QGroundControl; several aircraft have a file each, their ids before the ending: FILE-ID.plan; one that "
             "recharges a file for each flight: FILE-1.plan");
    add_file(command, "--vda5050", exports.vda5050,
             "Write orders of VDA 5050 3.0 for the vehicles, released up to each opening, and zones of what opens "
             "and what they keep out of, as JSON");
    add_start_time(command, exports);
    add_number(
        command, "--altitude", [&exports](double metres) { exports.altitude = metres; }, {0.1, 1e5}, "METRES",
        "Height of all flights above the place of take-off: --qgc needs it; in --kml aircraft keep to the ground "
        "without it");
    add_breach_command(command, exports);
}

void validate(const FieldExports& exports) {
    if (!exports.qgc.empty() && !exports.altitude)
        throw InputError(
            "--qgc needs to know how high aircraft fly above the place of take-off; give --altitude METRES");
}

NamedFiles named_outputs(const FieldExports& exports) {
    return {{"--gpx", exports.gpx}, {"--kml", exports.kml}, {"--qgc", exports.qgc}, {"--vda5050", exports.vda5050}};
}

std::vector<io::OutputFile> export_plan(const FieldExports& exports, const Plan& plan, const io::MapFile& map,
                                        const io::MissionDocument& asked) {
    const exports::PlacedPlan placed{.plan = plan,
                                     .map = map,
                                     .to_lon_lat = geotiff::lon_lat_of(map.georeference),
                                     .starts_at = exports.starts_at,
                                     .altitude = exports.altitude,
                                     .zones = asked.mission.rules.zones};
    std::vector<io::OutputFile> files;
    if (!exports.gpx.empty()) files.push_back({exports.gpx, exports::plan_gpx(placed)});
    if (!exports.kml.empty()) files.push_back({exports.kml, exports::plan_kml(placed)});
    if (!exports.qgc.empty())
        std::ranges::move(plan_qgc(placed, exports.qgc, exports.breach), std::back_inserter(files));
    if (!exports.vda5050.empty()) files.push_back({exports.vda5050, exports::plan_vda5050(placed, asked.mission)});
    if (!files.empty() && !asked.in_seconds) {
        note(option_of(exports),
             "a unit of the plan's time counts as a second; give speeds such as 1.5m/s to plan in seconds");
    }
    return files;
}

}  // namespace waybreaker::apps
