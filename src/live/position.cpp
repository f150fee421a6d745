#include "live/position.hpp"

#include <algorithm>
#include <cmath>

namespace waybreaker::live {
namespace {

// An agent so near to where it was to be is on time, in cells.
constexpr double near_enough = 1e-6;

Point place(const Waypoint& p) {
    return {p.x, p.y};
}

// Whether it stays there for as long as a breach takes, or rubble.
bool works_until(const Itinerary& agent, std::size_t point) {
    if (agent.kind == AgentKind::air) return true;
    return std::ranges::any_of(agent.waits, [&](const Wait& wait) {
        const bool works = wait.agent == agent.id || wait.reason == WaitReason::rubble;
        return works && std::abs(wait.until - agent.path[point].t) <= near_enough;
    });
}

// It may have landed late: from now on, for all the time that it takes.
bool recharges_until(const Itinerary& agent, double time) {
    return std::ranges::find(agent.recharges, time, &Recharge::until) != agent.recharges.end();
}

}  // namespace

std::vector<Waypoint> Position::flight() const {
    std::vector<Waypoint> path = ahead;
    path.insert(path.begin() + 1, detour.begin(), detour.end());
    return path;
}

std::optional<std::size_t> end_of(const Itinerary& agent, const Recharge& recharge) {
    const auto is_end = [&](const Waypoint& p) { return p.t == recharge.until && place(p) == Point(recharge.at); };
    const auto end = std::ranges::find_if(agent.path, is_end);
    if (end == agent.path.end()) return std::nullopt;
    return std::size_t(end - agent.path.begin());
}

Waypoint place_on(const std::vector<Waypoint>& path, double time) {
    const auto after = std::ranges::upper_bound(path, time, {}, &Waypoint::t);
    if (after == path.begin()) return {path.front().x, path.front().y, time};
    const Waypoint& a = *std::prev(after);
    if (after == path.end() || time == a.t) return {a.x, a.y, time};
    const double share = (time - a.t) / (after->t - a.t);
    return {a.x + share * (after->x - a.x), a.y + share * (after->y - a.y), time};
}

std::vector<Waypoint> until(const std::vector<Waypoint>& path, double time) {
    std::vector<Waypoint> part;
    for (const Waypoint& p : path) {
        if (p.t <= time) part.push_back(p);
    }
    if (part.empty() || part.back().t < time) part.push_back(place_on(path, time));
    return part;
}

Position position_of(const Itinerary& agent, const AgentState* state, double now) {
    const std::vector<Waypoint>& path = agent.path;
    Position position;
    // As planned.
    const auto after = std::ranges::upper_bound(path, now, {}, &Waypoint::t);
    const Waypoint planned = place_on(path, now);
    position.next = std::size_t(after - path.begin());
    position.at = place(planned);
    if (state != nullptr) {
        position.doing = state->doing;
        const bool between =
            state->passed + 1 == position.next || (position.next == path.size() && state->passed + 1 == path.size());
        Point at = between ? position.at : place(path[state->passed]);
        if (state->at) at = *state->at;
        position.on_time = between && distance(at, position.at) <= near_enough;
        if (!position.on_time) {
            position.next = state->passed + 1;
            position.at = at;
        }
    }
    position.ahead.push_back({position.at.x, position.at.y, now});
    for (std::size_t i = position.next; i < path.size(); ++i) {
        const Waypoint& last = position.ahead.back();
        const double driven = distance(place(last), place(path[i]));
        const bool stays = i > 0 && same_place(path[i - 1], path[i]);
        const bool works = i > position.next && works_until(agent, i);
        double t = path[i].t;
        if (!position.on_time) {
            const double stays_until = works || recharges_until(agent, path[i].t) ? last.t + (path[i].t - path[i - 1].t)
                                                                                  : std::max(path[i].t, last.t);
            t = stays && driven == 0 ? stays_until : last.t + driven / agent.speed;
        }
        position.ahead.push_back({path[i].x, path[i].y, t});
    }
    position.stands = position.finished() || same_place(position.ahead[0], position.ahead[1]) ||
                      position.doing == Doing::waiting || position.doing == Doing::stopped;
    return position;
}

}  // namespace waybreaker::live
