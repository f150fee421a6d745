#include "mission/in_windows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/stopwatch.hpp"
#include "mission/explain.hpp"
#include "mission/zone_stays.hpp"
#include "safe_interval/motion.hpp"
#include "safe_interval/traffic.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {
namespace {

using safe_interval::Leg;

constexpr double for_ever = std::numeric_limits<double>::infinity();
constexpr int most_missions = 24;              // that are planned in place of one
constexpr double share_without_windows = 0.5;  // of the time, for the mission without windows
constexpr double share_of_each = 0.25;         // of the time that is left, for each other
constexpr double least_seconds = 1e-3;

// What is imposed on a mission in place of windows, and its plans.
struct Node {
    std::vector<Agent> agents;    // some set out later
    std::vector<bool> permanent;  // by zone: whether it holds all the time
    std::vector<Plan> plans = {};
    double reached = for_ever;
    std::optional<ZoneBreach> breach = {};
};

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

// Whether an agent can stand at its start for longer, and nobody who is bound to come past runs into it.
bool can_stand(const Mission& mission, const Node& node, std::size_t late) {
    const Agent& agent = node.agents[late];
    if (agent.kind == AgentKind::air || agent.approach.empty() || !mission.rules.collisions) return true;
    const Leg standing{{agent.begin().x, agent.begin().y}, {}, agent.ready_at, for_ever};
    for (std::size_t i = 0; i < node.agents.size(); ++i) {
        const Agent& other = node.agents[i];
        if (i == late || other.kind == AgentKind::air) continue;
        const double reach = agent.body.reach() + other.body.reach() + mission.rules.separation -
                             safe_interval::TrafficIndex::planning_slack;
        const auto meets = [&](const Leg& leg) { return !safe_interval::overlap(leg, standing, reach).empty(); };
        if (std::ranges::any_of(safe_interval::TrafficIndex::legs(other.approach, false), meets)) return false;
    }
    return true;
}

// So that it is at the zone when that is over. Vehicles wait at their starts as well as on their way; what they breach
// themselves, and all that aircraft do, takes the same time later.
double put_off(const Agent& agent, const Zone& zone, const Stay& stay) {
    const bool works = agent.kind == AgentKind::air || agent.own_breaches > 0;
    return works ? agent.ready_at + (zone.until - stay.from) : zone.until - stay.driven / agent.speed;
}

void set_out_at(double time, Agent& agent) {
    if (!agent.approach.empty()) agent.approach.push_back({agent.begin().x, agent.begin().y, time});
    // In the air it hovers.
    if (!agent.approach.empty() && agent.kind == AgentKind::air) agent.flown += time - agent.ready_at;
    agent.ready_at = time;
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
          deadline_(limits.seconds) {}

    std::vector<Plan> run() {
        Node first{mission_.agents, std::vector<bool>(mission_.rules.zones.size())};
        plan(first, share_without_windows);
        const Plan relaxed = first.plans.front();
        open_.push_back(std::move(first));
        while (!open_.empty()) {
            const auto best = std::ranges::min_element(open_, {}, &Node::reached);
            const Node node = std::move(*best);
            open_.erase(best);
            if (is_good_enough(node.reached, relaxed)) break;
            if (!node.breach) {
                take(node, relaxed);
                continue;
            }
            if (!nearest_) nearest_ = node.breach;
            hold_all_the_time(node, *node.breach);
            set_out_later(node, *node.breach);
        }
        return finished(relaxed);
    }

  private:
    Mission mission_of(const Node& node) const {
        Mission mission = mission_;
        mission.agents = node.agents;
        mission.rules.zones.clear();
        for (std::size_t i = 0; i < node.permanent.size(); ++i) {
            const Zone& zone = mission_.rules.zones[i];
            if (zone.has_window() && !node.permanent[i]) continue;
            Zone& imposed = mission.rules.zones.emplace_back(zone);
            imposed.from = 0;
            imposed.until = for_ever;
        }
        return mission;
    }

    Limits in_time(double share) const {
        Limits left = limits_;
        left.seconds = std::max(deadline_.left() * share, least_seconds);
        left.progress = nullptr;
        return left;
    }

    void plan(Node& node, double share) {
        ++planned_so_far_;
        node.plans = planned_(mission_of(node), method_, in_time(share));
        const Plan& best = node.plans.front();
        limit_reached_ = limit_reached_ || best.limit_reached;
        is_cut_ = is_cut_ || best.status == PlanStatus::limit_reached || best.status == PlanStatus::stopped;
        if (best.status != PlanStatus::solved) return;
        node.reached = reached(mission_, best.after);
        node.breach = watch_.first_breach(best, node.permanent);
    }

    bool is_good_enough(double reached, const Plan& relaxed) const {
        if (!best_) return false;
        const bool is_near = best_->reached <= relaxed.bound.value_or(0) * (1 + limits_.gap);
        return reached >= best_->reached || is_near;
    }

    void take(const Node& node, const Plan& relaxed) {
        if (best_ && node.reached >= best_->reached) return;
        best_ = node;
        if (limits_.progress && std::isfinite(node.reached))
            limits_.progress({node.reached, std::min(relaxed.bound.value_or(0), node.reached)});
    }

    void hold_all_the_time(const Node& node, const ZoneBreach& breach) {
        Node next{node.agents, node.permanent};
        next.permanent[breach.zone] = true;
        add(std::move(next));
    }

    void set_out_later(const Node& node, const ZoneBreach& breach) {
        const Zone& zone = mission_.rules.zones[breach.zone];
        if (std::isinf(zone.until) || !breach.stay.entered || !can_stand(mission_, node, breach.agent)) return;
        Node next{node.agents, node.permanent};
        Agent& agent = next.agents[breach.agent];
        const double time = put_off(agent, zone, breach.stay);
        if (time <= agent.ready_at) return;
        set_out_at(time, agent);
        add(std::move(next));
    }

    void add(Node node) {
        const auto is_same = [&](const Node& other) {
            return other.permanent == node.permanent &&
                   std::ranges::equal(other.agents, node.agents, {}, &Agent::ready_at, &Agent::ready_at);
        };
        if (std::ranges::any_of(open_, is_same)) return;
        if (planned_so_far_ >= most_missions) return;
        is_cut_ = is_cut_ || deadline_.passed() || limits_.stop.stop_requested();
        if (is_cut_) return;
        try {
            validate(map_, mission_of(node));
        } catch (const InputError&) {
            return;  // a zone that somebody starts or ends in, or that leaves no way
        }
        plan(node, share_of_each);
        if (node.plans.front().status == PlanStatus::solved) open_.push_back(std::move(node));
    }

    std::vector<Plan> finished(const Plan& relaxed) const {
        if (!best_) return {barred(relaxed)};
        std::vector<Plan> plans;
        for (const Plan& plan : best_->plans) {
            if (!plans.empty() && watch_.first_breach(plan, best_->permanent)) continue;
            plans.push_back(plan);
            if (planned_so_far_ > 1) as_asked(relaxed, plans.back());
        }
        plans.front().seconds.total = total_.seconds();
        return plans;
    }

    // What is proven, and what is so without removals, is of the mission without windows.
    void as_asked(const Plan& relaxed, Plan& plan) const {
        plan.before = relaxed.before;
        plan.limit_reached = limit_reached_ || is_cut_;
        prove(relaxed.bound, reached(mission_, plan.after), plan);
    }

    Plan barred(const Plan& relaxed) const {
        Plan none;
        none.before = relaxed.before;
        none.after.routes.clear();
        for (const Route& route : relaxed.after.routes) none.after.routes.push_back(Route{route.kind});
        none.bound = relaxed.bound;
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
    std::vector<Node> open_;
    std::optional<Node> best_;
    std::optional<ZoneBreach> nearest_;  // of the first plan
    int planned_so_far_ = 0;
    bool limit_reached_ = false;  // of some plan
    bool is_cut_ = false;         // what is left to try is not tried
};

// The better of both where what was chosen without zones goes a long way round them: that, or to remove nothing.
std::vector<Plan> searched(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
                           const ZonedPlanner& planned) {
    const Deadline deadline(limits.seconds);
    std::vector<Plan> plans = WindowSearch(map, mission, method, limits, planned).run();
    Plan& plan = plans.front();
    const double best = plan.status == PlanStatus::solved ? reached(mission, plan.after) : for_ever;
    if (mission.rules.removals == 0 || !mission.rules.force.empty() || best <= reached(mission, plan.before))
        return plans;
    Mission nothing = mission;
    nothing.rules.removals = 0;
    Limits left = limits;
    left.seconds = std::max(deadline.left(), least_seconds);
    left.progress = nullptr;
    Plan other = WindowSearch(map, nothing, method, left, planned).run().front();
    plan.limit_reached = plan.limit_reached || other.limit_reached;
    if (other.status != PlanStatus::solved || reached(mission, other.after) >= best) return plans;
    other.before = plan.before;
    other.limit_reached = plan.limit_reached;
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
