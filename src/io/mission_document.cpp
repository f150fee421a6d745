#include "io/mission_document.hpp"

#include <utility>

#include "io/tagged_obstacles.hpp"
#include "io/weights.hpp"

namespace waybreaker::io {

std::optional<Map> resolve(MissionDocument& document, const MapFile& file,
                           const std::optional<std::vector<double>>& weights) {
    protect_tagged(file, std::exchange(document.protect_tags, {}), document.mission.rules);
    if (document.area_budget) return file.map.with_weights(area_weights(file));
    if (weights) return file.map.with_weights(*weights);
    return std::nullopt;
}

}  // namespace waybreaker::io
