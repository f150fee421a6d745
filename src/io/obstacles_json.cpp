#include "io/obstacles_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;

// By hand, for there can be millions.
std::string runs_json(std::span<const std::uint32_t> labels) {
    std::string text = "[";
    for (auto run = labels.begin(); run != labels.end();) {
        const auto end = std::find_if(run, labels.end(), [run](std::uint32_t label) { return label != *run; });
        if (text.size() > 1) text += ',';
        fmt::format_to(std::back_inserter(text), "{},{}", *run, end - run);
        run = end;
    }
    return text + "]";
}

}  // namespace

std::string obstacles_json(const MapFile& file) {
    const Map& map = file.map;
    std::string text = fmt::format(R"({{"width":{},"height":{},"obstacles":[)", map.width(), map.height());
    for (const Obstacle& obstacle : map.obstacles()) {
        const Box& box = obstacle.bounds;
        const Json json{{"id", obstacle.id.value},
                        {"source_id", obstacle.source_id},
                        {"name", file.name_of(obstacle.id)},
                        {"cells", obstacle.cells},
                        {"bounds", {box.min.x, box.min.y, box.max.x, box.max.y}},
                        {"destructible", obstacle.destructible},
                        {"weight", obstacle.weight},
                        {"breach_time", obstacle.breach_time}};
        if (text.back() != '[') text += ',';
        text += json.dump(-1, ' ', false, Json::error_handler_t::replace);
    }
    return text + "],\"runs\":" + runs_json(map.labels()) + "}\n";
}

}  // namespace waybreaker::io
