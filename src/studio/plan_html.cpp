#include "studio/plan_html.hpp"

#include <nlohmann/json.hpp>

#include "io/background_json.hpp"
#include "io/check_report.hpp"
#include "io/obstacles_json.hpp"
#include "io/plan_file.hpp"
#include "mapfile/map_info.hpp"
#include "render/plan_picture.hpp"
#include "studio/plan_page.hpp"

namespace waybreaker::studio {

std::string plan_html(const io::MapFile& map, std::span<const NamedPlan> plans, const std::string& front) {
    using Json = nlohmann::ordered_json;
    auto description = Json::parse(mapfile::map_info_json(map));
    description["id"] = map.source;
    std::string data = "{\"map\": " + description.dump() + ",\"obstacles\": " + io::obstacles_json(map) +
                       ",\"background\": " + io::background_json(map.annotations.background) + ",\n\"plans\": [";
    StillPlan still{.title = "Plan: " + map.name()};
    for (const NamedPlan& plan : plans) {
        const io::PlanFile file = io::parse_plan(plan.json, "the plan");
        if (data.back() == '[') {
            still.sentence = render::plan_sentence(map, file);
            still.picture = render::plan_svg(map, file);
        } else {
            data += ',';
        }
        const std::string check = io::check_json(io::judge(file, map));
        data += R"({"name": ")" + plan.name + R"(", "plan": )" + plan.json + ", \"check\": " + check + "}";
    }
    data += "]";
    if (!front.empty()) data += ",\n\"front\": " + Json::parse(front)["front"].dump();
    data += "}";
    return plan_page(still, data);
}

}  // namespace waybreaker::studio
