// All plans of a small mission of one ground agent, and of obstacles that open by themselves: every set of obstacles,
// every way to share it among the aircraft, every order of a flight, every boundary cell, and the earliest arrival of
// the ground agent among the centres of all cells, waits included.
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "model/timeline.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker {

class AllPlans {
  public:
    // How far an aircraft flies from one point to another; infinitely where it cannot.
    using Flown = std::function<double(Point, Point)>;

    AllPlans(
        const Map& map, const Mission& mission, Flown flown = [](Point a, Point b) { return distance(a, b); })
        : map_(map), rules_(mission.rules), driver_(mission.first(AgentKind::ground)), flown_(std::move(flown)) {
        for (const Agent& agent : mission.agents) {
            if (agent.kind == AgentKind::air) aircraft_.push_back(&agent);
        }
        for (Cell c; c.y < map.height(); ++c.y) {
            for (c.x = 0; c.x < map.width(); ++c.x) cells_.push_back(c);
        }
        for (const Cell a : cells_) {
            for (const Cell b : cells_) moves_.push_back(move(a, b));
        }
        for (const Obstacle& o : map.obstacles()) {
            const bool opens = std::ranges::find(rules_.opened, o.id, &TimedOpening::obstacle) != rules_.opened.end();
            const bool stays = std::ranges::find(rules_.protect, o.id) != rules_.protect.end();
            if (o.destructible && !opens && !stays) destructible_.push_back(o.id);
        }
        choose(0);
    }

    // The least objective there is; infinity if there is no plan.
    double best() const { return best_; }

  private:
    static constexpr double none = std::numeric_limits<double>::infinity();

    // A straight move, and how far along it each obstacle is touched first.
    struct Move {
        double length;
        std::vector<std::pair<ObstacleId, double>> touched;
    };

    Move move(Cell a, Cell b) const {
        const Point from(a);
        const Point to(b);
        Move move{distance(from, to), {}};
        const std::vector<Waypoint> path{{from.x, from.y, 0}, {to.x, to.y, move.length}};
        for (const Obstacle& o : map_.obstacles()) {
            if (const auto at = first_touch(map_, o.id, path, driver_.body.reach()))
                move.touched.emplace_back(o.id, *at);
        }
        return move;
    }

    void choose(std::size_t next) {
        if (weight() > rules_.budget) return;
        const auto chosen = [&](ObstacleId id) { return std::ranges::find(chosen_, id) != chosen_.end(); };
        if (std::ranges::all_of(rules_.force, chosen)) {
            std::vector<bool> visited(chosen_.size(), false);
            cleared_.assign(chosen_.size(), 0);
            take_off({}, visited);
        }
        if (int(chosen_.size()) == rules_.removals) return;
        for (std::size_t i = next; i < destructible_.size(); ++i) {
            chosen_.push_back(destructible_[i]);
            choose(i + 1);
            chosen_.pop_back();
        }
    }

    double weight() const {
        double weight = 0;
        for (const ObstacleId id : chosen_) weight += map_.obstacle(id).weight;
        return weight;
    }

    // One aircraft in the air, those before it at home.
    struct Flight {
        std::size_t aircraft = 0;
        Point at = {};
        double time = 0;
        int breached = 0;
        double last = 0;  // of those at home, and the sum
        double sum = 0;
    };

    void take_off(Flight flight, std::vector<bool>& visited) {
        const Agent& agent = *aircraft_[flight.aircraft];
        flight.at = agent.from.value_or(Point(agent.start));
        flight.time = agent.ready_at;
        fly(flight, visited);
    }

    void fly(const Flight& flight, std::vector<bool>& visited) {
        const Agent& agent = *aircraft_[flight.aircraft];
        land(flight, visited);
        if (flight.breached == agent.breaches) return;
        for (std::size_t i = 0; i < chosen_.size(); ++i) {
            if (visited[i]) continue;
            visited[i] = true;
            for (const Cell c : map_.boundary(chosen_[i])) {
                const double there = flight.time + flown_(flight.at, c) / agent.speed;
                cleared_[i] = there + rules_.breach_time.of(map_.obstacle(chosen_[i]));
                fly({flight.aircraft, c, cleared_[i], flight.breached + 1, flight.last, flight.sum}, visited);
            }
            visited[i] = false;
        }
    }

    // The next one takes off, or all are at home.
    void land(const Flight& flight, std::vector<bool>& visited) {
        const Agent& agent = *aircraft_[flight.aircraft];
        const double home = flight.time + flown_(flight.at, agent.goal) / agent.speed;
        const double last = std::max(flight.last, home);
        const double sum = flight.sum + home;
        const std::size_t next = flight.aircraft + 1;
        if (next < aircraft_.size()) return take_off({.aircraft = next, .last = last, .sum = sum}, visited);
        if (std::ranges::count(visited, false) > 0 || objective(0, last, sum) >= best_) return;
        best_ = std::min(best_, objective(earliest_arrival(), last, sum));
    }

    double objective(double ground, double last, double sum) const {
        if (rules_.objective == Objective::makespan) return std::max(ground, last);
        return rules_.objective == Objective::flowtime ? ground + sum : ground;
    }

    // When a move ends that begins at t, waits before it included; infinity if it is not possible.
    double end_of(const Move& move, double t) const {
        double start = t;
        for (const auto& [obstacle, at] : move.touched) {
            const auto found = std::ranges::find(chosen_, obstacle);
            const auto opens = std::ranges::find(rules_.opened, obstacle, &TimedOpening::obstacle);
            if (found == chosen_.end() && opens == rules_.opened.end()) return none;
            const double open = found != chosen_.end() ? cleared_[std::size_t(found - chosen_.begin())] : opens->at;
            start = std::max(start, open - at / driver_.speed);
        }
        return start + move.length / driver_.speed;
    }

    double earliest_arrival() const {
        std::vector<double> at(cells_.size(), none);
        std::vector<bool> done(cells_.size(), false);
        at[index(driver_.start)] = driver_.ready_at;
        while (true) {
            std::size_t next = cells_.size();
            for (std::size_t i = 0; i < cells_.size(); ++i) {
                if (!done[i] && at[i] < none && (next == cells_.size() || at[i] < at[next])) next = i;
            }
            if (next == cells_.size()) return none;
            if (cells_[next] == driver_.goal) return at[next];
            done[next] = true;
            for (std::size_t i = 0; i < cells_.size(); ++i) {
                if (!done[i]) at[i] = std::min(at[i], end_of(moves_[next * cells_.size() + i], at[next]));
            }
        }
    }

    std::size_t index(Cell c) const { return std::size_t(c.y) * std::size_t(map_.width()) + std::size_t(c.x); }

    const Map& map_;
    const Rules& rules_;
    const Agent& driver_;
    Flown flown_;
    std::vector<const Agent*> aircraft_;
    std::vector<Cell> cells_;
    std::vector<Move> moves_;
    std::vector<ObstacleId> destructible_;
    std::vector<ObstacleId> chosen_;
    std::vector<double> cleared_;
    double best_ = none;
};

}  // namespace waybreaker
