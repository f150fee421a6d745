// Whether aircraft come home before their battery is empty: each flight added up from its path, whatever its planner
// says.
#include <limits>
#include <vector>

#include "check/judge.hpp"

namespace waybreaker::checker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// From when an aircraft takes off until it has landed, by the points of its path and what it breaches: who breaches
// from its start or above its goal flies. Of one under way, from when it is ready; before, it has flown what it says.
struct Flown {
    double off = infinity;  // in units of time
    double down = 0;
    double cells = 0;  // of all moves
    double moving = 0;
    double before = 0;

    double time() const { return before + std::max(down - off, 0.0); }
    double hovering() const { return std::max(time() - moving, 0.0); }
    void flies(double from, double until) {
        off = std::min(off, from);
        down = std::max(down, until);
    }
};

class FlightJudge {
  public:
    FlightJudge(const Map& map, const Plan& plan, const Itinerary& agent, const Agent& asked, const Terms& terms)
        : agent_(agent), asked_(asked), terms_(terms) {
        ready_ = asked.approach.empty() ? 0 : asked.ready_at - slack(terms, asked.ready_at);
        for (const Breach& breach : plan.breaches) {
            const bool is_its = breach.by.empty() || breach.by == agent.id;  // by: where there are several
            if (!is_its || !names_obstacle(map, breach.obstacle)) continue;
            const double lasts = lasting(asked, map.obstacle(breach.obstacle), terms.rules);
            if (lasts > 0 && breach.cleared_at - lasts >= ready_)
                hovers_.push_back({breach.cleared_at - lasts, breach.cleared_at});
        }
    }

    Violations judge() {
        const std::vector<Waypoint>& path = agent_.path;
        Flown flight;
        flight.before = asked_.flown;
        double since = ready_;  // the last landing
        std::vector<Recharge> landings;
        for (std::size_t i = 1; i < path.size(); ++i) {
            const Waypoint& a = path[i - 1];
            const Waypoint& b = path[i];
            if (a.t < ready_) continue;
            if (a.x != b.x || a.y != b.y) {
                flight.flies(a.t, b.t);
                flight.cells += std::hypot(b.x - a.x, b.y - a.y);
                flight.moving += b.t - a.t;
            } else if (const auto base = base_of(a, b)) {
                add_hovering(since, a.t, flight);
                if (!asked_.approach.empty() && landings.empty()) begin_under_way(a.t, flight);
                judge_flight(flight);
                landings.push_back({*base, a.t, b.t, flight.time()});
                flight = {};
                since = b.t;
            }
        }
        add_hovering(since, infinity, flight);
        if (!asked_.approach.empty() && asked_.flown > 0 && flight.down > 0 && landings.empty())
            flight.off = std::min(flight.off, asked_.ready_at);
        judge_flight(flight);
        judge_landings(landings);
        return std::move(found_);
    }

  private:
    struct Hover {
        double from;
        double until;
    };

    void report(const std::string& message, double time) {
        found_.push_back({Rule::range, message, asked_.id, {}, {}, time});
    }

    // Where it stands for long enough, and does not breach meanwhile.
    std::optional<Cell> base_of(const Waypoint& a, const Waypoint& b) const {
        if (!asked_.recharge || b.t - a.t < *asked_.recharge - slack(terms_, b.t)) return std::nullopt;
        const auto breaches = [&](const Hover& hover) {
            return hover.from < b.t - slack(terms_, b.t) && hover.until > a.t + slack(terms_, b.t);
        };
        if (std::any_of(hovers_.begin(), hovers_.end(), breaches)) return std::nullopt;
        const std::vector<Cell> usual{asked_.start, asked_.goal};
        for (const Cell base : asked_.bases.empty() ? usual : asked_.bases) {
            if (base.x == a.x && base.y == a.y) return base;
        }
        return std::nullopt;
    }

    void add_hovering(double since, double until, Flown& flight) const {
        for (const Hover& hover : hovers_) {
            const double middle = (hover.from + hover.until) / 2;
            if (middle > since && middle < until) flight.flies(hover.from, hover.until);
        }
    }

    void begin_under_way(double landed, Flown& flight) const {
        if (asked_.flown > 0) flight.flies(std::min(asked_.ready_at, landed), landed);
    }

    void judge_flight(const Flown& flight) {
        const double kept = 1 - asked_.reserve;
        const auto expect = [&](Rule rule, double most, double value, const std::string& unit) {
            const double limit = kept * most;
            if (value <= limit + slack(terms_, limit)) return;
            const std::string reserve = asked_.reserve > 0 ? ", " + text(100 * asked_.reserve) + " % in reserve" : "";
            found_.push_back(
                {rule,
                 "the " + asked_.id + " agent flies " + text(value) + unit + ", and may fly " + text(limit) + reserve,
                 asked_.id,
                 {},
                 {},
                 flight.down});
        };
        if (std::isfinite(asked_.range))
            expect(Rule::range, asked_.range, flight.cells + asked_.speed * flight.hovering(),
                   " cells, hovering counted");
        if (std::isfinite(asked_.endurance)) expect(Rule::endurance, asked_.endurance, flight.time(), " units of time");
    }

    // What the plan says of landings is what its path shows. Older plan files and paths on their way say less.
    void judge_landings(const std::vector<Recharge>& landings) {
        std::size_t next = 0;
        for (const Recharge& said : agent_.recharges) {
            const auto is_it = [&](const Recharge& seen) {
                return seen.at == said.at && agree(terms_, seen.from, said.from) &&
                       agree(terms_, seen.until, said.until) && agree(terms_, seen.flown, said.flown);
            };
            while (next < landings.size() && !is_it(landings[next])) ++next;
            if (next == landings.size()) {
                report("the " + asked_.id + " agent does not recharge as said at " + text(said.at.x) + "," +
                           text(said.at.y) + " from " + text(said.from) + " to " + text(said.until) + ", " +
                           text(said.flown) + " units of time in the air",
                       said.from);
                return;
            }
            ++next;
        }
    }

    const Itinerary& agent_;
    const Agent& asked_;
    const Terms& terms_;
    double ready_ = 0;
    std::vector<Hover> hovers_;
    Violations found_;
};

// That an obstacle which is said to be out of range is one: no straight flight there and to the goal is short enough.
void judge_far(const Map& map, const Mission& mission, const OutOfRange& far, const Terms& terms, Violations& found) {
    const auto fault = [&](const std::string& what) {
        found.push_back({Rule::range, "as out of range: " + what, far.agent, far.obstacle});
    };
    if (!names_obstacle(map, far.obstacle)) return fault("there is no obstacle " + std::to_string(far.obstacle.value));
    const auto is_it = [&](const Agent& agent) { return agent.id == far.agent && agent.kind == AgentKind::air; };
    const auto agent = std::find_if(mission.agents.begin(), mission.agents.end(), is_it);
    if (agent == mission.agents.end()) return fault("there is no air agent " + far.agent);
    const double battery = std::min(agent->range / agent->speed, agent->endurance);
    const double flown = agent->recharge ? 0 : agent->flown;
    const double longest = std::max((1 - agent->reserve) * battery - flown, 0.0);
    if (!agree(terms, far.longest, longest))
        return fault(far.agent + " may fly for " + text(longest) + ", not " + text(far.longest));
    // From wherever it may take off to wherever it may land.
    std::vector<Point> starts{agent->from.value_or(Point(agent->start))};
    std::vector<Point> goals{Point(agent->goal)};
    if (agent->recharge) {
        for (const Cell base : agent->bases) starts.emplace_back(base);
        if (agent->bases.empty()) starts.emplace_back(agent->goal);
        if (agent->bases.empty()) goals.emplace_back(agent->start);
        for (const Cell base : agent->bases) goals.emplace_back(base);
    }
    double straight = infinity;
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            if (map.obstacle_at({x, y}) != far.obstacle) continue;
            // Beside it, however: no more than a diagonal nearer.
            const auto least = [&](const std::vector<Point>& places) {
                double nearest = infinity;
                for (const Point& p : places) nearest = std::min(nearest, std::hypot(x - p.x, y - p.y));
                return nearest;
            };
            straight = std::min(straight, least(starts) + least(goals) - 2 * std::sqrt(2.0));
        }
    }
    const double least =
        std::max(straight, 0.0) / agent->speed + lasting(*agent, map.obstacle(far.obstacle), terms.rules);
    if (far.flight < least - slack(terms, least)) return fault("a flight of " + text(far.flight) + " is too short");
    if (!std::isfinite(far.flight) || far.flight <= longest)
        fault("a flight of " + text(far.flight) + " is none that " + far.agent + " may not make");
}

}  // namespace

Violations judge_ranges(const Map& map, const Mission& mission, const Plan& plan, const Terms& terms) {
    Violations found;
    for (const Itinerary& agent : plan.agents) {
        const auto is_it = [&](const Agent& asked) { return asked.id == agent.id && asked.kind == AgentKind::air; };
        const auto asked = std::find_if(mission.agents.begin(), mission.agents.end(), is_it);
        if (asked == mission.agents.end() || agent.kind == AgentKind::ground) continue;
        const Violations of_flight = FlightJudge(map, plan, agent, *asked, terms).judge();
        found.insert(found.end(), of_flight.begin(), of_flight.end());
    }
    for (const OutOfRange& far : plan.out_of_range) judge_far(map, mission, far, terms, found);
    return found;
}

}  // namespace waybreaker::checker
