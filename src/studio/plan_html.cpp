#include "studio/plan_html.hpp"

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "io/background_json.hpp"
#include "io/check_report.hpp"
#include "io/map_document.hpp"
#include "io/obstacles_json.hpp"
#include "io/plan_file.hpp"
#include "mapfile/map_info.hpp"
#include "mission/reach.hpp"
#include "render/plan_picture.hpp"
#include "render/reach_json.hpp"
#include "studio/plan_page.hpp"

namespace waybreaker::studio {

namespace {

StillPlan still_of(const io::MapFile& map, const io::PlanFile& plan, std::optional<Reach> reach) {
    return {.title = "Plan: " + map.name(),
            .sentence = render::plan_sentence(map, plan),
            .picture = render::plan_svg(map, plan, std::move(reach))};
}

std::optional<Reach> reach_on(const io::MapFile& map, const io::PlanFile& plan) {
    return reach_of(map.map, plan.asked.mission, plan.plan);
}

}  // namespace

std::string plan_html(const io::MapFile& map, std::span<const NamedPlan> plans, const std::string& front) {
    using Json = nlohmann::ordered_json;
    auto description = Json::parse(mapfile::map_info_json(map));
    description["id"] = map.source;
    std::string data = "{\"map\": " + description.dump() + ",\"obstacles\": " + io::obstacles_json(map) +
                       ",\"background\": " + io::background_json(map.annotations.background) + ",\n\"plans\": [";
    for (const NamedPlan& plan : plans) {
        const io::PlanFile file = io::parse_plan(plan.json, "the plan");
        if (data.back() != '[') data += ',';
        const std::string check = io::check_json(io::judge(file, map));
        data += R"({"name": ")" + plan.name + R"(", "plan": )" + plan.json + ", \"check\": " + check + "}";
    }
    data += "]";
    if (!front.empty()) data += ",\n\"front\": " + Json::parse(front)["front"].dump();
    const io::PlanFile first = io::parse_plan(plans.front().json, "the plan");
    const std::optional<Reach> reach = reach_on(map, first);
    if (reach) data += ",\n\"reach\": " + render::reach_json(map, first, reach);
    data += "}";
    return plan_page(still_of(map, first, reach), data);
}

std::string steerable_html(const io::MapFile& map, Connectivity connectivity, const std::string& plan,
                           std::string planner) {
    const io::MapPlace place{.georeference = mapfile::georeference_json(map), .frame_crs = mapfile::frame_crs(map)};
    const io::PlanFile file = io::parse_plan(plan, "the plan");
    return plan_page(still_of(map, file, reach_on(map, file)),
                     CarriedPlanner{.map = io::map_document(map.source, {map, connectivity, place}),
                                    .plan = plan,
                                    .planner = std::move(planner)});
}

}  // namespace waybreaker::studio
