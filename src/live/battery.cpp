#include "live/battery.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "model/bases.hpp"
#include "model/in_range.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::live {
namespace {

bool is_down(const Itinerary& planned, const Position& position) {
    const Waypoint& end = planned.path.back();
    return position.finished() && position.at == Point(end.x, end.y);
}

// Whether it breaches from where it begins, which it has begun by now.
bool breaches_at_start(const Agent& was, const Itinerary& planned, double now) {
    const auto stays = [&](const Waypoint& a, const Waypoint& b) {
        return a.x == b.x && a.y == b.y && Point(a.x, a.y) == was.begin() && a.t < now && b.t > was.ready_at + hair;
    };
    return std::ranges::adjacent_find(planned.path, stays) != planned.path.end();
}

// Late at its start, it has not taken off.
bool has_not_begun(const Agent& was, const Itinerary& planned, const Position& position, double now) {
    return was.flown == 0 && !position.on_time && position.doing != Doing::breaching && position.at == was.begin() &&
           !breaches_at_start(was, planned, now);
}

// When it has recharged for the last time, by the end of its base.
std::optional<double> recharged_by(const Itinerary& planned, const Position& position, double ready_at) {
    std::optional<double> last;
    for (const Recharge& recharge : planned.recharges) {
        const std::optional<std::size_t> end = end_of(planned, recharge);
        if (!end || (*end < position.next && !position.has_passed(*end))) continue;
        const double time = position.has_passed(*end) ? recharge.until : position.ahead[*end - position.next + 1].t;
        if (time <= ready_at + hair) last = time;
    }
    return last;
}

// By the end of its base. An aircraft flies from when it is ready until it is down.
double flown_by(const Agent& was, const Itinerary& planned, const Position& position, const AgentState* said,
                double now, double ready_at) {
    const bool down = is_down(planned, position);
    const std::optional<double> recharged = recharged_by(planned, position, ready_at);
    const bool is_to_recharge = recharged && *recharged > now;
    if (said != nullptr && said->flown && !is_to_recharge) {
        const double next = *said->flown > 0 ? now : std::max(now, was.ready_at);  // on the ground until it is ready
        return *said->flown + (down ? 0 : std::max(ready_at - next, 0.0));
    }
    const double landed = position.on_time ? planned.path.back().t : now;
    if (recharged) return std::max((down ? std::min(landed, ready_at) : ready_at) - *recharged, 0.0);
    const double since = has_not_begun(was, planned, position, now) ? std::max(was.ready_at, now) : was.ready_at;
    return was.flown + std::max((down ? std::min(landed, ready_at) : ready_at) - since, 0.0);
}

}  // namespace

void use_battery(const Agent& was, const Itinerary& planned, const Position& position, const AgentState* said,
                 double now, Agent& agent) {
    const double battery = agent.battery();
    if (std::isinf(battery)) return;
    agent.flown = flown_by(was, planned, position, said, now, agent.ready_at);
    const double home = agent.recharge ? Bases(agent).least_landing(agent.begin())
                                       : agent.airspace.length(agent.begin(), agent.goal) / agent.speed;
    // At home, or at a base, an empty battery does not matter.
    if (home == 0) agent.flown = std::min(agent.flown, battery);
    const double needed = agent.flown + home;
    if (std::isinf(needed) || needed <= (1 - agent.reserve) * battery) return;
    if (needed > battery * (1 + hair)) {
        // What it can fly until it recharges.
        Agent flying = agent;
        flying.reserve = 0;
        flying.recharge.reset();
        throw InputError(ErrorCode::contradiction, agent.id,
                         flight_sentence(flying,
                                         agent.recharge ? "from where it is to its goal or a base it"
                                                        : "from where it is to its goal it",
                                         home) +
                             ": send it to a nearer goal, or report it as lost");
    }
    agent.reserve = std::max(1 - needed / battery, 0.0);
}

}  // namespace waybreaker::live
