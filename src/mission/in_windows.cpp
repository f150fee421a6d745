#include "mission/in_windows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "core/stopwatch.hpp"
#include "mission/explain.hpp"
#include "mission/late_entries.hpp"
#include "mission/window_node.hpp"
#include "mission/zone_stays.hpp"
#include "model/in_zones.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

constexpr double for_ever = std::numeric_limits<double>::infinity();
constexpr int most_missions = 24;              // that are planned in place of one
constexpr double share_without_windows = 0.5;  // of the time, for the mission without windows
constexpr double share_of_each = 0.25;         // of the time that is left, for each other
constexpr double least_seconds = 1e-3;

double reached(const Mission& mission, const Outcome& outcome) {
    return value(outcome, mission.rules.objective).value_or(for_ever);
}

// Sets the bound, of which another mission is the proof, and the gap of a plan that reaches so much.
void prove(std::optional<double> bound, double reached, Plan& plan) {
    plan.least_demolition.reset();
    plan.bound = bound;
    plan.gap.reset();
    if (plan.status != PlanStatus::solved || !bound) return;
    plan.bound = std::min(*bound, reached);
    plan.gap = *plan.bound > 0 ? reached / *plan.bound - 1 : 0;
}

// The only agent that may breach, if it flies, and how much longer it flies at least if anything is removed.
struct OnlyBreacher {
    std::string id = {};
    double least_breach = 0;
};

OnlyBreacher only_breacher(const Map& map, const Mission& mission) {
    const Agent* only = nullptr;
    for (const Agent& agent : mission.agents) {
        if (agent.kind == AgentKind::air ? agent.breaches == 0 : agent.own_breaches == 0) continue;
        if (only != nullptr || agent.kind == AgentKind::ground) return {};
        only = &agent;
    }
    if (only == nullptr || mission.rules.timing == Timing::ignore) return {};
    double least = for_ever;
    for (const Obstacle& obstacle : map.obstacles()) {
        if (obstacle.destructible && !obstacle.gone())
            least = std::min(least, time_to_breach(*only, obstacle, mission.rules));
    }
    return {only->id, std::isfinite(least) ? least : 0};
}

class WindowSearch {
  public:
    WindowSearch(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
                 const ZonedPlanner& planned)
        : map_(map),
          mission_(mission),
          method_(method),
          limits_(limits),
          planned_(planned),
          watch_(map, mission),
          deadline_(limits.seconds),
          only_breacher_(only_breacher(map, mission)) {}

    std::vector<Plan> run() {
        WindowNode first{mission_.agents, std::vector<bool>(mission_.rules.zones.size())};
        plan(first, share_without_windows);
        const Plan relaxed = first.plans.front();
        bound_ = relaxed.bound;
        open_.push_back(std::move(first));
        while (!open_.empty()) {
            const auto best = std::ranges::min_element(open_, {}, &WindowNode::reached);
            const WindowNode node = std::move(*best);
            open_.erase(best);
            if (is_good_enough(node.reached)) break;
            if (!node.breach) {
                take(node);
                continue;
            }
            const ZoneBreach breach = *node.breach;
            if (!nearest_) nearest_ = breach;
            hold_all_the_time(node, breach);
            set_out_later(node, breach);
            fly_in_later(node, breach);
        }
        return finished(relaxed);
    }

    // Of the makespan of plans that remove anything, once it has run.
    double bound_if_removing() const { return bound_if_removing_; }

  private:
    Limits in_time(double share) const {
        Limits left = limits_;
        left.seconds = std::max(deadline_.left() * share, least_seconds);
        left.progress = nullptr;
        return left;
    }

    void plan(WindowNode& node, double share) {
        ++planned_so_far_;
        node.plans = planned_(node.mission_in(mission_), method_, in_time(share));
        for (Plan& plan : node.plans) node.begin_as_asked(mission_, plan);
        const Plan& best = node.plans.front();
        limit_reached_ = limit_reached_ || best.limit_reached;
        is_cut_ = is_cut_ || best.status == PlanStatus::limit_reached || best.status == PlanStatus::stopped;
        if (best.status != PlanStatus::solved) return;
        node.reached = reached(mission_, best.after);
        node.breach = first_breach(node, best);
    }

    // What flies to an entry is not planned, and may meet any zone.
    std::optional<ZoneBreach> first_breach(const WindowNode& node, const Plan& plan) const {
        std::vector<bool> passed = node.permanent;
        for (std::size_t i = 0; i < node.agents.size(); ++i) {
            if (node.is_at_entry(mission_, i)) passed.assign(passed.size(), false);
        }
        return watch_.first_breach(plan, passed);
    }

    // Whoever keeps out of the permanent zones is no sooner than what is planned without them is proven to be; whoever
    // does not, as an aircraft that has no way round them, flies into one when that is over.
    void bound_by(const WindowNode& node) {
        if (!bound_ || node.is_anybody_late(mission_) || mission_.rules.objective != Objective::makespan) return;
        const Mission held = flown(node);
        double least = for_ever;
        double least_if_removing = for_ever;
        for (Agent agent : held.agents) {
            if (agent.kind != AgentKind::air) continue;
            if (!agent.airspace.allows(agent.begin())) return;
            double enters = for_ever;
            double enters_if_removing = for_ever;
            for (std::size_t i = 0; i < node.permanent.size(); ++i) {
                const Zone& zone = mission_.rules.zones[i];
                if (!node.permanent[i]) continue;
                if (zone.kind != ZoneKind::no_fly) return;
                if (!holds_for(zone, agent)) continue;
                const auto arrival = [&] {
                    return least_arrival_past(map_, agent, held.rules.zones, zone, Point(agent.goal));
                };
                // Who breaches does so before it enters or after that.
                const double at_once = arrival();
                const double breach = agent.id == only_breacher_.id ? only_breacher_.least_breach : 0;
                agent.ready_at += breach;
                const double later = arrival();
                agent.ready_at -= breach;
                enters = std::min(enters, at_once);
                enters_if_removing = std::min({enters_if_removing, later, at_once + breach});
            }
            const bool has_way = std::isfinite(agent.airspace.length(agent.begin(), Point(agent.goal)));
            if (!has_way && std::isfinite(enters)) raise_bounds(enters, enters_if_removing);
            least = std::min(least, enters);
            least_if_removing = std::min(least_if_removing, enters_if_removing);
        }
        if (node.plans.empty()) return;
        const std::optional<double>& proven = node.plans.front().bound;
        if (proven) raise_bounds(std::min(*proven, least), std::min(*proven, least_if_removing));
    }

    void raise_bounds(double bound, double bound_if_removing) {
        bound_ = std::max(bound_.value_or(bound), bound);
        bound_if_removing_ = std::max(bound_if_removing_, bound_if_removing);
    }

    // The mission of a node, with its airspaces.
    Mission flown(const WindowNode& node) const {
        Mission mission = node.mission_in(mission_);
        set_airspaces(map_, mission);
        return mission;
    }

    bool is_good_enough(double reached) const {
        if (!best_) return false;
        const bool is_near = best_->reached <= bound_.value_or(0) * (1 + limits_.gap);
        return reached >= best_->reached || is_near;
    }

    void take(const WindowNode& node) {
        if (best_ && node.reached >= best_->reached) return;
        best_ = node;
        if (limits_.progress && std::isfinite(node.reached))
            limits_.progress({node.reached, std::min(bound_.value_or(0), node.reached)});
    }

    void hold_all_the_time(const WindowNode& node, const ZoneBreach& breach) {
        WindowNode next{node.agents, node.permanent};
        next.permanent[breach.zone] = true;
        add(std::move(next));
    }

    void set_out_later(const WindowNode& node, const ZoneBreach& breach) {
        if (node.is_at_entry(mission_, breach.agent)) return;
        if (std::optional<WindowNode> next = node.put_off(mission_, breach)) add(std::move(*next));
    }

    // On the way to where it goes next, and on the way to its goal.
    void fly_in_later(const WindowNode& node, const ZoneBreach& breach) {
        const Zone& zone = mission_.rules.zones[breach.zone];
        if (std::isinf(zone.until) || zone.kind != ZoneKind::no_fly) return;
        WindowNode closed{node.agents, node.permanent};
        closed.permanent[breach.zone] = true;
        const Mission held = flown(closed);
        const Agent& agent = held.agents[breach.agent];
        if (!agent.airspace.allows(agent.begin())) return;
        const Plan& plan = node.plans.front();
        std::vector<Point> goals{Point(agent.goal)};
        for (const Breach& next : plan.breaches) {
            const bool is_own = next.by.empty() || next.by == agent.id;
            if (is_own && next.cleared_at >= breach.stay.from && goals.size() == 1) goals.emplace_back(next.at);
        }
        for (const Point goal : goals) {
            const auto entry = earliest_entry(map_, agent, held.rules.zones, zone, goal);
            if (!entry) continue;
            const auto late = come_to(map_, *entry, mission_.agents[breach.agent], agent);
            if (!late) continue;
            WindowNode next{node.agents, node.permanent};
            next.agents[breach.agent] = *late;
            add(std::move(next));
        }
    }

    void add(WindowNode node) {
        if (std::ranges::any_of(open_, [&](const WindowNode& other) { return other.imposes_the_same(node); })) return;
        if (planned_so_far_ >= most_missions) return;
        is_cut_ = is_cut_ || deadline_.passed() || limits_.stop.stop_requested();
        if (is_cut_) return;
        try {
            validate(map_, node.mission_in(mission_));
        } catch (const InputError&) {
            bound_by(node);
            return;  // a zone that somebody starts or ends in, or that leaves no way
        }
        plan(node, share_of_each);
        bound_by(node);
        const bool is_solved = node.plans.front().status == PlanStatus::solved;
        const bool has_no_child = node.breach && node.permanent[node.breach->zone];
        if (is_solved && !has_no_child) open_.push_back(std::move(node));
    }

    std::vector<Plan> finished(const Plan& relaxed) const {
        if (!best_) return {barred(relaxed)};
        std::vector<Plan> plans;
        for (const Plan& plan : best_->plans) {
            if (!plans.empty() && first_breach(*best_, plan)) continue;
            plans.push_back(plan);
            if (planned_so_far_ > 1) as_asked(relaxed, plans.back());
        }
        plans.front().seconds.total = total_.seconds();
        return plans;
    }

    // What is so without removals is of the mission without windows.
    void as_asked(const Plan& relaxed, Plan& plan) const {
        plan.before = relaxed.before;
        plan.limit_reached = limit_reached_ || is_cut_;
        prove(bound_, reached(mission_, plan.after), plan);
    }

    Plan barred(const Plan& relaxed) const {
        Plan none;
        none.before = relaxed.before;
        none.after.routes.clear();
        for (const Route& route : relaxed.after.routes) none.after.routes.push_back(Route{route.kind});
        none.bound = bound_;
        none.limit_reached = limit_reached_ || is_cut_;
        none.status = limits_.stop.stop_requested() ? PlanStatus::stopped
                      : is_cut_                     ? PlanStatus::limit_reached
                                                    : PlanStatus::not_found;
        if (nearest_) none.barred_by = BarredBy{nearest_->zone + 1, mission_.agents[nearest_->agent].id, nearest_->at};
        none.seconds = relaxed.seconds;
        none.seconds.total = total_.seconds();
        return none;
    }

    const Map& map_;
    const Mission& mission_;
    const Method& method_;
    const Limits& limits_;
    const ZonedPlanner& planned_;
    ZoneWatch watch_;
    Deadline deadline_;
    Stopwatch total_;
    std::vector<WindowNode> open_;
    std::optional<WindowNode> best_;
    std::optional<double> bound_;
    double bound_if_removing_ = 0;
    OnlyBreacher only_breacher_;
    std::optional<ZoneBreach> nearest_;  // of the first plan
    int planned_so_far_ = 0;
    bool limit_reached_ = false;  // of some plan
    bool is_cut_ = false;         // what is left to try is not tried
};

// The better of both where what was chosen without zones goes a long way round them: that, or to remove nothing. No
// plan is below the bounds of both.
std::vector<Plan> searched(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
                           const ZonedPlanner& planned) {
    const Deadline deadline(limits.seconds);
    WindowSearch search(map, mission, method, limits, planned);
    std::vector<Plan> plans = search.run();
    Plan& plan = plans.front();
    const double best = plan.status == PlanStatus::solved ? reached(mission, plan.after) : for_ever;
    const double unproven = plan.bound ? std::min(best, search.bound_if_removing()) - *plan.bound : 0;
    const bool has_choice = mission.rules.removals > 0 && mission.rules.force.empty();
    if (!has_choice || (best <= reached(mission, plan.before) && unproven <= 0)) return plans;
    Mission nothing = mission;
    nothing.rules.removals = 0;
    Limits left = limits;
    left.seconds = std::max(deadline.left(), least_seconds);
    left.progress = nullptr;
    Plan other = WindowSearch(map, nothing, method, left, planned).run().front();
    const bool is_limited = plan.limit_reached || other.limit_reached;
    const double without = other.status == PlanStatus::no_plan ? for_ever : other.bound.value_or(0);
    if (plan.bound) {
        const double bound = std::max(*plan.bound, std::min(without, search.bound_if_removing()));
        for (Plan& proven : plans) prove(bound, reached(mission, proven.after), proven);
    }
    plan.limit_reached = is_limited;
    if (other.status != PlanStatus::solved || reached(mission, other.after) >= best) return plans;
    other.before = plan.before;
    other.limit_reached = is_limited;
    prove(plan.bound, reached(mission, other.after), other);
    if (plan.status != PlanStatus::solved) plans.clear();
    plans.insert(plans.begin(), std::move(other));
    return plans;
}

}  // namespace

bool has_windows(const Mission& mission) {
    return std::ranges::any_of(mission.rules.zones, &Zone::has_window);
}

std::vector<Plan> in_windows(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
                             const ZonedPlanner& planned) {
    const Stopwatch total;
    const Deadline deadline(limits.seconds);
    Method plain = method;
    plain.explain = false;
    std::vector<Plan> plans = searched(map, mission, plain, limits, planned);
    Plan& plan = plans.front();
    plan.seconds.total = total.seconds();
    if (!method.explain || plan.status != PlanStatus::solved) return plans;
    const auto again = [&](const Mission& other, const Limits& left) {
        return searched(map, other, plain, left, planned).front();
    };
    explain_team(map, mission, limits, deadline, again, plan);
    plan.seconds.total = total.seconds();
    return plans;
}

}  // namespace waybreaker
