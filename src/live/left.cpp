#include "live/left.hpp"

#include <algorithm>
#include <cmath>

namespace waybreaker::live {
namespace {

bool same_time(double a, double b) {
    return std::abs(a - b) <= 1e-6 * std::max(1.0, std::abs(b));
}
// By more than rounding, or at once.
bool before(double a, double b) {
    return a < b || same_time(a, b);
}

// A breach on the path of its aircraft: the points at which it begins and ends, which are one where it takes no time.
struct Work {
    std::size_t agent;
    std::size_t first;
    std::size_t last;
};

std::optional<Work> work_of(const Report& report, const Breach& breach) {
    const double time = report.mission.rules.breach_time.of(report.map.obstacle(breach.obstacle));
    const double begun = breach.cleared_at - time;
    for (std::size_t i = 0; i < report.plan.agents.size(); ++i) {
        const Itinerary& agent = report.plan.agents[i];
        if (agent.kind != AgentKind::air || (!breach.by.empty() && agent.id != breach.by)) continue;
        const auto is_there = [&](const Waypoint& q) { return q.x == breach.at.x && q.y == breach.at.y; };
        for (std::size_t last = 0; last < agent.path.size(); ++last) {
            if (!is_there(agent.path[last]) || !same_time(agent.path[last].t, breach.cleared_at)) continue;
            std::size_t first = last;
            while (first > 0 && is_there(agent.path[first - 1]) && !before(agent.path[first].t, begun)) --first;
            return Work{i, first, last};
        }
    }
    return std::nullopt;
}

bool is_among(const std::vector<TimedOpening>& list, ObstacleId id) {
    return std::ranges::find(list, id, &TimedOpening::obstacle) != list.end();
}

// When the work is done, if it is done or has begun by `decided`.
std::optional<double> done_at(const Report& report, const Work& work, const Position& position, const Breach& breach) {
    if (work.last < position.next) return std::min(breach.cleared_at, report.state.now);
    const bool goes_on = position.doing == Doing::moving || position.doing == Doing::breaching;
    if (!goes_on) return std::nullopt;
    const double ends = position.ahead[work.last - position.next + 1].t;
    if (ends <= report.decided) return ends;
    const bool at_work = work.first < position.next;
    if (at_work) return ends;
    return position.ahead[work.first - position.next + 1].t < report.decided ? std::optional(ends) : std::nullopt;
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
    return until;
}

Mission left_of(const Report& report, std::span<const Outlook> outlooks) {
    Mission left = report.mission;
    Rules& rules = left.rules;
    const auto forget = [](std::vector<ObstacleId>& ids, ObstacleId id) { std::erase(ids, id); };
    const auto tried_by = [&](const Breach& breach) -> Agent* {
        const std::optional<Work> work = work_of(report, breach);
        if (!work) return nullptr;
        const auto agent = std::ranges::find(left.agents, report.plan.agents[work->agent].id, &Agent::id);
        return agent == left.agents.end() ? nullptr : &*agent;
    };
    for (std::size_t i = 0; i < outlooks.size(); ++i) {
        const Breach& breach = report.plan.breaches[i];
        if (!outlooks[i].failed && !outlooks[i].opens) continue;
        Agent* aircraft = tried_by(breach);
        if (aircraft != nullptr && aircraft->breaches != any_number)
            aircraft->breaches = std::max(aircraft->breaches - 1, 0);
        if (outlooks[i].failed) {
            rules.failed.push_back(breach.obstacle);
            const bool used_up = std::ranges::count(rules.failed, breach.obstacle) > rules.retries;
            if (!used_up) continue;
            forget(rules.force, breach.obstacle);
            if (std::ranges::find(rules.protect, breach.obstacle) == rules.protect.end())
                rules.protect.push_back(breach.obstacle);
            continue;
        }
        rules.opened.push_back({breach.obstacle, *outlooks[i].opens});
        rules.removals = std::max(rules.removals - 1, 0);
        rules.budget = std::max(rules.budget - report.map.obstacle(breach.obstacle).weight, 0.0);
        forget(rules.force, breach.obstacle);
    }
    // What others have opened.
    for (const TimedOpening& opening : report.state.opened) {
        if (is_among(rules.opened, opening.obstacle)) continue;
        rules.opened.push_back(opening);
        forget(rules.force, opening.obstacle);
    }
    std::ranges::sort(rules.opened, {}, &TimedOpening::obstacle);
    std::ranges::sort(rules.protect);
    return left;
}

}  // namespace waybreaker::live
