// Continuity: whether a plan that revises another goes on from where everybody is. By its own reading of both plans and
// the state, without the code that revises.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "check/judge.hpp"

namespace waybreaker {
namespace {

// A stop between two bends is at a cell centre beside the path.
constexpr double aside = 1.5;  // cells

std::string text(ObstacleId id) {
    return "obstacle " + std::to_string(id.value);
}

using checker::away;

class ContinuityJudge {
  public:
    ContinuityJudge(const Mission& old_mission, const Plan& old_plan, const State& state, const Mission& mission,
                    const Plan& plan, double tolerance)
        : old_mission_(old_mission),
          old_(old_plan),
          state_(state),
          mission_(mission),
          plan_(plan),
          tolerance_(tolerance) {
        if (plan.revised) decisions_ = plan.revised->decisions;
    }

    std::vector<Violation> judge() {
        if (!plan_.revised) {
            say("the plan does not say that it revises another");
            return std::move(found_);
        }
        judge_report();
        for (std::size_t i = 0; i < old_mission_.agents.size(); ++i) judge_agent(i);
        for (const Agent& agent : mission_.agents) judge_newcomer(agent);
        judge_openings();
        judge_rules();
        return std::move(found_);
    }

  private:
    void say(std::string message, const std::string& agent = "", ObstacleId obstacle = {}) {
        found_.push_back({Rule::continuity, std::move(message), agent, obstacle});
    }
    double slack(double value) const { return tolerance_ * std::max(1.0, std::abs(value)); }
    bool same(double a, double b) const { return std::abs(a - b) <= slack(b); }

    template <class Item>
    static const Item* named(const std::vector<Item>& items, const std::string& id) {
        const auto found = std::ranges::find(items, id, &Item::id);
        return found == items.end() ? nullptr : &*found;
    }

    void judge_report() {
        const Revised now = plan_.revised.value_or(Revised{});
        if (now.sequence != state_.sequence)
            say("the plan knows report " + std::to_string(now.sequence) + ", not " + std::to_string(state_.sequence));
        if (!same(now.now, state_.now)) say("the plan was not made at the time of the state");
        if (now.number != (old_.revised ? old_.revised->number + 1 : 1)) say("revisions are not counted one by one");
        std::vector<Found> known = old_.revised ? old_.revised->found : std::vector<Found>();
        known.insert(known.end(), state_.found.begin(), state_.found.end());
        // Behind these, where agents have stopped.
        const bool begins_so =
            now.found.size() >= known.size() && std::equal(known.begin(), known.end(), now.found.begin());
        const auto has_stopped = [](const AgentState& agent) { return agent.doing == Doing::stopped; };
        const auto stopped = std::size_t(std::ranges::count_if(state_.agents, has_stopped));
        if (!begins_so || now.found.size() > known.size() + stopped) say("the plan does not know what was found");
    }

    static bool is_out(const AgentState* state) {
        return state != nullptr && (state->doing == Doing::lost || state->doing == Doing::stopped);
    }

    // The part of the old path that is still to come, and whether the agent is on time.
    std::vector<Waypoint> rest_of(const Itinerary& old, const AgentState* state, bool& on_time) const {
        std::size_t next = 0;
        while (next < old.path.size() && old.path[next].t <= state_.now) ++next;
        Waypoint at = old.path.empty() ? Waypoint{} : old.path.back();
        if (next == 0) at = old.path.front();
        if (next > 0 && next < old.path.size()) {
            const Waypoint& a = old.path[next - 1];
            const Waypoint& b = old.path[next];
            const double share = (state_.now - a.t) / (b.t - a.t);
            at = {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), state_.now};
        }
        on_time = true;
        if (state != nullptr) {
            const bool as_planned = state->passed + 1 == next;
            const Waypoint planned = at;
            if (state->at) at = {state->at->x, state->at->y, state_.now};
            if (!state->at && !as_planned) at = old.path[std::min(state->passed, old.path.size() - 1)];
            on_time = as_planned && away(at, planned) <= 1e-3;
            if (!as_planned) next = state->passed + 1;
        }
        at.t = state_.now;
        std::vector<Waypoint> rest{at};
        // Off its path an aircraft does not come back to places in a zone.
        const auto is_inside = [&](const Waypoint& p) {
            return checker::flies_in_zone(old_mission_, old.id, {p.x, p.y}, {p.x, p.y}, state_.now);
        };
        while (old.kind == AgentKind::air && !on_time && next + 1 < old.path.size() && is_inside(old.path[next]))
            ++next;
        for (std::size_t i = next; i < old.path.size(); ++i) rest.push_back(old.path[i]);
        return rest;
    }

    void judge_agent(std::size_t i) {
        const Agent& was = old_mission_.agents[i];
        const AgentState* state = named(state_.agents, was.id);
        const Agent* is = named(mission_.agents, was.id);
        if (is_out(state)) {
            if (named(plan_.agents, was.id) != nullptr)
                say("the " + was.id + " agent takes no further part, and has a path", was.id);
            return;
        }
        if (is == nullptr) return say("the " + was.id + " agent is missing", was.id);
        const Cell goal = state != nullptr && state->goal ? *state->goal : was.goal;
        if (is->goal != goal) say("the " + was.id + " agent has another goal", was.id);
        if (is->kind != was.kind || !same(is->speed, was.speed) || is->body.radius != was.body.radius)
            say("the " + was.id + " agent is another one", was.id);
        const Itinerary* path = named(plan_.agents, was.id);
        const Itinerary* old = named(old_.agents, was.id);
        if (plan_.status != PlanStatus::solved) return;
        const Decision* decision = nullptr;
        for (const Decision& d : decisions_) {
            if (d.agent == was.id) decision = &d;
        }
        if (path == nullptr || old == nullptr || decision == nullptr || decision->point >= path->path.size() ||
            old->path.empty())
            return say("the plan does not say where the " + was.id + " agent decides", was.id);
        judge_base(*path, *old, *decision, state);
        if (was.kind == AgentKind::air) judge_battery(was, *is, *path, *old, *decision, state);
    }

    // What an aircraft has flown is gone, and of its reserve it uses no more than it takes to fly straight home.
    void judge_battery(const Agent& was, const Agent& is, const Itinerary& path, const Itinerary& old,
                       const Decision& decision, const AgentState* state) {
        const std::vector<Cell> ends{was.start, was.goal};
        const std::vector<Cell>& bases = was.recharge && was.bases.empty() ? ends : was.bases;
        if (is.range != was.range || is.endurance != was.endurance || is.reserve > was.reserve ||
            is.recharge != was.recharge || is.bases != bases)
            say("the " + was.id + " agent has another battery", was.id);
        const double battery = std::min(was.range / was.speed, was.endurance);
        if (std::isinf(battery)) return;
        bool on_time = true;
        const std::vector<Waypoint> rest = rest_of(old, state, on_time);
        const Waypoint& at = rest.front();
        const bool landed = rest.size() == 1 && at.x == old.path.back().x && at.y == old.path.back().y;
        const Point start = was.from.value_or(Point(was.start));
        const bool waits = was.flown == 0 && !on_time && at.x == start.x && at.y == start.y &&
                           (state == nullptr || state->doing != Doing::breaching);
        const double from = waits ? std::max(was.ready_at, state_.now) : was.ready_at;
        const double until =
            !landed ? decision.time : std::min(on_time ? old.path.back().t : state_.now, decision.time);
        double flown = was.flown + std::max(until - from, 0.0);
        if (state != nullptr && state->flown) {
            const double next = *state->flown > 0 ? state_.now : std::max(state_.now, was.ready_at);
            flown = *state->flown + (landed ? 0 : std::max(decision.time - next, 0.0));
        }
        // Of one that has recharged meanwhile as planned.
        for (const Recharge& recharge : old.recharges) {
            const bool is_said = state != nullptr && state->flown && recharge.until <= state_.now;
            const bool is_over = on_time && recharge.until <= decision.time + slack(decision.time);
            if (is_over && !is_said) flown = std::max(until - recharge.until, 0.0);
        }
        const Waypoint& free = path.path[decision.point];
        const double home = std::hypot(free.x - is.goal.x, free.y - is.goal.y) / is.speed;
        if (home == 0) flown = std::min(flown, battery);
        // What a late one has flown since it recharged, only its planner knows.
        if (!same(is.flown, flown) && (on_time || old.recharges.empty()))
            say("the " + was.id + " agent is said to have flown for another time than it has", was.id);
        if (is.reserve == was.reserve) return;
        const bool has_zones =
            std::ranges::any_of(mission_.rules.zones, [&](const Zone& zone) { return zone.kind == ZoneKind::no_fly; });
        if (!has_zones && !was.recharge && path.path.back().t - decision.time > home + slack(path.path.back().t))
            say("the " + was.id + " agent uses its reserve for more than to fly home", was.id);
    }

    void judge_base(const Itinerary& path, const Itinerary& old, const Decision& decision, const AgentState* state) {
        bool on_time = true;
        const std::vector<Waypoint> rest = rest_of(old, state, on_time);
        const Waypoint& first = path.path.front();
        if (away(first, rest.front()) > 1e-3 * std::max(1.0, path.speed))
            say("the " + path.id + " agent does not go on from where it is", path.id);
        const bool had_arrived = rest.size() == 1;
        const auto place = [](const Waypoint& p) { return Point(p.x, p.y); };
        const Point next = place(rest[had_arrived ? 0 : 1]);
        const bool is_barred = old.kind == AgentKind::air &&
                               checker::is_barred(old_mission_, old.id, place(rest.front()), next, state_.now);
        if (!(same(first.t, state_.now) || (had_arrived && first.t < state_.now)))
            say("the path of the " + path.id + " agent does not begin now", path.id);
        std::size_t piece = 0;
        for (std::size_t k = 1; k <= decision.point; ++k) {
            const Waypoint& p = path.path[k];
            const double most = k == decision.point ? aside : 1e-3;
            const std::size_t before = piece;
            while (piece + 1 < rest.size() && away(p, rest[piece], rest[piece + 1]) > most) ++piece;
            const bool is_on = rest.size() == 1 ? away(p, rest.front()) <= most : piece + 1 < rest.size();
            if (!is_on && before == 0 && is_barred) {
                // It gets to the first point ahead some other way.
                piece = 0;
                continue;
            }
            if (!is_on) return say("the " + path.id + " agent leaves its base before it decides", path.id);
            if (on_time && k < decision.point && !is_planned(rest, p))
                return say("the " + path.id + " agent does not keep the times of its base", path.id);
        }
        if (!same(path.path[decision.point].t, decision.time))
            say("the " + path.id + " agent decides at another time than its path says", path.id);
        if (decision.time < state_.now - slack(state_.now) && !had_arrived)
            say("the " + path.id + " agent decides in the past", path.id);
    }

    // Whether the old path is there at that time.
    bool is_planned(const std::vector<Waypoint>& rest, const Waypoint& p) const {
        for (std::size_t i = 1; i < rest.size(); ++i) {
            if (p.t > rest[i].t + slack(p.t)) continue;
            const double span = rest[i].t - rest[i - 1].t;
            const double share = span > 0 ? std::clamp((p.t - rest[i - 1].t) / span, 0.0, 1.0) : 1;
            const Waypoint there{rest[i - 1].x + share * (rest[i].x - rest[i - 1].x),
                                 rest[i - 1].y + share * (rest[i].y - rest[i - 1].y), p.t};
            return away(there, p) <= 1e-3;
        }
        return away(rest.back(), p) <= 1e-3;
    }

    void judge_newcomer(const Agent& agent) {
        if (named(old_mission_.agents, agent.id) != nullptr || named(state_.joined, agent.id) != nullptr) return;
        say("the " + agent.id + " agent comes from nowhere", agent.id);
    }

    static const TimedOpening* opening(const std::vector<TimedOpening>& openings, ObstacleId id) {
        const auto found = std::ranges::find(openings, id, &TimedOpening::obstacle);
        return found == openings.end() ? nullptr : &*found;
    }

    // Who makes a breach, and whether it has left the end of the work behind.
    struct Breacher {
        const Itinerary* agent = nullptr;
        bool done = false;
    };
    Breacher breacher_of(const Breach& breach) const {
        for (const Itinerary& agent : old_.agents) {
            const bool flies = agent.kind == AgentKind::air;
            if (breach.by.empty() ? !flies : agent.id != breach.by) continue;
            for (std::size_t k = agent.path.size(); k-- > 0;) {
                const Waypoint& p = agent.path[k];
                if (flies && (p.x != breach.at.x || p.y != breach.at.y)) continue;
                if (!same(p.t, breach.cleared_at)) continue;
                const AgentState* state = named(state_.agents, agent.id);
                return {&agent, state != nullptr ? k <= state->passed : breach.cleared_at <= state_.now};
            }
        }
        return {};
    }

    void judge_openings() {
        std::size_t opened = 0;
        std::vector<std::pair<std::string, int>> tries;
        for (const Breach& breach : old_.breaches) {
            const ObstacleId id = breach.obstacle;
            const TimedOpening* known = opening(mission_.rules.opened, id);
            const Breacher breacher = breacher_of(breach);
            const bool failed = opening(state_.failed, id) != nullptr;
            if (failed && known != nullptr)
                say("the breach of " + text(id) + " failed, and it is said to be open", "", id);
            if (failed &&
                std::ranges::count(mission_.rules.failed, id) != std::ranges::count(old_mission_.rules.failed, id) + 1)
                say("the plan does not know that the breach of " + text(id) + " failed", "", id);
            const bool is_open = !failed && (breacher.done || opening(state_.opened, id) != nullptr);
            if (is_open && known == nullptr) say("the plan does not know that " + text(id) + " is open", "", id);
            if (known != nullptr && !failed) ++opened;
            if ((failed || known != nullptr) && breacher.agent != nullptr) {
                const auto tried = std::ranges::find(tries, breacher.agent->id, &std::pair<std::string, int>::first);
                if (tried == tries.end())
                    tries.emplace_back(breacher.agent->id, 1);
                else
                    ++tried->second;
            }
            if (known != nullptr && !is_open && !failed && known->at > state_.now) {
                // Its breach has begun: whoever makes it stays until it is done.
                bool bound = false;
                for (const Decision& d : decisions_) {
                    bound = bound || (breacher.agent != nullptr && d.agent == breacher.agent->id &&
                                      d.time >= known->at - slack(known->at));
                }
                if (!bound && plan_.status == PlanStatus::solved)
                    say("nobody breaches " + text(id) + " by the time that it is said to open", "", id);
            }
        }
        for (const TimedOpening& known : mission_.rules.opened) {
            const bool was = opening(old_mission_.rules.opened, known.obstacle) != nullptr;
            const TimedOpening* said = opening(state_.opened, known.obstacle);
            const bool breached =
                std::ranges::find(old_.breaches, known.obstacle, &Breach::obstacle) != old_.breaches.end();
            if (!was && said == nullptr && !breached)
                say("nobody has opened " + text(known.obstacle), "", known.obstacle);
            if (said != nullptr && !was && !same(said->at, known.at))
                say(text(known.obstacle) + " opens at another time", "", known.obstacle);
        }
        int taken_back = 0;
        for (const TimedOpening& known : old_mission_.rules.opened) {
            if (opening(state_.failed, known.obstacle) != nullptr) {
                // It had begun before the old plan was made, and has failed since.
                ++taken_back;
                if (opening(mission_.rules.opened, known.obstacle) != nullptr)
                    say("the breach of " + text(known.obstacle) + " failed, and it is said to be open", "",
                        known.obstacle);
                if (std::ranges::count(mission_.rules.failed, known.obstacle) !=
                    std::ranges::count(old_mission_.rules.failed, known.obstacle) + 1)
                    say("the plan does not know that the breach of " + text(known.obstacle) + " failed", "",
                        known.obstacle);
                continue;
            }
            if (opening(mission_.rules.opened, known.obstacle) == nullptr)
                say("the plan has forgotten that " + text(known.obstacle) + " is open", "", known.obstacle);
        }
        const int removals = std::max(old_mission_.rules.removals - int(opened), 0) + taken_back;
        if (mission_.rules.removals != removals)
            say("the mission may remove " + std::to_string(mission_.rules.removals) + ", not " +
                std::to_string(removals) + " as is left");
        for (const auto& [id, count] : tries) {
            const Agent* was = named(old_mission_.agents, id);
            const Agent* is = named(mission_.agents, id);
            if (was == nullptr || is == nullptr) continue;
            const auto may = [](const Agent& agent) {
                return agent.kind == AgentKind::air ? agent.breaches : agent.own_breaches;
            };
            if (may(*was) != any_number && may(*is) != std::max(may(*was) - count, 0))
                say("the " + id + " agent may breach another number", id);
        }
    }

    // Without those who take no further part, and what held for them alone.
    std::vector<Zone> zones_left() const {
        std::vector<Zone> zones;
        for (Zone zone : old_mission_.rules.zones) {
            const bool held_for_all = zone.agents.empty();
            const auto is_gone = [&](const std::string& id) { return is_out(named(state_.agents, id)); };
            std::erase_if(zone.agents, is_gone);
            if (held_for_all || !zone.agents.empty()) zones.push_back(std::move(zone));
        }
        return zones;
    }

    void judge_rules() {
        const Rules& was = old_mission_.rules;
        const Rules& is = mission_.rules;
        // What has failed, and had counted as open, weighs nothing again.
        const bool takes_back = std::ranges::any_of(
            was.opened, [&](const TimedOpening& known) { return opening(state_.failed, known.obstacle) != nullptr; });
        if (is.timing != was.timing || is.objective != was.objective || is.separation != was.separation ||
            is.at_goal != was.at_goal || is.collisions != was.collisions || is.unreached != was.unreached ||
            is.zones != zones_left() || is.retries != was.retries ||
            is.breach_time.per_obstacle != was.breach_time.per_obstacle ||
            is.breach_time.per_cell != was.breach_time.per_cell || (is.budget > was.budget && !takes_back))
            say("the rules are others");
        const auto protects = [&](ObstacleId id) { return std::ranges::find(is.protect, id) != is.protect.end(); };
        for (const ObstacleId id : was.protect) {
            if (!protects(id)) say(text(id) + " is no longer protected", "", id);
        }
        for (const ObstacleId id : is.failed) {
            if (std::ranges::count(is.failed, id) > is.retries && !protects(id))
                say("the breach of " + text(id) + " may be tried again, and has failed too often", "", id);
        }
    }

    const Mission& old_mission_;
    const Plan& old_;
    const State& state_;
    const Mission& mission_;
    const Plan& plan_;
    double tolerance_;
    std::vector<Decision> decisions_;
    std::vector<Violation> found_;
};

}  // namespace

std::vector<Violation> check_continuity(const Mission& old_mission, const Plan& old_plan, const State& state,
                                        const Mission& mission, const Plan& plan, double tolerance) {
    if (old_plan.revised && plan.revised && plan.revised->sequence == old_plan.revised->sequence &&
        state.sequence <= old_plan.revised->sequence)
        return {};
    return ContinuityJudge(old_mission, old_plan, state, mission, plan, tolerance).judge();
}

}  // namespace waybreaker
