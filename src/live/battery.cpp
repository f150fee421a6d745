#include "live/battery.hpp"

#include <algorithm>
#include <cmath>

#include "model/in_range.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::live {
namespace {

bool is_down(const Itinerary& planned, const Position& position) {
    const Waypoint& end = planned.path.back();
    return position.finished() && position.at == Point(end.x, end.y);
}

// Late at its start, it has not taken off.
bool has_not_begun(const Agent& was, const Position& position) {
    return was.flown == 0 && !position.on_time && position.doing != Doing::breaching && position.at == was.begin();
}

// By the end of its base. An aircraft flies from when it is ready until it is down.
double flown_by(const Agent& was, const Itinerary& planned, const Position& position, const AgentState* said,
                double now, double ready_at) {
    const bool down = is_down(planned, position);
    if (said != nullptr && said->flown) {
        const double next = *said->flown > 0 ? now : std::max(now, was.ready_at);  // on the ground until it is ready
        return *said->flown + (down ? 0 : std::max(ready_at - next, 0.0));
    }
    const double since = has_not_begun(was, position) ? std::max(was.ready_at, now) : was.ready_at;
    const double landed = position.on_time ? planned.path.back().t : now;
    return was.flown + std::max((down ? std::min(landed, ready_at) : ready_at) - since, 0.0);
}

}  // namespace

void use_battery(const Agent& was, const Itinerary& planned, const Position& position, const AgentState* said,
                 double now, Agent& agent) {
    const double battery = agent.battery();
    if (std::isinf(battery)) return;
    agent.flown = flown_by(was, planned, position, said, now, agent.ready_at);
    const double home = agent.airspace.length(agent.begin(), agent.goal) / agent.speed;
    // At home, an empty battery does not matter.
    if (home == 0) agent.flown = std::min(agent.flown, battery);
    const double needed = agent.flown + home;
    if (std::isinf(needed) || needed <= (1 - agent.reserve) * battery) return;
    if (needed > battery * (1 + hair)) {
        agent.reserve = 0;
        throw InputError(ErrorCode::contradiction, agent.id,
                         flight_sentence(agent, "from where it is to its goal it", home) +
                             ": send it to a nearer goal, or report it as lost");
    }
    agent.reserve = std::max(1 - needed / battery, 0.0);
}

}  // namespace waybreaker::live
