// Timetables: from start to goal, forward in time, at full speed or at rest.
#include <algorithm>

#include "check/judge.hpp"

namespace waybreaker::checker {
namespace {

Point place(const Waypoint& point) {
    return {point.x, point.y};
}

// What makes a timetable unreadable, if anything does.
Violations judge_form(const Itinerary& agent) {
    const std::string who = "the " + agent.id + " agent";
    if (!(agent.speed > 0)) return {{Rule::agents, who + "'s speed is not above 0", agent.id}};
    if (agent.path.empty()) return {{Rule::agents, who + " has no path", agent.id}};
    return {};
}

// Whether it is at its last place from the last of its breaches on.
bool stays_behind(const Itinerary& agent, std::span<const Breach> own, const Terms& terms) {
    if (own.empty()) return false;
    return std::ranges::any_of(agent.path, [&](const Waypoint& p) {
        return place(p) == place(agent.path.back()) && agree(terms, p.t, own.back().cleared_at);
    });
}

// Whether it may be left, and stands at its start, or where it has breached its last, until it counts as unreached.
Violations judge_unreached(const Itinerary& agent, std::span<const Breach> own, Point start, double latest,
                           const Terms& terms) {
    const std::string who = "the " + agent.id + " agent ";
    const Waypoint& last = agent.path.back();
    const auto fault = [&](const std::string& what) -> Violations {
        return {{Rule::goal, who + what, agent.id, {}, place(last), last.t}};
    };
    if (!terms.rules.unreached || agent.kind == AgentKind::air) return fault("is not reached, and has to be");
    if (place(last) != start && !stays_behind(agent, own, terms))
        return fault("is not reached, and ends elsewhere than at its start");
    if (agree(terms, last.t, latest)) return {};
    return fault("is not reached, and stands there until " + text(last.t) + " instead of " + text(latest));
}

Violations judge_ends(const Itinerary& agent, const Agent* asked, std::span<const Breach> own, const Terms& terms) {
    const std::string who = "the " + agent.id + " agent ";
    const Waypoint& first = agent.path.front();
    const Waypoint& last = agent.path.back();
    Violations found;
    const bool is_under_way = asked != nullptr && !asked->approach.empty();
    const Point start = asked != nullptr && asked->from ? *asked->from : Point(agent.start);
    if (is_under_way) {
        const std::vector<Waypoint>& approach = asked->approach;
        if (agent.path.size() < approach.size() || !std::equal(approach.begin(), approach.end(), agent.path.begin())) {
            const std::string message = who + "does not come to its start as it is under way";
            found.push_back({Rule::start, message, agent.id, {}, place(first), first.t});
        }
    } else if (place(first) != start) {
        const std::string message = who + "starts at " + text(place(first)) + " instead of " + text(start);
        found.push_back({Rule::start, message, agent.id, {}, place(first), first.t});
    }
    if (!is_under_way && !agree(terms, first.t, 0)) {
        found.push_back({Rule::start, who + "does not start at time 0", agent.id, {}, place(first), first.t});
    }
    // Under way it may be free only after that.
    const double latest = std::max(terms.rules.unreached.value_or(last.t), is_under_way ? asked->ready_at : 0);
    if (!agent.reached) {
        append(found, judge_unreached(agent, own, start, latest, terms));
        return found;
    }
    if (place(last) != Point(agent.goal)) {
        const std::string message = who + "ends at " + text(place(last)) + " instead of " + text(agent.goal);
        found.push_back({Rule::goal, message, agent.id, {}, place(last), last.t});
    }
    if (agent.kind == AgentKind::ground && last.t > latest + slack(terms, latest)) {
        const std::string message =
            who + "is at its goal at " + text(last.t) + ", and counts as not reached from " + text(latest) + " on";
        found.push_back({Rule::goal, message, agent.id, {}, place(last), last.t});
    }
    return found;
}

// Times are held against the sum of all moves and waits so far, so that errors within the tolerance cannot add up.
// On its approach, so many points, it may be slow.
Violations judge_moves(const Itinerary& agent, std::size_t approach, const Terms& terms) {
    const std::string who = "the " + agent.id + " agent ";
    Violations found;
    double due = agent.path.front().t;
    for (std::size_t i = 1; i < agent.path.size() && found.size() < enough_violations; ++i) {
        const Waypoint& a = agent.path[i - 1];
        const Waypoint& b = agent.path[i];
        const double way = std::hypot(b.x - a.x, b.y - a.y);
        if (b.t < a.t) {
            const std::string message = who + "goes back in time, to " + text(b.t);
            found.push_back({Rule::time, message, agent.id, {}, place(a), a.t});
        }
        due += way > 0 ? way / agent.speed : b.t - a.t;
        if (i < approach) due = std::max(due, b.t);
        if (agree(terms, due, b.t)) continue;
        const std::string message = who + "is at " + text(place(b)) + " at " + text(b.t) + "; at speed " +
                                    text(agent.speed) + " it gets there at " + text(due);
        found.push_back({Rule::speed, message, agent.id, {}, place(b), b.t});
        due = b.t;
    }
    return found;
}

}  // namespace

Violations judge_timetable(const Itinerary& agent, const Agent* asked, std::span<const Breach> own,
                           const Terms& terms) {
    Violations found = judge_form(agent);
    if (!found.empty()) return found;
    found = judge_ends(agent, asked, own, terms);
    append(found, judge_moves(agent, asked == nullptr ? 0 : asked->approach.size(), terms));
    return found;
}

Violations judge_ready(const Itinerary& agent, const Agent& asked, const Terms& terms) {
    const Point start = asked.from ? *asked.from : Point(agent.start);
    const std::size_t under_way =
        std::min(asked.approach.empty() ? 0 : asked.approach.size() - 1, agent.path.size() - 1);
    const auto moved = std::find_if(agent.path.begin() + std::ptrdiff_t(under_way), agent.path.end(),
                                    [&](const Waypoint& at) { return place(at) != start; });
    const Waypoint& at = moved == agent.path.end() ? agent.path.back() : *moved;
    const double way = std::hypot(at.x - start.x, at.y - start.y);
    const double left = at.t - way / agent.speed;
    if (left + slack(terms, at.t) >= asked.ready_at) return {};
    const std::string message =
        "the " + agent.id + " agent leaves at " + text(left) + ", before it is ready at " + text(asked.ready_at);
    return {{Rule::start, message, agent.id, {}, start, left}};
}

}  // namespace waybreaker::checker
