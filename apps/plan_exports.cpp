#include "plan_exports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "authors/plan_xml.hpp"
#include "format_losses.hpp"
#include "geotiff/georeference.hpp"
#include "geotiff/time_tiff.hpp"
#include "io/plan_csv.hpp"
#include "io/plan_geojson.hpp"
#include "io/plan_ros_path.hpp"
#include "mapfile/map_info.hpp"
#include "mapfile/map_writer.hpp"
#include "mapfile/relabelled_map.hpp"
#include "mission/reach.hpp"
#include "option.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

std::vector<io::OutputFile> opened_map(const std::string& path, const Plan& plan, const io::MapFile& map) {
    std::vector<ObstacleId> removed;
    for (const Breach& breach : plan.breaches) removed.push_back(breach.obstacle);
    mapfile::WrittenMap written = mapfile::write_map(mapfile::without_obstacles(map, removed), path);
    report_losses(path, written.losses);
    return std::move(written.files);
}

std::string reach_tiff(const Plan& plan, const io::MapFile& map, const io::MissionDocument& asked) {
    const std::optional<Reach> reach = reach_of(map.map, asked.mission, plan);
    if (!reach) {
        throw InputError(
            "--reach is for vehicles that do not collide, have one speed and radius, and go from at most 16 starts to "
            "more goals, or from more starts to at most 16 goals, as waybreaker missions access has them");
    }
    return geotiff::time_tiff_bytes({.width = map.map.width(),
                                     .height = map.map.height(),
                                     .cell_size = map.cell_size,
                                     .georeference = map.georeference,
                                     .origin = map.origin,
                                     .bands = {{"before", reach->before}, {"after", reach->after}}});
}

}  // namespace

void add_plan_exports(CLI::App& command, PlanExports& exports) {
    add_file(command, "--geojson", exports.geojson,
             "Write paths, breach points and removed obstacles in longitude and latitude, for GIS");
    add_file(command, "--csv", exports.csv, "Write the timed waypoints: cells, metres, longitude and latitude");
    add_file(command, "--ros-path", exports.ros_path,
             "Write the paths as YAML of ROS's nav_msgs/Path, one for each agent, in metres of the map's frame");
    add_file(
        command, "--ros-parts", exports.ros_parts,
        "Write the same paths cut where an agent waits and before each opening, for controllers that ignore times");
    add_number(
        command, "--step", [&exports](double metres) { exports.step = metres; }, {0.001, 1e6}, "METRES",
        "Most distance between two poses of --ros-path and --ros-parts; corners have one in any case (default: the "
        "side of a cell)");
    add_file(command, "--opened-map", exports.opened_map,
             "Write the map after the removals, in the format that the file's name ends in, as waybreaker map convert");
    add_file(command, "--xml", exports.xml, "Write the log of the authors' program");
    add_file(command, "--reach", exports.reach,
             "Of a mission with many places: write by when each cell is reached, before and after the removals, as two "
             "bands of a GeoTIFF");
    add_field_exports(command, exports.field);
}

void validate(const PlanExports& exports) {
    if (exports.step && exports.ros_path.empty() && exports.ros_parts.empty())
        throw InputError("--step is how far apart poses of ROS paths are; add --ros-path FILE or --ros-parts FILE");
    validate(exports.field);
}

NamedFiles named_outputs(const PlanExports& exports) {
    NamedFiles outputs{{"--geojson", exports.geojson},
                       {"--csv", exports.csv},
                       {"--ros-path", exports.ros_path},
                       {"--ros-parts", exports.ros_parts},
                       {"--opened-map", exports.opened_map},
                       {"--xml", exports.xml},
                       {"--reach", exports.reach}};
    std::ranges::move(named_outputs(exports.field), std::back_inserter(outputs));
    return outputs;
}

std::vector<io::OutputFile> export_plan(const PlanExports& exports, const Plan& plan, const io::MapFile& map,
                                        const io::MissionDocument& asked) {
    const io::ExportUnits units{.in_seconds = asked.in_seconds, .crs = mapfile::frame_crs(map)};
    std::vector<io::OutputFile> files;
    if (!exports.geojson.empty())
        files.push_back({exports.geojson, io::plan_geojson(plan, map, geotiff::lon_lat_of(map.georeference), units)});
    if (!exports.csv.empty())
        files.push_back({exports.csv, io::plan_csv(plan, map, geotiff::lon_lat_of(map.georeference), units)});
    if (!exports.ros_path.empty()) files.push_back({exports.ros_path, io::plan_ros_path(plan, map, exports.step)});
    if (!exports.ros_parts.empty())
        files.push_back({exports.ros_parts, io::plan_ros_parts(plan, map, asked.mission, exports.step)});
    if (!exports.xml.empty()) {
        const SearchOptions search = search_options(asked.method, asked.mission.ground_body());
        files.push_back({exports.xml, authors::plan_xml(plan, map, search)});
    }
    // Without a plan nothing is reached; whoever asked says so.
    if (!exports.reach.empty() && plan.status == PlanStatus::solved)
        files.push_back({exports.reach, reach_tiff(plan, map, asked)});
    if (!exports.opened_map.empty())
        std::ranges::move(opened_map(exports.opened_map, plan, map), std::back_inserter(files));
    std::ranges::move(export_plan(exports.field, plan, map, asked), std::back_inserter(files));
    return files;
}

}  // namespace waybreaker::apps
