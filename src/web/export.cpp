#include "web/export.hpp"

#include <array>

#include "io/check_report.hpp"
#include "io/plan_csv.hpp"
#include "io/plan_geojson.hpp"
#include "mission/reach.hpp"
#include "render/plan_picture.hpp"
#include "render/reach_json.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::web {
namespace {

// The map's own straight line to longitude and latitude, good to a cell; empty where it has none.
site::ToLonLat to_lon_lat(const io::MapPlace& place) {
    if (place.georeference.is_null() || !place.georeference.contains("to_lon_lat")) return {};
    const nlohmann::ordered_json& affine = place.georeference["to_lon_lat"];
    if (!affine.is_array() || affine.size() != 6) return {};
    const auto by = affine.get<std::array<double, 6>>();
    return [by](Point point) -> std::array<double, 2> {
        return {by[0] * point.x + by[1] * point.y + by[2], by[3] * point.x + by[4] * point.y + by[5]};
    };
}

}  // namespace

std::string exported(const io::DocumentedMap& map, const std::string& bytes, const std::string& format) {
    const io::PlanFile plan = io::parse_plan(bytes, "the plan");
    if (const auto violations = io::judge(plan, map.file); !violations.empty()) {
        throw InputError("the plan is not valid: " + violations.front().message);
    }
    const io::ExportUnits units{.in_seconds = plan.asked.in_seconds, .crs = map.place.frame_crs};
    if (format == "json") return bytes;
    if (format == "geojson") return io::plan_geojson(plan.plan, map.file, to_lon_lat(map.place), units);
    if (format == "csv") return io::plan_csv(plan.plan, map.file, to_lon_lat(map.place), units);
    const auto reach = [&] { return reach_of(map.file.map, plan.asked.mission, plan.plan); };
    if (format == "reach") return render::reach_json(map.file, plan, reach());
    if (format != "svg") throw InputError("the format is none of json, geojson, csv, svg, reach");
    if (plan.plan.agents.empty()) throw InputError("the plan has no agents to draw");
    return render::plan_svg(map.file, plan, reach());
}

}  // namespace waybreaker::web
