#include "live/left.hpp"

#include <algorithm>
#include <cmath>

#include "live/detour.hpp"

namespace waybreaker::live {
namespace {

bool same_time(double a, double b) {
    return std::abs(a - b) <= 1e-6 * std::max(1.0, std::abs(b));
}
// By more than rounding, or at once.
bool before(double a, double b) {
    return a < b || same_time(a, b);
}

// A breach on the path of who makes it: the points at which it begins and ends, which are one where it takes no time.
struct Work {
    std::size_t agent;
    std::size_t first;
    std::size_t last;
};

// Of the points at about that time the nearest in time; behind the last if there is none.
std::size_t end_of_work(const Itinerary& agent, const Breach& breach) {
    const std::vector<Waypoint>& path = agent.path;
    std::size_t end = path.size();
    for (std::size_t point = 0; point < path.size(); ++point) {
        // A ground agent stops on a move.
        const bool is_there = path[point].x == breach.at.x && path[point].y == breach.at.y;
        if (agent.kind == AgentKind::air && !is_there) continue;
        const double off = std::abs(path[point].t - breach.cleared_at);
        if (!same_time(path[point].t, breach.cleared_at)) continue;
        if (end == path.size() || off < std::abs(path[end].t - breach.cleared_at)) end = point;
    }
    return end;
}

std::optional<Work> work_of(const Report& report, const Breach& breach) {
    for (std::size_t i = 0; i < report.plan.agents.size(); ++i) {
        const Itinerary& agent = report.plan.agents[i];
        const bool flies = agent.kind == AgentKind::air;
        if (breach.by.empty() ? !flies : agent.id != breach.by) continue;
        const std::vector<Waypoint>& path = agent.path;
        const Obstacle& obstacle = report.map.obstacle(breach.obstacle);
        const double begun =
            breach.cleared_at - time_to_breach(report.mission.agents[i], obstacle, report.mission.rules);
        const std::size_t last = end_of_work(agent, breach);
        if (last == path.size()) continue;
        std::size_t first = last;
        while (first > 0 && same_place(path[first - 1], path[last]) && !before(path[first].t, begun)) --first;
        return Work{i, first, last};
    }
    return std::nullopt;
}

bool is_among(const std::vector<TimedOpening>& list, ObstacleId id) {
    return std::ranges::find(list, id, &TimedOpening::obstacle) != list.end();
}

// The point at which the work is done, of those ahead.
std::size_t end_ahead(const Work& work, const Position& position) {
    return work.last - position.next + 1;
}

bool is_at_work(const Work& work, const Position& position) {
    return work.first < position.next && work.last >= position.next;
}

// Whether an agent that is to be at work by now waits, or is somewhere else.
bool has_left_off(const Report& report, const Work& work, const Position& position) {
    constexpr double beside = 0.5;  // cells: who leaves, or comes, is beside the place of its breach
    if (position.doing == Doing::breaching) return false;
    const Itinerary& agent = report.plan.agents[work.agent];
    const Waypoint& place = agent.path[work.last];
    const bool is_away = agent.kind == AgentKind::air && distance(position.at, Point(place.x, place.y)) > beside;
    return position.doing == Doing::waiting || is_away;
}

// The work, from now on or from when it is back, for as long as it takes.
void begin_again(const Report& report, const Breach& breach, const Work& work, Position& position) {
    const Agent& agent = report.mission.agents[work.agent];
    std::vector<Waypoint>& ahead = position.ahead;
    const std::size_t end = end_ahead(work, position);
    const double takes = time_to_breach(agent, report.map.obstacle(breach.obstacle), report.mission.rules);
    const Waypoint last = ahead[end];
    const double begins = ahead[0].t + distance(position.at, Point(last.x, last.y)) / agent.speed;
    for (std::size_t i = end; i < ahead.size(); ++i) ahead[i].t += begins + takes - last.t;
    std::vector<Waypoint> places(work.last - work.first, {last.x, last.y, begins});
    ahead.erase(ahead.begin() + 1, ahead.begin() + std::ptrdiff_t(end));
    ahead.insert(ahead.begin() + 1, places.begin(), places.end());
    position.next = work.first;
    position.on_time = false;
}

// When the work is done, if it is done or has begun by `decided`.
std::optional<double> done_at(const Report& report, const Work& work, const Position& position, const Breach& breach) {
    if (position.has_passed(work.last)) return std::min(breach.cleared_at, report.state.now);
    const bool goes_on = position.doing == Doing::moving || position.doing == Doing::breaching;
    if (!goes_on || work.last < position.next) return std::nullopt;
    const double ends = position.ahead[end_ahead(work, position)].t;
    if (ends <= report.decided) return ends;
    if (is_at_work(work, position)) return ends;
    return position.ahead[work.first - position.next + 1].t < report.decided ? std::optional(ends) : std::nullopt;
}

void forget(std::vector<ObstacleId>& ids, ObstacleId id) {
    std::erase(ids, id);
}

// It may be tried again, unless it has been too often.
void add_failure(ObstacleId obstacle, Rules& rules) {
    rules.failed.push_back(obstacle);
    if (std::ranges::count(rules.failed, obstacle) <= rules.retries) return;
    forget(rules.force, obstacle);
    if (std::ranges::find(rules.protect, obstacle) == rules.protect.end()) rules.protect.push_back(obstacle);
}

}  // namespace

const AgentState* Report::of(const std::string& agent) const {
    const auto found = std::ranges::find(state.agents, agent, &AgentState::id);
    return found == state.agents.end() ? nullptr : &*found;
}

std::vector<Position> positions_of(const Report& report) {
    std::vector<Position> positions;
    for (const Itinerary& agent : report.plan.agents) {
        positions.push_back(position_of(agent, report.of(agent.id), report.state.now));
        if (agent.kind == AgentKind::air)
            fly_round_zones(report.map, report.mission.agents[positions.size() - 1], positions.back());
    }
    for (const Breach& breach : report.plan.breaches) {
        const auto said = std::ranges::find(report.state.opened, breach.obstacle, &TimedOpening::obstacle);
        const std::optional<Work> work = work_of(report, breach);
        if (!work || !is_at_work(*work, positions[work->agent]) || is_among(report.state.failed, breach.obstacle))
            continue;
        Position& position = positions[work->agent];
        if (said == report.state.opened.end()) {
            if (has_left_off(report, *work, position)) begin_again(report, breach, *work, position);
            continue;
        }
        // Work that has begun late ends when it is said to.
        if (said->at <= report.state.now) continue;
        const double later = said->at - position.ahead[end_ahead(*work, position)].t;
        if (same_time(later, 0)) continue;
        position.on_time = false;
        for (std::size_t i = end_ahead(*work, position); i < position.ahead.size(); ++i) position.ahead[i].t += later;
    }
    return positions;
}

std::vector<Outlook> outlooks_of(const Report& report, std::span<const Position> positions) {
    std::vector<Outlook> outlooks;
    for (const Breach& breach : report.plan.breaches) {
        Outlook& outlook = outlooks.emplace_back();
        outlook.failed = is_among(report.state.failed, breach.obstacle);
        const auto said = std::ranges::find(report.state.opened, breach.obstacle, &TimedOpening::obstacle);
        const std::optional<Work> work = work_of(report, breach);
        if (said != report.state.opened.end()) {
            outlook.opens = said->at;
        } else if (work && !outlook.failed) {
            outlook.opens = done_at(report, *work, positions[work->agent], breach);
        }
    }
    return outlooks;
}

double bound_until(const Report& report, std::size_t agent, const Position& position) {
    double until = report.decided;
    for (const Breach& breach : report.plan.breaches) {
        const std::optional<Work> work = work_of(report, breach);
        if (!work || work->agent != agent || is_among(report.state.failed, breach.obstacle)) continue;
        if (const auto done = done_at(report, *work, position, breach)) until = std::max(until, *done);
    }
    const Itinerary& planned = report.plan.agents[agent];
    for (const Recharge& recharge : planned.recharges) {
        const std::optional<std::size_t> end = end_of(planned, recharge);
        if (!end || *end < position.next) continue;
        const bool stands = *end == position.next;
        if (stands || position.ahead[*end - position.next].t <= until)
            until = std::max(until, position.ahead[*end - position.next + 1].t);
    }
    return until;
}

std::vector<Zone> zones_for(std::vector<Zone> zones, std::span<const Agent> agents) {
    std::erase_if(zones, [agents](Zone& zone) {
        const auto is_gone = [agents](const std::string& id) {
            return std::ranges::find(agents, id, &Agent::id) == agents.end();
        };
        return std::erase_if(zone.agents, is_gone) > 0 && zone.agents.empty();
    });
    return zones;
}

Mission left_of(const Report& report, std::span<const Outlook> outlooks) {
    Mission left = report.mission;
    Rules& rules = left.rules;
    const auto tried_by = [&](const Breach& breach) -> Agent* {
        const std::optional<Work> work = work_of(report, breach);
        if (!work) return nullptr;
        const auto agent = std::ranges::find(left.agents, report.plan.agents[work->agent].id, &Agent::id);
        return agent == left.agents.end() ? nullptr : &*agent;
    };
    for (std::size_t i = 0; i < outlooks.size(); ++i) {
        const Breach& breach = report.plan.breaches[i];
        if (!outlooks[i].failed && !outlooks[i].opens) continue;
        if (Agent* agent = tried_by(breach); agent != nullptr) {
            int& left_to_it = agent->kind == AgentKind::air ? agent->breaches : agent->own_breaches;
            if (left_to_it != any_number) left_to_it = std::max(left_to_it - 1, 0);
        }
        if (outlooks[i].failed) {
            add_failure(breach.obstacle, rules);
            continue;
        }
        rules.opened.push_back({breach.obstacle, outlooks[i].opens.value_or(report.state.now)});
        rules.removals = std::max(rules.removals - 1, 0);
        rules.budget = std::max(rules.budget - report.map.obstacle(breach.obstacle).weight, 0.0);
        forget(rules.force, breach.obstacle);
    }
    // What had begun before the plan was made, and has failed since.
    for (const TimedOpening& failure : report.state.failed) {
        if (!is_among(rules.opened, failure.obstacle)) continue;
        std::erase_if(rules.opened, [&](const TimedOpening& opened) { return opened.obstacle == failure.obstacle; });
        ++rules.removals;
        rules.budget += report.map.obstacle(failure.obstacle).weight;
        add_failure(failure.obstacle, rules);
    }
    // What others have opened.
    for (const TimedOpening& opening : report.state.opened) {
        if (is_among(rules.opened, opening.obstacle)) continue;
        rules.opened.push_back(opening);
        forget(rules.force, opening.obstacle);
    }
    std::ranges::sort(rules.opened, {}, &TimedOpening::obstacle);
    std::ranges::sort(rules.protect);
    // Whose start is somewhere else from now on.
    for (Agent& agent : left.agents) {
        if (agent.recharge && agent.bases.empty()) agent.bases = {agent.start, agent.goal};
    }
    return left;
}

}  // namespace waybreaker::live
