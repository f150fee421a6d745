// An execution of a plan, one move at a time: who moves goes as far as somebody likes and the orders let it, all others
// stand. What any delays can lead to is met so, too, for an order asks where agents are and not when. Knows nothing of
// planner or checker.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "team/simulation.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

class Execution {
  public:
    Execution(const Map& map, const Mission& mission, const Plan& plan, std::vector<Order> orders)
        : map_(map), mission_(mission), plan_(plan), orders_(std::move(orders)), progress_(plan.agents.size()) {}

    // Points of its path that the agent has passed, and the share of the move to the next one.
    double progress(std::size_t agent) const { return progress_[agent]; }
    double end(std::size_t agent) const { return double(plan_.agents[agent].path.size() - 1); }
    // How far the orders let it go.
    double limit(std::size_t agent) const {
        double limit = end(agent);
        for (const Order& order : orders_) {
            if (order.after.agent != agent || happened(order.before)) continue;
            limit = std::min(limit, number(order.after));
        }
        return std::max(limit, progress_[agent]);
    }

    // Goes on to there, if it is not there yet. False: on its way it meets a disc, or an obstacle that stands.
    bool go(std::size_t agent, double to) {
        const bool drives = plan_.agents[agent].kind == AgentKind::ground;
        while (progress_[agent] < to) {
            const double from = progress_[agent];
            const double next = std::min(std::floor(from) + 1, to);
            progress_[agent] = next;
            if (drives && (meets_disc(agent, from, next) || meets_obstacle(agent, from, next))) return false;
        }
        return true;
    }

    static double number(const Moment& moment) { return double(moment.point) + moment.fraction; }
    const std::string& fault() const { return fault_; }

  private:
    bool happened(const Moment& moment) const { return progress_[moment.agent] >= number(moment); }

    Point place(std::size_t agent, double progress) const {
        const std::vector<Waypoint>& path = plan_.agents[agent].path;
        const auto i = std::min(std::size_t(progress), path.size() - 1);
        const double share = progress - double(i);
        if (share == 0) return {path[i].x, path[i].y};
        return {std::lerp(path[i].x, path[i + 1].x, share), std::lerp(path[i].y, path[i + 1].y, share)};
    }

    bool meets_disc(std::size_t agent, double from, double to) {
        constexpr double slack = 1e-7;
        const Point a = place(agent, from);
        const Point b = place(agent, to);
        // Who leaves its goal is gone when it is there.
        const bool leaves = mission_.rules.at_goal == AtGoal::leave;
        for (std::size_t other = 0; other < progress_.size(); ++other) {
            if (other == agent || plan_.agents[other].kind == AgentKind::air) continue;
            if (leaves && progress_[other] == end(other)) continue;
            const Point at = place(other, progress_[other]);
            const double dx = b.x - a.x;
            const double dy = b.y - a.y;
            const double length2 = dx * dx + dy * dy;
            const double share =
                length2 > 0 ? std::clamp(((at.x - a.x) * dx + (at.y - a.y) * dy) / length2, 0.0, 1.0) : 0;
            const double apart = distance({a.x + share * dx, a.y + share * dy}, at);
            const double needed =
                mission_.agents[agent].body.reach() + mission_.agents[other].body.reach() + mission_.rules.separation;
            if (apart >= needed - slack) continue;
            fault_ = plan_.agents[agent].id + " at " + std::to_string(from + share * (to - from)) + " meets " +
                     plan_.agents[other].id + " at " + std::to_string(progress_[other]);
            return true;
        }
        return false;
    }

    bool meets_obstacle(std::size_t agent, double from, double to) {
        constexpr double slack = 1e-7;
        constexpr double step = 0.02;
        if (plan_.breaches.empty() || mission_.rules.timing == Timing::ignore) return false;
        const auto is_gone = [&](ObstacleId obstacle) {
            return std::ranges::any_of(plan_.breaches, [&](const Breach& breach) {
                if (breach.obstacle != obstacle) return false;
                const auto flies = [&](const Itinerary& one) {
                    return one.kind == AgentKind::air && (breach.by.empty() || one.id == breach.by);
                };
                const auto by = std::ranges::find_if(plan_.agents, flies);
                const auto done =
                    std::ranges::find_if(by->path, [&](const Waypoint& at) { return at.t > breach.cleared_at - 1e-7; });
                return progress_[std::size_t(by - plan_.agents.begin())] >= double(done - by->path.begin());
            });
        };
        const double length = distance(place(agent, from), place(agent, to));
        const int steps = int(length / step) + 1;
        for (int i = 0; i <= steps; ++i) {
            const double at = from + (to - from) * i / steps;
            const double radius = mission_.agents[agent].body.reach();
            if (simulated_depth(map_, place(agent, at), radius, is_gone) <= slack) continue;
            fault_ = plan_.agents[agent].id + " at " + std::to_string(at) + " is in a wall";
            return true;
        }
        return false;
    }

    const Map& map_;
    const Mission& mission_;
    const Plan& plan_;
    std::vector<Order> orders_;
    std::vector<double> progress_;
    std::string fault_;
};

}  // namespace waybreaker
