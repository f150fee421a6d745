#include "render/reach_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "render/bands.hpp"
#include "render/caption.hpp"
#include "render/plan_picture.hpp"

namespace waybreaker::render {
namespace {

using Json = nlohmann::ordered_json;

// By hand, for there can be millions.
std::string runs(const std::vector<std::uint32_t>& cells) {
    std::string text;
    for (auto from = cells.begin(); from != cells.end();) {
        const auto to = std::find_if(from, cells.end(), [from](std::uint32_t cell) { return cell != *from; });
        fmt::format_to(std::back_inserter(text), "{}{},{}", text.empty() ? "" : ",", *from, to - from);
        from = to;
    }
    return "[" + text + "]";
}

}  // namespace

std::string reach_json(const io::MapFile& map, const io::PlanFile& plan, const std::optional<Reach>& reach) {
    Json json{{"format", "waybreaker-reach/1"}, {"width", map.map.width()}, {"height", map.map.height()}};
    if (!reach) {
        json["bands"] = Json::array();
        return json.dump() + "\n";
    }
    json["inbound"] = reach->inbound;
    for (const Cell hub : reach->hubs) json["hubs"].push_back({hub.x, hub.y});
    const Mission& mission = plan.asked.mission;
    const double factor = time_factor(mission, picture_options(map, plan.asked, plan.plan));
    const Bands bands(*reach, mission, factor);
    for (std::size_t i = 0; i < bands.count(); ++i) json["bands"].push_back(bands.end(i) / factor);
    json["sooner"] = bands.clear_gain() / factor;
    const BandRaster cells = band_raster(map.map, plan.plan, *reach, bands, 1);
    std::string text = json.dump();
    text.pop_back();
    return fmt::format("{},\"before\":{},\"after\":{},\"gains\":{}}}\n", text, runs(cells.before), runs(cells.after),
                       runs(cells.gains));
}

}  // namespace waybreaker::render
