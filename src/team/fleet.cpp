#include "team/fleet.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "model/objective.hpp"
#include "safe_interval/driven.hpp"
#include "safe_interval/traffic.hpp"
#include "team/tuning.hpp"

namespace waybreaker::team {
namespace {

struct Times {
    double from;
    double to;
};

// When any of them moves, one after the other.
std::vector<Times> moves_of(std::span<const Path> paths) {
    std::vector<Times> moves;
    for (const Path& path : paths) {
        for (std::size_t i = 1; i < path.size(); ++i) {
            const bool stands = path[i].x == path[i - 1].x && path[i].y == path[i - 1].y;
            if (!stands) moves.push_back({path[i - 1].t, path[i].t});
        }
    }
    std::ranges::sort(moves, {}, &Times::from);  // of those that begin at one time only the latest end matters
    return moves;
}

}  // namespace

bool better(const Cost& a, const Cost& b) {
    if (a.missing != b.missing) return a.missing < b.missing;
    const auto less = [](double x, double y) { return x < y - 1e-9 * std::max(y, 1.0); };
    if (less(a.first, b.first)) return true;
    return !less(b.first, a.first) && less(a.second, b.second);
}

Fleet::Fleet(const Ground& ground, std::span<const Vehicle> vehicles, const Rules& rules, const Interrupts& interrupts)
    : ground_(ground),
      vehicles_(vehicles),
      rules_(rules),
      interrupts_(interrupts),
      traffic_(ground.map.width(), ground.map.height(), rules.separation),
      paths_(vehicles.size()),
      hold_(vehicles.size()) {
    hold_as_at_first();
    for (std::uint32_t i = 0; i < vehicles.size(); ++i) stand_at_start(i);
}

bool Fleet::hold_as_at_first() {
    bool held_longer = false;
    for (std::uint32_t i = 0; i < size(); ++i) {
        const Agent& agent = vehicles_[i].agent;
        const double hold =
            agent.ready_at + tuning::first_hold * std::max(agent.body.reach() + rules_.separation, 0.1) / agent.speed;
        held_longer = held_longer || hold_[i] > hold;
        hold_[i] = hold;
    }
    return held_longer;
}

Cost cost_of(std::span<const Vehicle> vehicles, std::span<const Path> paths, Objective objective) {
    Cost cost;
    Finish finish;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        if (paths[i].empty()) {
            ++cost.missing;
        } else {
            finish.add(vehicles[i].agent, paths[i].back().t);
        }
    }
    const Rank figures = rank(objective, finish);
    cost.first = figures.first;
    cost.second = figures.second;
    return cost;
}

double Fleet::latest_arrival(const Cost& cost, std::uint32_t i) const {
    constexpr double rounding = 1e-9;
    double left = cost.first * (1 + rounding) + rounding;
    if (rules_.objective != Objective::flowtime) return left;
    const auto weight = [this](std::uint32_t vehicle) { return vehicles_[vehicle].agent.weight; };
    for (std::uint32_t other = 0; other < size(); ++other) {
        if (other != i) left -= weighted(weight(other), has_path(other) ? arrival(other) : vehicles_[other].alone);
    }
    return weight(i) > 0 ? left / weight(i) : std::numeric_limits<double>::infinity();
}

void Fleet::stand_at_start(std::uint32_t i) {
    const Agent& agent = vehicles_[i].agent;
    Path standing = agent.approach;
    if (standing.empty()) standing.push_back({double(agent.start.x), double(agent.start.y), 0});
    const Waypoint& last = standing.back();
    standing.push_back({last.x, last.y, std::max(last.t, std::min(hold_[i], tuning::longest_hold))});
    traffic_.add(i, standing, agent.body.reach(), false);
}

SafeIntervalOptions driving(const Ground& ground, const Vehicle& vehicle) {
    SafeIntervalOptions options;
    options.body = vehicle.agent.body;
    options.speed = vehicle.agent.speed;
    options.ready_at = vehicle.agent.ready_at;
    if (!vehicle.agent.approach.empty()) options.since = options.ready_at;
    options.openings = ground.openings;
    options.rubble = ground.rubble;
    options.known = vehicle.way;
    return options;
}

Path after_approach(const Agent& agent, std::span<const Waypoint> path) {
    Path whole = agent.approach;
    std::ranges::copy_if(path, std::back_inserter(whole),
                         [&](const Waypoint& p) { return agent.approach.empty() || p.t > agent.ready_at; });
    return whole;
}

SafeIntervalOptions Fleet::options_for(std::uint32_t i) const {
    SafeIntervalOptions options = driving(ground_, vehicles_[i]);
    options.stays = rules_.at_goal == AtGoal::stay;
    return options;
}

bool Fleet::plan(std::uint32_t i, double arrive_before) {
    const Agent& agent = vehicles_[i].agent;
    SafeIntervalOptions options = options_for(i);
    options.arrive_before = arrive_before;
    options.limits = interrupts_.limits();
    traffic_.remove(i);
    SafeIntervalResult found = searcher_.find(ground_.map, traffic_, agent.start, agent.goal, options);
    if (found.status != SearchStatus::found) {
        stand_at_start(i);
        return false;
    }
    put(i, found.path);
    return true;
}

void Fleet::withdraw(std::uint32_t i) {
    paths_[i].clear();
    traffic_.remove(i);
    stand_at_start(i);
}

void Fleet::put(std::uint32_t i, const Path& path) {
    paths_[i] = after_approach(vehicles_[i].agent, path);
    traffic_.remove(i);
    traffic_.add(i, paths_[i], vehicles_[i].agent.body.reach(), rules_.at_goal == AtGoal::stay);
}

void Fleet::skip_standstill() {
    if (ground_.rubble > 0) return;  // for which somebody may stand
    // Time from which all may leave, and all is open.
    double settled = 0;
    for (const Vehicle& vehicle : vehicles_) settled = std::max(settled, vehicle.agent.ready_at);
    for (const TimedOpening& opening : ground_.openings) settled = std::max(settled, opening.at);
    std::vector<Times> skipped;
    for (const Times& move : moves_of(paths_)) {
        const double rounding = 1e-9 * std::max(move.from, 1.0);
        if (move.from > settled + rounding) skipped.push_back({settled, move.from});
        settled = std::max(settled, move.to);
    }
    if (skipped.empty()) return;
    for (std::uint32_t i = 0; i < size(); ++i) {
        Path path = paths_[i];
        double before = 0;  // rounding must not turn time back
        for (Waypoint& point : path) {
            double saved = 0;
            for (const Times& times : skipped) saved += std::clamp(point.t, times.from, times.to) - times.from;
            before = point.t = std::max(before, point.t - saved);
        }
        put(i, path);
    }
}

std::vector<std::uint32_t> Fleet::in_its_way(std::uint32_t i) const {
    const SafeIntervalOptions options = options_for(i);
    const Path path = safe_interval::driven(ground_.map, options.known, options);
    std::vector<std::uint32_t> met = safe_interval::index_of(traffic_).met(path, options.body.reach(), options.stays);
    std::erase(met, i);
    return met;
}

}  // namespace waybreaker::team
