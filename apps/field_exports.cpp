#include "field_exports.hpp"

#include <fmt/format.h>

#include "exports/plan_gpx.hpp"
#include "exports/plan_kml.hpp"
#include "exports/utc_time.hpp"
#include "geotiff/georeference.hpp"
#include "note.hpp"
#include "option.hpp"

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
    add_file(command, "--kml", exports.kml,
             "Write tracks with times, breaches, and obstacles until and after they open, as KML, for Google Earth");
    add_start_time(command, exports);
    add_number(
        command, "--altitude", [&exports](double metres) { exports.altitude = metres; }, {0.1, 1e5}, "METRES",
        "Height of all flights above the place of take-off, for --kml (default there: on the ground)");
}

NamedFiles named_outputs(const FieldExports& exports) {
    return {{"--gpx", exports.gpx}, {"--kml", exports.kml}};
}

std::vector<std::pair<std::string, std::string>> export_plan(const FieldExports& exports, const Plan& plan,
                                                             const io::MapFile& map, const io::MissionDocument& asked) {
    const exports::PlacedPlan placed{.plan = plan,
                                     .map = map,
                                     .to_lon_lat = geotiff::lon_lat_of(map.georeference),
                                     .starts_at = exports.starts_at,
                                     .altitude = exports.altitude};
    std::vector<std::pair<std::string, std::string>> files;
    if (!exports.gpx.empty()) files.emplace_back(exports.gpx, exports::plan_gpx(placed));
    if (!exports.kml.empty()) files.emplace_back(exports.kml, exports::plan_kml(placed));
    if (!files.empty() && !asked.in_seconds) {
        note(option_of(exports),
             "a unit of the plan's time counts as a second; give speeds such as 1.5m/s to plan in seconds");
    }
    return files;
}

}  // namespace waybreaker::apps
