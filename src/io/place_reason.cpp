#include "io/place_reason.hpp"

#include "site/unknown_ground.hpp"

namespace waybreaker::io {

bool is_in_unknown(const Misplaced& agent, const MapFile& map) {
    return agent.obstacle && site::unknown_obstacles(map.map, map.annotations.tags)[agent.obstacle.value];
}

std::string place_reason(const Misplaced& agent, const MapFile& map) {
    return is_in_unknown(agent, map) ? "lies in unknown ground, of which there is no data" : agent.reason;
}

}  // namespace waybreaker::io
