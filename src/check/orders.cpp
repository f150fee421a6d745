// Whether an execution that keeps the orders is safe, whatever comes late. Held against the definition: one of two
// vehicles is put at place after place of its path, and wherever the other would be too near then, an order must keep
// it from there. In steps, and beside every moment that an order names.
#include <limits>

#include "check/judge.hpp"

namespace waybreaker::checker {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-6;          // in units of time, and in cells
constexpr double longest_step = 1.0 / 16;  // of the places that are tried, in cells
// What the plan may be ahead of an order of two that touch while both move, in cells of the waiting agent's way.
constexpr double most_ahead = 0.25;

// Points passed, and the share of the move to the next one.
double number(const Moment& moment) {
    return double(moment.point) + moment.fraction;
}

using Path = std::vector<Waypoint>;

double length(const Path& path, std::size_t move) {
    return std::hypot(path[move + 1].x - path[move].x, path[move + 1].y - path[move].y);
}

Point place_on(const Path& path, double progress) {
    const std::size_t i = std::min(std::size_t(progress), path.size() - 1);
    const double share = progress - double(i);
    if (!(share > 0) || i + 1 == path.size()) return {path[i].x, path[i].y};
    return {path[i].x + share * (path[i + 1].x - path[i].x), path[i].y + share * (path[i + 1].y - path[i].y)};
}

double time_at(const Path& path, const Moment& moment) {
    const double from = path[moment.point].t;
    return moment.fraction > 0 ? from + moment.fraction * (path[moment.point + 1].t - from) : from;
}

// The shares of a move that are nearer than that to a place: two roots, or all of a wait.
struct Shares {
    double from = unlimited;
    double to = -unlimited;
};
Shares too_near(const Waypoint& a, const Waypoint& b, Point to, double needed) {
    const double x = a.x - to.x;
    const double y = a.y - to.y;
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double squared = dx * dx + dy * dy;
    if (squared == 0) return std::hypot(x, y) < needed ? Shares{0, 1} : Shares{};
    const double half = -(x * dx + y * dy) / squared;
    const double left = half * half - (x * x + y * y - needed * needed) / squared;
    if (!(left > 0)) return {};
    const Shares found{std::max(half - std::sqrt(left), 0.0), std::min(half + std::sqrt(left), 1.0)};
    return found.from < found.to ? found : Shares{};
}

struct Extent {
    double left = unlimited, right = -unlimited, top = unlimited, bottom = -unlimited;
    void add(const Waypoint& at) {
        left = std::min(left, at.x);
        right = std::max(right, at.x);
        top = std::min(top, at.y);
        bottom = std::max(bottom, at.y);
    }
    bool apart(const Extent& other, double needed) const {
        return other.left - right >= needed || left - other.right >= needed || other.top - bottom >= needed ||
               top - other.bottom >= needed;
    }
};

Extent extent(const Waypoint& a, const Waypoint& b) {
    Extent found;
    found.add(a);
    found.add(b);
    return found;
}

class OrdersJudge {
  public:
    OrdersJudge(const Map& map, const Mission& mission, const Plan& plan, const Terms& terms)
        : map_(map), mission_(mission), plan_(plan), terms_(terms) {}

    Violations judge() {
        for (const Order& order : plan_.orders) judge_order(order);
        if (!found_.empty()) return std::move(found_);  // what follows reads moments
        judge_openings();
        if (terms_.rules.collisions) judge_passing();
        judge_progress();
        return std::move(found_);
    }

  private:
    const Path& path_of(const Moment& moment) const { return plan_.agents[moment.agent].path; }
    const Itinerary& waiting(const Order& order) const { return plan_.agents[order.after.agent]; }

    // The agent of the mission, whose body the plan does not state.
    const Agent& asked(std::size_t agent) const {
        return *std::ranges::find(mission_.agents, plan_.agents[agent].id, &Agent::id);
    }

    void report(const std::string& message, const std::string& agent = "", ObstacleId obstacle = {},
                std::optional<Point> at = {}, std::optional<double> time = {}) {
        if (found_.size() <= enough_violations) found_.push_back({Rule::orders, message, agent, obstacle, at, time});
    }

    bool exists(const Moment& moment) const {
        if (moment.agent >= plan_.agents.size() || !(moment.fraction >= 0 && moment.fraction < 1)) return false;
        return moment.point + (moment.fraction > 0 ? 1 : 0) < path_of(moment).size();
    }

    void judge_order(const Order& order) {
        if (!exists(order.before) || !exists(order.after)) return report("an order names a moment that is none");
        const Itinerary& first = plan_.agents[order.before.agent];
        const Itinerary& second = waiting(order);
        const std::string who = "the " + second.id + " agent's order to wait for " + first.id;
        const bool opens = order.reason == OrderReason::opening;
        const bool may_be_first =
            first.kind == AgentKind::ground ? !opens || asked(order.before.agent).own_breaches > 0 : opens;
        const bool fits =
            second.kind == AgentKind::ground && &first != &second && may_be_first && bool(order.obstacle) == opens;
        if (!fits) return report(who + " is none that these two can have", second.id, order.obstacle);
        const double before = time_at(first.path, order.before);
        const double after = time_at(second.path, order.after);
        const double hair = slack(terms_, after) + rounding * (1 + 1 / first.speed + 1 / second.speed);
        const auto complain = [&](const std::string& what) {
            report(who + what, second.id, order.obstacle, place_on(second.path, number(order.after)), after);
        };
        if (std::abs(order.slack - (after - before)) > hair) {
            complain(" is said to have a slack of " + text(order.slack) + "; it has " + text(after - before));
        }
        const double ahead = opens ? 0 : most_ahead / second.speed;
        if (after < before - ahead - hair) complain(" until " + text(before) + " is one that the plan breaks");
    }

    // Of one ground and one air agent the plan does not say who breaches.
    bool waits_for(const Order& order, const Breach& breach) const {
        const Itinerary& first = plan_.agents[order.before.agent];
        const bool is_breacher = breach.by.empty() || first.id == breach.by;
        const double done = time_at(first.path, order.before);
        return order.obstacle == breach.obstacle && is_breacher && done + slack(terms_, done) >= breach.cleared_at;
    }

    void judge_openings() {
        for (const Order& order : plan_.orders) {
            if (order.reason == OrderReason::passing) continue;
            if (std::ranges::any_of(plan_.breaches, [&](const Breach& breach) { return waits_for(order, breach); })) {
                continue;
            }
            report("the " + waiting(order).id + " agent has an order to wait until " + text(order.obstacle) +
                       " is breached, and it is not by then",
                   waiting(order).id, order.obstacle);
        }
        if (terms_.rules.timing == Timing::ignore) return;
        for (std::size_t i = 0; i < plan_.agents.size(); ++i) {
            if (plan_.agents[i].kind == AgentKind::ground) judge_entries_of(i);
        }
    }

    void judge_entries_of(std::size_t agent) {
        const Itinerary& ground = plan_.agents[agent];
        const Drive drive =
            judge_ground(map_, plan_, ground, asked(agent), {terms_.rules, asked(agent).body, terms_.tolerance});
        for (const Breach& breach : plan_.breaches) {
            const auto entry = drive.entries.find(breach.obstacle);
            if (entry == drive.entries.end() || breach.by == ground.id) continue;
            const double hair = slack(terms_, entry->second.time) + rounding / asked(agent).speed;
            const double by = entry->second.time + hair;
            const bool waits = std::ranges::any_of(plan_.orders, [&](const Order& order) {
                return order.after.agent == agent && order.reason == OrderReason::opening && waits_for(order, breach) &&
                       time_at(ground.path, order.after) <= by;
            });
            if (waits) continue;
            report("the " + ground.id + " agent has no order to wait until " + text(breach.obstacle) + " is breached",
                   ground.id, breach.obstacle, entry->second.place, entry->second.time);
        }
    }

    void judge_passing() {
        std::vector<std::size_t> drivers;
        std::vector<Extent> reach(plan_.agents.size());
        for (std::size_t i = 0; i < plan_.agents.size(); ++i) {
            if (plan_.agents[i].kind == AgentKind::ground) drivers.push_back(i);
            for (const Waypoint& at : plan_.agents[i].path) reach[i].add(at);
        }
        for (const std::size_t i : drivers) {
            for (const std::size_t j : drivers) {
                const double needed = asked(i).body.reach() + asked(j).body.reach() + terms_.rules.separation -
                                      std::max(terms_.tolerance, rounding);
                if (i == j || needed <= 0 || reach[i].apart(reach[j], needed)) continue;
                // Who comes later is where it comes, whatever others do.
                if (plan_.agents[i].path.front().t != plan_.agents[j].path.front().t) continue;
                judge_pair(i, j, needed);
            }
        }
    }

    // One agent is put where it may be, in steps; the other anywhere. Calling it the other way round too, whatever an
    // order says too little of is met at one of its moments.
    void judge_pair(std::size_t one, std::size_t other, double needed) {
        std::vector<Order> of_both;
        std::vector<double> moments;  // of the one
        for (const Order& order : plan_.orders) {
            const bool first = order.before.agent == one && order.after.agent == other;
            const bool second = order.before.agent == other && order.after.agent == one;
            if (order.reason != OrderReason::passing || !(first || second)) continue;
            of_both.push_back(order);
            moments.push_back(number(first ? order.before : order.after));
        }
        const Path& path = plan_.agents[one].path;
        const std::size_t moves = std::max<std::size_t>(path.size() - 1, 1);
        for (std::size_t move = 0; move < moves; ++move) {
            const Waypoint& end = path[std::min(move + 1, path.size() - 1)];
            const std::vector<std::size_t> near = moves_near(other, extent(path[move], end), needed);
            if (near.empty()) continue;
            const double way = path.size() == 1 ? 0 : length(path, move);
            std::vector<double> places;
            const auto steps = std::size_t(std::ceil(way / longest_step)) + 1;
            for (std::size_t k = 0; k <= steps; ++k) places.push_back(double(move) + double(k) / double(steps));
            for (const double moment : moments) {
                const double hair = way > 0 ? 2 * rounding / way : 0;
                for (const double at : {moment - hair, moment + hair}) {
                    if (at >= double(move) && at <= double(move + 1)) places.push_back(at);
                }
            }
            for (const double at : places) {
                if (!judge_place(one, at, other, near, needed, of_both)) return;
            }
        }
    }

    std::vector<std::size_t> moves_near(std::size_t agent, const Extent& there, double needed) const {
        const Path& path = plan_.agents[agent].path;
        std::vector<std::size_t> near;
        for (std::size_t i = 0; i < std::max<std::size_t>(path.size() - 1, 1); ++i) {
            if (!there.apart(extent(path[i], path[std::min(i + 1, path.size() - 1)]), needed)) near.push_back(i);
        }
        return near;
    }

    bool judge_place(std::size_t one, double at, std::size_t other, const std::vector<std::size_t>& near, double needed,
                     const std::vector<Order>& orders) {
        const Path& path = plan_.agents[one].path;
        const Path& others = plan_.agents[other].path;
        const bool leaves = terms_.rules.at_goal == AtGoal::leave;
        if (leaves && (at >= double(path.size() - 1) || others.size() == 1)) return true;
        const Point here = place_on(path, at);
        for (const std::size_t move : near) {
            const Shares shares = too_near(others[move], others[std::min(move + 1, others.size() - 1)], here, needed);
            if (!(shares.from < shares.to)) continue;
            const bool stands = others.size() == 1;
            const double from = double(move) + (stands ? 0 : shares.from);
            const double to = double(move) + (stands ? 0 : shares.to);
            const bool kept_apart = std::ranges::any_of(orders, [&](const Order& order) {
                if (order.before.agent == one) return at < number(order.before) && number(order.after) <= from;
                return number(order.after) < at && to <= number(order.before);
            });
            if (kept_apart) continue;
            report("no order keeps the " + plan_.agents[one].id + " agent here from the " + plan_.agents[other].id +
                       " agent at " + text(place_on(others, (from + to) / 2)),
                   plan_.agents[one].id, {}, here);
            return false;
        }
        return true;
    }

    // Everybody goes on as far as the orders let it, until nobody does.
    void judge_progress() {
        std::vector<double> progress(plan_.agents.size(), 0);
        for (bool moved = true; moved;) {
            moved = false;
            std::vector<double> limit;
            for (const Itinerary& agent : plan_.agents) limit.push_back(double(agent.path.size() - 1));
            for (const Order& order : plan_.orders) {
                double& least = limit[order.after.agent];
                if (progress[order.before.agent] < number(order.before)) least = std::min(least, number(order.after));
            }
            for (std::size_t i = 0; i < limit.size(); ++i) {
                moved = moved || limit[i] > progress[i];
                progress[i] = std::max(limit[i], progress[i]);
            }
        }
        for (std::size_t i = 0; i < progress.size(); ++i) {
            const Itinerary& agent = plan_.agents[i];
            if (progress[i] >= double(agent.path.size() - 1)) continue;
            report("by the orders the " + agent.id + " agent waits for ever", agent.id, {},
                   place_on(agent.path, progress[i]));
        }
    }

    const Map& map_;
    const Mission& mission_;
    const Plan& plan_;
    const Terms& terms_;
    Violations found_;
};

}  // namespace

Violations judge_orders(const Map& map, const Mission& mission, const Plan& plan, const Terms& terms) {
    return OrdersJudge(map, mission, plan, terms).judge();
}

}  // namespace waybreaker::checker
