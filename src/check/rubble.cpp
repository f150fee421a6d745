// Whether ground agents take their time over rubble: who enters what was removed has stood before it for as long, at
// the last turn before, and for each obstacle anew; and does not enter earlier than so long after the opening.
#include <algorithm>
#include <cmath>
#include <limits>

#include "check/judge.hpp"

namespace waybreaker::checker {
namespace {

// Where the path stands, or turns without a stop.
struct Turn {
    double arrival = 0;
    double stood = 0;  // not counting what it does before it is ready, and what is taken up by rubble already
};

// Of an agent that is under way nobody knows how long it has stood already where it begins.
std::vector<Turn> turns_of(const Itinerary& ground, const Agent& asked) {
    const bool is_under_way = !asked.approach.empty();
    std::vector<Turn> turns;
    const Waypoint* last = nullptr;
    for (const Waypoint& point : ground.path) {
        const bool is_new = last == nullptr || point.x != last->x || point.y != last->y;
        if (is_new) turns.push_back({point.t, 0});
        const double since = is_under_way ? turns.back().arrival : std::max(turns.back().arrival, asked.ready_at);
        turns.back().stood = std::max(point.t - since, 0.0);
        last = &point;
    }
    if (is_under_way) turns.front().stood = std::numeric_limits<double>::infinity();
    return turns;
}

// Whether the agent has been in it from the start.
bool begins_inside(const Map& map, const Agent& asked, ObstacleId obstacle, const Terms& terms) {
    const Vertex start{2 * std::int64_t(asked.start.x), 2 * std::int64_t(asked.start.y)};
    const std::vector<Contact> met = contacts(map, {start, start}, std::llround(1000 * terms.body.reach()));
    return std::any_of(met.begin(), met.end(), [&](const Contact& one) { return one.obstacle == obstacle; });
}

// Takes so much of the time that it has stood at the last turn before. Whether there is as much. An entry at a turn, or
// a hair before, may count for either side of it: what stands first is taken first, as entries come in their order.
bool take_stand(std::vector<Turn>& turns, double entry, double rubble, double hair) {
    auto turn = std::ranges::lower_bound(turns, entry - hair, {}, &Turn::arrival);
    if (turn != turns.begin()) --turn;
    for (; turn != turns.end() && turn->arrival <= entry + hair; ++turn) {
        if (turn->stood < rubble - hair) continue;
        turn->stood -= rubble;
        return true;
    }
    return false;
}

}  // namespace

Violations judge_rubble(const Map& map, const Plan& plan, const Itinerary& ground, const Agent& asked,
                        const Entries& entries, const Terms& terms) {
    Violations found;
    const double rubble = terms.rules.rubble;
    if (rubble == 0) return found;
    std::vector<Contact> entered;
    for (const auto& [obstacle, contact] : entries) {
        if (obstacle && !begins_inside(map, asked, obstacle, terms)) entered.push_back(contact);
    }
    std::stable_sort(entered.begin(), entered.end(),
                     [](const Contact& a, const Contact& b) { return a.time < b.time; });
    const std::vector<double> standing = standing_until(map, plan, terms);
    std::vector<Turn> turns = turns_of(ground, asked);
    for (const Contact& entry : entered) {
        const double opens = standing[entry.obstacle.value];
        const double hair = 2 * slack(terms, entry.time);
        if (!std::isfinite(opens)) continue;  // what is met there is another rule's
        // It has stood for that before it was under way.
        if (!asked.approach.empty() && entry.time <= asked.ready_at + hair) continue;
        const auto report = [&](const std::string& what) {
            found.push_back({Rule::rubble, "the " + ground.id + " agent " + what + " " + text(entry.obstacle),
                             ground.id, entry.obstacle, entry.place, entry.time});
        };
        if (entry.time < opens + rubble - hair)
            report("has not had " + text(rubble) + " for rubble since the opening of");
        if (!take_stand(turns, entry.time, rubble, hair))
            report("does not stand for " + text(rubble) + " for rubble before");
    }
    return found;
}

}  // namespace waybreaker::checker
