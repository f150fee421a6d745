// Whether a plan holds numbers only: a comparison with one that is none is false, whichever way it is asked.
#include <limits>

#include "check/judge.hpp"

namespace waybreaker::checker {
namespace {

class NumbersJudge {
  public:
    Violations judge(const Plan& plan) {
        judge_outcome(plan.before, true);
        judge_outcome(plan.after, false);
        require(Rule::bound, "the bound", plan.bound);
        require(Rule::gap, "the gap", plan.gap);
        for (const Breach& breach : plan.breaches) judge_breach(breach);
        for (const NextBreach& next : plan.next) {
            require(Rule::next, "what it saves to remove " + text(next.obstacle) + " next", next.saves);
        }
        for (const Itinerary& agent : plan.agents) judge_agent(agent);
        for (const Order& order : plan.orders) {
            for (const double value : {order.before.fraction, order.after.fraction, order.slack}) {
                require(Rule::orders, "a number of an order", value, "", order.obstacle);
            }
        }
        return std::move(found_);
    }

  private:
    void require(Rule rule, const std::string& what, std::optional<double> value, const std::string& agent = "",
                 ObstacleId obstacle = {}) {
        if (!value || std::isfinite(*value) || found_.size() > enough_violations) return;
        found_.push_back({rule, what + " is " + text(*value) + ", which is no finite number", agent, obstacle});
    }

    void judge_outcome(const Outcome& outcome, bool before) {
        const std::string when = before ? "before removal " : "";
        const auto rule = [before](Rule after) { return before ? Rule::before : after; };
        require(rule(Rule::makespan), when + "the makespan", outcome.makespan);
        require(rule(Rule::flowtime), when + "the flowtime", outcome.flowtime);
        require(rule(Rule::ground_makespan), when + "the ground agents' arrival", outcome.ground_makespan);
        for (const Route& route : outcome.routes) {
            require(rule(Rule::length), when + "the length of a route", route.length);
            for (const Point& point : route.path) {
                for (const double value : {point.x, point.y}) {
                    require(rule(Rule::length), when + "a point of a route", value);
                }
            }
        }
    }

    void judge_breach(const Breach& breach) {
        const std::string who = text(breach.obstacle);
        const auto require_of = [&](Rule rule, const std::string& what, std::optional<double> value) {
            require(rule, what + " " + who, value, breach.by, breach.obstacle);
        };
        require_of(Rule::breach, "when somebody has breached", breach.cleared_at);
        require_of(Rule::breach, "when somebody begins to breach", breach.begun_at);
        require_of(Rule::entered, "when somebody enters", breach.entered_at);
        // Infinity: there is no plan without it.
        if (breach.saves != std::numeric_limits<double>::infinity()) {
            require_of(Rule::saves, "what it saves to remove", breach.saves);
        }
        if (breach.if_failed && breach.if_failed->objective != std::numeric_limits<double>::infinity()) {
            require_of(Rule::if_failed, "what the mission comes to without", breach.if_failed->objective);
        }
    }

    void judge_agent(const Itinerary& agent) {
        const std::string who = "the " + agent.id + " agent";
        require(Rule::agents, who + "'s speed", agent.speed, agent.id);
        require(Rule::gain, who + "'s gain", agent.gain, agent.id);
        for (const Waypoint& point : agent.path) {
            for (const double value : {point.x, point.y, point.t}) {
                require(Rule::agents, "a number of " + who + "'s path", value, agent.id);
            }
        }
        for (const Wait& wait : agent.waits) {
            for (const double value : {wait.at.x, wait.at.y, wait.from, wait.until}) {
                require(Rule::waits, "a number of " + who + "'s waits", value, agent.id, wait.obstacle);
            }
        }
        for (const Recharge& recharge : agent.recharges) {
            for (const double value : {recharge.from, recharge.until, recharge.flown}) {
                require(Rule::range, "a number of " + who + "'s recharges", value, agent.id);
            }
        }
    }

    Violations found_;
};

}  // namespace

Violations judge_numbers(const Plan& plan) {
    return NumbersJudge().judge(plan);
}

}  // namespace waybreaker::checker
