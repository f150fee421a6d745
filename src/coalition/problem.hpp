// The problem of a coalition: vehicles, aircraft, and what may be removed for all of them together.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/parallel.hpp"
#include "model/objective.hpp"
#include "team/vehicle.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::coalition {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
// Relative: less of a difference is none.
inline constexpr double rounding = 1e-9;

// Obstacles, in rising order, each once.
using Set = std::vector<ObstacleId>;

Set united(const Set& a, const Set& b);
bool contains(const Set& set, ObstacleId id);

// Lower bound of an agent's arrival by way of an obstacle that opens then.
double late_arrival(const Agent& agent, const Obstacle& obstacle, double opening);

class Problem {
  public:
    // REQUIRES: the mission is a team's, and valid. All arguments must outlive it.
    Problem(const Map& map, const Mission& mission, const team::Interrupts& interrupts);

    const Map& map() const { return map_; }
    const Rules& rules() const { return mission_.rules; }
    const team::Interrupts& interrupts() const { return interrupts_; }
    std::span<const Agent* const> vehicles() const { return vehicles_; }
    std::span<const Agent* const> aircraft() const { return aircraft_; }

    // What is removed in every plan: what must be, and what opens by itself.
    const Set& forced() const { return forced_; }
    // Of those, what opens by itself; and when, where obstacles stand in time.
    const Set& opened() const { return opened_; }
    std::span<const TimedOpening> late_openings() const {
        return rules().timing == Timing::enforce ? std::span<const TimedOpening>(rules().opened)
                                                 : std::span<const TimedOpening>();
    }
    // When an obstacle opens by itself; empty for all others.
    std::optional<double> given_opening(ObstacleId id) const;
    // How many obstacles may be removed beside those, and what they may weigh.
    int spare_removals() const { return spare_removals_; }
    double spare_budget() const { return spare_budget_; }
    // Whether all of these may be removed beside those that must be.
    bool allows(std::span<const ObstacleId> set) const;
    // What the vehicle counts as if it is not at its goal by then; infinity if it must be.
    double unreached(std::size_t vehicle) const { return unreached_at(rules(), *vehicles_[vehicle]); }
    double weight(std::size_t vehicle) const { return vehicles_[vehicle]->weight; }
    // What an aircraft's time counts for at least.
    double flight_weight() const { return flight_weight_; }
    bool sums() const { return rules().objective == Objective::flowtime; }
    // The objective where all arrivals add up to that, and the last ones are these.
    double objective(double sum, double last, double last_on_ground) const {
        if (sums()) return sum;
        if (std::isinf(last)) return last;
        return rules().objective == Objective::makespan ? last : last_on_ground;
    }

    // How long that aircraft breaches it; infinity if it may not, 0 if it opens by itself.
    double breach_time(std::size_t aircraft, ObstacleId id) const {
        return given_opening(id) ? 0 : time_to_breach(*aircraft_[aircraft], map_.obstacle(id), rules());
    }
    // What a vehicle could drive while it gets through the rubble of each obstacle, by id, in cells; empty if there is
    // none.
    std::span<const double> rubble_prices(std::size_t vehicle) const { return rubble_prices_[vehicle]; }
    // No aircraft has it open earlier; 0 where obstacles do not stand in time.
    double earliest_opening(ObstacleId id) const { return earliest(id).opening; }
    // The same, a little less and faster.
    double least_opening(ObstacleId id) const { return least_openings_[id.value]; }
    // So much longer, at least, an aircraft flies that passes by it, times its weight; no more than least_detour, and
    // faster.
    double short_detour(ObstacleId id) const { return short_detours_[id.value]; }
    // No aircraft that breaches it is at its goal earlier.
    double earliest_return(ObstacleId id) const { return earliest(id).home; }
    // So much longer, at least, an aircraft flies that passes by it, times its weight.
    double least_detour(ObstacleId id) const { return earliest(id).detour; }
    // What a breach adds to the sum of arrivals, at least.
    double weighted_breach_time(ObstacleId id) const { return flight_weight_ * least_breach_times_[id.value]; }
    // When an aircraft is at its goal if it breaches nothing.
    static double straight_flight(const Agent& aircraft) {
        return aircraft.ready_at + distance(aircraft.begin(), aircraft.goal) / aircraft.speed;
    }

  private:
    struct Earliest {
        double opening = infinity;
        double home = infinity;
        double detour = infinity;
    };
    const Earliest& earliest(ObstacleId id) const;
    Earliest find_earliest(ObstacleId id) const;

    const Map& map_;
    const Mission& mission_;
    const team::Interrupts& interrupts_;
    std::vector<const Agent*> vehicles_;
    std::vector<const Agent*> aircraft_;
    double flight_weight_ = 0;
    Set forced_;
    Set opened_;
    int spare_removals_ = 0;
    double spare_budget_ = infinity;
    std::vector<std::vector<double>> rubble_prices_;  // by vehicle
    std::vector<double> least_openings_;              // by id
    std::vector<double> short_detours_;               // by id
    std::vector<double> least_breach_times_;          // by id, of all aircraft; 0 where none may
    // By id, of those that were asked for.
    mutable std::vector<Earliest> earliest_;
    mutable std::vector<Once> asked_;
};

}  // namespace waybreaker::coalition
