// Every plan of a small coalition: every set of obstacles, every way to share them out among the aircraft, every order
// and every cell to breach from; vehicles taken as not in each other's way.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "model/timeline.hpp"
#include "plain_map.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker {

inline constexpr double never = std::numeric_limits<double>::infinity();

// Straight moves between free cells with a set removed, and for each obstacle when it is first touched on the move.
class Moves {
  public:
    Moves(const Map& map, const Agent& agent, const std::vector<ObstacleId>& set) : agent_(agent) {
        const OpenedMap opened(map, set);
        for (const Cell c : plain(map, set).free_cells()) cells_.push_back(c);
        for (std::size_t a = 0; a < cells_.size(); ++a) {
            for (std::size_t b = 0; b < cells_.size(); ++b) {
                if (a == b || !line_of_sight(opened, cells_[a], cells_[b], agent.body)) continue;
                Move move{a, b, distance(cells_[a], cells_[b]) / agent.speed, {}};
                const std::vector<Waypoint> path{{double(cells_[a].x), double(cells_[a].y), 0},
                                                 {double(cells_[b].x), double(cells_[b].y), move.lasts}};
                for (const ObstacleId id : set) {
                    move.touched.push_back(first_touch(map, id, path, agent.body.radius).value_or(never));
                }
                moves_.push_back(std::move(move));
            }
        }
    }

    const Agent& agent() const { return agent_; }

    // The earliest arrival, by relaxing every move again and again.
    double arrival(const std::vector<double>& openings) const {
        std::vector<double> reached(cells_.size(), never);
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            if (cells_[i] == agent_.start) reached[i] = agent_.ready_at;
        }
        for (bool changed = true; changed;) {
            changed = false;
            for (const Move& move : moves_) {
                double leaves = reached[move.from];
                for (std::size_t j = 0; j < openings.size(); ++j) {
                    leaves = std::max(leaves, openings[j] - move.touched[j]);
                }
                if (leaves + move.lasts >= reached[move.to]) continue;
                reached[move.to] = leaves + move.lasts;
                changed = true;
            }
        }
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            if (cells_[i] == agent_.goal) return reached[i];
        }
        return never;
    }

  private:
    struct Move {
        std::size_t from;
        std::size_t to;
        double lasts;
        std::vector<double> touched;
    };
    const Agent& agent_;
    std::vector<Cell> cells_;
    std::vector<Move> moves_;
};

class EveryPlan {
  public:
    EveryPlan(const Map& map, const Mission& mission) : map_(map), mission_(mission) {
        for (const Agent& agent : mission.agents) {
            (agent.kind == AgentKind::ground ? vehicles_ : aircraft_).push_back(&agent);
        }
    }

    double best() {
        choose(0, {});
        return best_;
    }

    static constexpr int most_landings = 3;  // of each aircraft

  private:
    std::vector<TimedOpening>::const_iterator opens(ObstacleId id) const {
        return std::ranges::find(mission_.rules.opened, id, &TimedOpening::obstacle);
    }

    void choose(std::size_t next, std::vector<ObstacleId> set) {
        if (next == map_.obstacles().size()) {
            try_set(set);
            return;
        }
        choose(next + 1, set);
        if (!map_.obstacles()[next].destructible || opens(map_.obstacles()[next].id) != mission_.rules.opened.end() ||
            set.size() == std::size_t(mission_.rules.removals))
            return;
        set.push_back(map_.obstacles()[next].id);
        choose(next + 1, std::move(set));
    }

    void try_set(const std::vector<ObstacleId>& set) {
        set_ = set;
        std::vector<double> openings(set.size(), never);
        for (const TimedOpening& opening : mission_.rules.opened) {
            set_.push_back(opening.obstacle);
            openings.push_back(opening.at);
        }
        moves_.clear();
        for (const Agent* agent : vehicles_) moves_.emplace_back(map_, *agent, set_);
        times_.clear();
        places_.clear();
        for (const Agent* agent : aircraft_) {
            times_.push_back(agent->ready_at);
            places_.push_back(agent->from.value_or(Point(agent->start)));
        }
        used_.assign(aircraft_.size(), 0);
        landed_.assign(aircraft_.size(), 0);
        off_ = times_;
        share_out(openings, 0);
    }

    // The next breach of any aircraft from `first` on: those before it are done.
    void share_out(const std::vector<double>& openings, std::size_t first) {
        if (std::ranges::count(openings, never) == 0) judge(openings);
        for (std::size_t a = first; a < aircraft_.size(); ++a) {
            if (used_[a] == aircraft_[a]->breaches) continue;
            for (std::size_t j = 0; j < set_.size(); ++j) {
                const double stay = lasting(*aircraft_[a], map_.obstacle(set_[j]));
                if (openings[j] != never || stay == never) continue;
                for (const Cell c : map_.boundary(set_[j])) {
                    const double time = times_[a];
                    const Point place = places_[a];
                    times_[a] += distance(place, c) / aircraft_[a]->speed + stay;
                    places_[a] = c;
                    ++used_[a];
                    std::vector<double> more = openings;
                    more[j] = times_[a];
                    if (!is_too_long(*aircraft_[a], times_[a] - off_[a])) share_out(more, a);
                    --used_[a];
                    times_[a] = time;
                    places_[a] = place;
                }
            }
            land(openings, a);
        }
    }

    // How long it breaches that, or never.
    double lasting(const Agent& agent, const Obstacle& obstacle) const {
        const BreachTime& by_rules = mission_.rules.breach_time;
        const double of_cells = agent.breach_time_per_cell.value_or(by_rules.per_cell) * obstacle.cells;
        const double lasts = obstacle.breach_time + agent.breach_time.value_or(by_rules.per_obstacle) + of_cells;
        if (!agent.can_breach) return lasts;
        const auto& [most_cells, only] = *agent.can_breach;
        const bool may = obstacle.cells <= most_cells && (!only || std::ranges::count(*only, obstacle.id) > 0);
        return may ? lasts : never;
    }

    // At any base, a few times.
    void land(const std::vector<double>& openings, std::size_t a) {
        const Agent& aircraft = *aircraft_[a];
        if (!aircraft.recharge || landed_[a] == most_landings) return;
        const double time = times_[a];
        const double off = off_[a];
        const Point place = places_[a];
        for (const Cell base : aircraft.bases) {
            const double lands = time + distance(place, base) / aircraft.speed;
            if (lands == off || is_too_long(aircraft, lands - off)) continue;
            ++landed_[a];
            times_[a] = off_[a] = lands + *aircraft.recharge;
            places_[a] = base;
            share_out(openings, a);
            --landed_[a];
            times_[a] = time;
            off_[a] = off;
            places_[a] = place;
        }
    }

    // A flight that takes so long, of an aircraft that never waits.
    static bool is_too_long(const Agent& aircraft, double lasts) {
        const double kept = (1 - aircraft.reserve) * (1 + 1e-9);
        return lasts * aircraft.speed > kept * aircraft.range || lasts > kept * aircraft.endurance;
    }

    void judge(const std::vector<double>& openings) {
        double sum = 0;
        double last = 0;
        for (std::size_t a = 0; a < aircraft_.size(); ++a) {
            const double home = times_[a] + distance(places_[a], aircraft_[a]->goal) / aircraft_[a]->speed;
            if (is_too_long(*aircraft_[a], home - off_[a])) return;
            sum += aircraft_[a]->weight * home;
            last = std::max(last, home);
        }
        const Objective objective = mission_.rules.objective;
        if (objective == Objective::ground_makespan) sum = last = 0;
        for (const Moves& moves : moves_) {
            if ((objective == Objective::flowtime ? sum : last) >= best_) return;
            const double arrival = std::min(moves.arrival(openings), mission_.rules.unreached.value_or(never));
            if (arrival == never) return;
            sum += moves.agent().weight * arrival;
            last = std::max(last, arrival);
        }
        best_ = std::min(best_, objective == Objective::flowtime ? sum : last);
    }

    const Map& map_;
    const Mission& mission_;
    std::vector<const Agent*> vehicles_;
    std::vector<const Agent*> aircraft_;
    std::vector<ObstacleId> set_;
    std::vector<Moves> moves_;
    std::vector<double> times_;  // by aircraft
    std::vector<Point> places_;
    std::vector<int> used_;
    std::vector<double> off_;  // when it took off last
    std::vector<int> landed_;
    double best_ = never;
};

}  // namespace waybreaker
