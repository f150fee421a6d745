// Plans of teams: each agent as that of a plan for one, all of them together, and figures that add up.
#include <map>
#include <set>

#include "check/judge.hpp"

namespace waybreaker::checker {
namespace {

class TeamJudge {
  public:
    TeamJudge(const Map& map, const Mission& mission, const Plan& plan, const Terms& terms)
        : map_(map), mission_(mission), plan_(plan), terms_(terms) {
        for (const Agent& agent : mission.agents) agents_.emplace(agent.id, &agent);
    }

    Violations judge() {
        append(found_, judge_removals(map_, plan_, terms_));
        judge_sharing();
        if (!has_routes(plan_.before) || !has_routes(plan_.after)) return std::move(found_);
        if (plan_.agents.empty()) {
            judge_without_paths();
        } else if (is_complete()) {
            judge_paths();
        }
        judge_bound(plan_, terms_, found_);
        return std::move(found_);
    }

  private:
    void report(Rule rule, const std::string& message, const std::string& agent = "") {
        found_.push_back({rule, message, agent});
    }
    void expect(Rule rule, const std::string& what, std::optional<double> stated, double truth) {
        if (stated && agree(terms_, *stated, truth)) return;
        report(rule, what + " is " + (stated ? text(*stated) : "missing") + " instead of " + text(truth));
    }

    bool has_routes(const Outcome& outcome) {
        if (outcome.routes.size() == mission_.agents.size()) return true;
        report(Rule::agents, "there are " + std::to_string(outcome.routes.size()) + " routes for " +
                                 std::to_string(mission_.agents.size()) + " agents");
        return false;
    }

    // Each obstacle is removed by an agent of the mission that may, and none removes more than it may.
    void judge_sharing() {
        const auto may = [](const Agent& agent) { return agent.kind == AgentKind::air || agent.own_breaches > 0; };
        const auto one_may = [&](const auto& agent) { return may(*agent.second); };
        if (!plan_.breaches.empty() && std::none_of(agents_.begin(), agents_.end(), one_may)) {
            report(Rule::removals, "obstacles are removed, and there is no air agent");
        }
        std::map<std::string, int> count;
        double before = 0;
        for (const Breach& breach : plan_.breaches) {
            const std::string what = text(breach.obstacle);
            const auto fault = [&](Rule rule, const std::string& message) {
                found_.push_back({rule, message, breach.by, breach.obstacle, breach.at, breach.cleared_at});
            };
            const auto agent = agents_.find(breach.by);
            if (agent == agents_.end() || !may(*agent->second)) {
                fault(Rule::breach, what + " is breached by '" + breach.by + "', which is no air agent of the mission");
            } else if (++count[breach.by] == most_breaches(*agent->second) + 1LL) {
                fault(Rule::capacity, beyond_capacity(*agent->second));
            }
            if (names_obstacle(map_, breach.obstacle) && agent != agents_.end()) {
                const double time = lasting(*agent->second, map_.obstacle(breach.obstacle), terms_.rules);
                const bool stated = breach.begun_at && agree(terms_, *breach.begun_at, breach.cleared_at - time);
                if (!stated)
                    fault(Rule::breach, what + "'s breach does not begin " + text(time) + " before it is over");
            }
            if (breach.cleared_at < before - slack(terms_, before)) {
                fault(Rule::order, what + " is cleared before the one listed before it");
            }
            before = breach.cleared_at;
        }
    }

    // Each agent of the mission has one path.
    bool is_complete() {
        std::set<std::string> planned;
        bool complete = plan_.agents.size() == mission_.agents.size();
        for (const Itinerary& agent : plan_.agents) {
            if (planned.insert(agent.id).second) continue;
            report(Rule::agents, "there are two paths for " + agent.id, agent.id);
            complete = false;
        }
        for (const Agent& agent : mission_.agents) {
            if (planned.contains(agent.id)) continue;
            report(Rule::agents, "there is no path for " + agent.id, agent.id);
            complete = false;
        }
        return complete;
    }

    void judge_without_paths() {
        if (plan_.status == PlanStatus::solved) report(Rule::status, "the plan is solved, but there are no agents");
        if (plan_.after.makespan || plan_.after.flowtime || plan_.after.ground_makespan) {
            report(Rule::status, "figures without agents that reach them");
        }
    }

    void judge_paths() {
        if (plan_.status != PlanStatus::solved) report(Rule::status, "there is no plan, but agents have paths");
        bool broken = false;
        bool followed = true;
        std::vector<Disc> discs;
        Entries entries;
        for (const Itinerary& path : plan_.agents) {
            const Agent& agent = *agents_.at(path.id);
            const Terms terms{terms_.rules, agent.body, terms_.tolerance};
            const Violations times = judge_timetable(path, &agent, breaches_by(agent.id), terms);
            append(found_, times);
            const bool unreadable = std::any_of(times.begin(), times.end(), [](const Violation& v) {
                return v.rule == Rule::agents || v.rule == Rule::time;
            });
            broken = broken || unreadable;
            if (unreadable) continue;
            append(found_, judge_waits(plan_, path, agent.ready_at, terms));
            append(found_, judge_gain(path, agent.ready_at, alone(path.id), terms));
            const bool may_be_early = agent.kind == AgentKind::ground || agent.ready_at > 0;
            if (may_be_early) append(found_, judge_ready(path, agent, terms_));
            append(found_, judge_breaches(map_, breaches_by(agent.id), path, agent, terms));
            if (agent.kind == AgentKind::air) continue;
            Drive drive = judge_ground(map_, plan_, path, agent, terms);
            append(found_, std::move(drive.found));
            followed = followed && drive.followed;
            if (drive.followed) append(found_, judge_rubble(map_, plan_, path, agent, drive.entries, terms));
            for (const auto& [obstacle, contact] : drive.entries) {
                const auto [known, is_new] = entries.emplace(obstacle, contact);
                if (!is_new && contact.time < known->second.time) known->second = contact;
            }
            discs.push_back({&path, agent.body.reach()});
        }
        if (!broken && followed) append(found_, judge_entries(map_, plan_, entries, "", terms_));
        if (terms_.rules.collisions) append(found_, judge_separation(discs, terms_));
        if (!broken) judge_figures();
    }

    // How long that agent's way is without removals.
    std::optional<double> alone(const std::string& id) const {
        const auto is_it = [&](const Agent& agent) { return agent.id == id; };
        const auto agent = std::find_if(mission_.agents.begin(), mission_.agents.end(), is_it);
        return plan_.before.routes[std::size_t(agent - mission_.agents.begin())].length;
    }

    std::vector<Breach> breaches_by(const std::string& id) const {
        std::vector<Breach> own;
        std::copy_if(plan_.breaches.begin(), plan_.breaches.end(), std::back_inserter(own),
                     [&](const Breach& breach) { return breach.by == id; });
        return own;
    }

    void judge_figures() {
        double makespan = 0;
        double ground_makespan = 0;
        double flowtime = 0;
        double alone = 0;
        double alone_sum = 0;
        bool all_alone = true;  // get there without removals
        bool any_recharges = false;
        for (std::size_t i = 0; i < mission_.agents.size(); ++i) {
            const Itinerary& path = plan_.agents[i];
            const Agent& agent = *agents_.at(path.id);
            const double end = path.path.back().t;
            makespan = std::max(makespan, end);
            flowtime += agent.weight * end;
            if (agent.kind == AgentKind::ground) ground_makespan = std::max(ground_makespan, end);
            double driven = 0;
            for (std::size_t k = 1; k < path.path.size(); ++k) {
                driven += std::hypot(path.path[k].x - path.path[k - 1].x, path.path[k].y - path.path[k - 1].y);
            }
            if (path.reached) {
                expect(Rule::length, "the " + agent.id + " agent's length", plan_.after.routes[i].length, driven);
            } else if (plan_.after.routes[i].length) {
                report(Rule::length, "the " + agent.id + " agent is not reached, and drives all the same");
            }
            const Point start = agent.from.value_or(Point(agent.start));
            const double straight = std::hypot(agent.goal.x - start.x, agent.goal.y - start.y);
            const bool may_stay = agent.kind == AgentKind::ground && terms_.rules.unreached;
            all_alone = all_alone && (plan_.before.routes[i].length || may_stay);
            const double length = plan_.before.routes[i].length.value_or(straight);
            if (length < straight - slack(terms_, straight)) {
                report(Rule::before, "alone, the " + agent.id + " agent's length is below the straight line's");
            }
            double arrival = agent.ready_at + length / agent.speed;
            if (may_stay) {
                const double latest = std::max(*terms_.rules.unreached, agent.ready_at);
                arrival = plan_.before.routes[i].length ? std::min(arrival, latest) : latest;
            }
            any_recharges = any_recharges || agent.recharge;
            alone = std::max(alone, arrival);
            alone_sum += agent.weight * arrival;
        }
        expect(Rule::makespan, "the makespan", plan_.after.makespan, makespan);
        expect(Rule::flowtime, "the flowtime", plan_.after.flowtime, flowtime);
        expect(Rule::ground_makespan, "the ground agents' arrival", plan_.after.ground_makespan, ground_makespan);
        if (!all_alone) {
            if (plan_.before.makespan || plan_.before.flowtime ||
                (plan_.breaches.empty() && terms_.rules.opened.empty())) {
                report(Rule::before, "some agents have no way alone, and there are figures all the same");
            }
            return;
        }
        // They may have to wait for what opens by itself, or to recharge.
        if (!terms_.rules.opened.empty() || any_recharges) return;
        expect(Rule::before, "the makespan of all, each alone,", plan_.before.makespan, alone);
        expect(Rule::before, "the flowtime of all, each alone,", plan_.before.flowtime, alone_sum);
    }

    const Map& map_;
    const Mission& mission_;
    const Plan& plan_;
    const Terms& terms_;
    std::map<std::string, const Agent*> agents_;
    Violations found_;
};

}  // namespace

Violations judge_team(const Map& map, const Mission& mission, const Plan& plan, const Terms& terms) {
    return TeamJudge(map, mission, plan, terms).judge();
}

}  // namespace waybreaker::checker
