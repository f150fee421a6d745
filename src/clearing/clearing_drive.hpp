// The drive of a vehicle that breaches obstacles, for itself or for others: from one to the next, then on to its goal.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "drive/opening.hpp"
#include "waybreaker/method.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::clearing {

// Where a vehicle stands: where it gets to soonest, or where it loses the least on its way to what comes next.
enum class Place { soonest, onward };

struct Stop {
    ObstacleId obstacle;
    Place place = Place::onward;
    friend auto operator<=>(const Stop&, const Stop&) = default;
};

// What one vehicle breaches, in its order.
using Tour = std::vector<Stop>;

struct Cleared {
    ObstacleId obstacle;
    Cell at;              // where the vehicle stands
    double begun_at = 0;  // units of time
    double cleared_at = 0;
};

struct ClearingDrive {
    std::vector<Waypoint> path;  // from the vehicle's beginning until its last breach is over
    std::vector<Cleared> breaches;
};

// The vehicle as others see it that breaches no more: on that drive, then on its way to its goal.
Agent under_way(const Agent& vehicle, const ClearingDrive& clearing);

class ClearingDrives {
  public:
    // All must outlive it.
    ClearingDrives(const Map& map, const Rules& rules, const Method& method, const Deadline& deadline,
                   const Searchers& searchers)
        : map_(map), rules_(rules), method_(method), deadline_(deadline), searchers_(searchers) {}

    // To each obstacle of the tour by the shortest way past what is open when it sets out: what it has breached, and
    // `opened`. Empty where it gets to one by no way.
    std::optional<ClearingDrive> drive(const Agent& vehicle, const Tour& tour, std::span<const TimedOpening> opened);

  private:
    struct Leg {
        Cell to;
        std::vector<Point> path;  // none: there is no way
    };
    const Leg& leg(const Agent& vehicle, Cell from, ObstacleId obstacle, std::optional<Point> next,
                   std::vector<ObstacleId> open);

    const Map& map_;
    const Rules& rules_;
    const Method& method_;
    const Deadline& deadline_;
    Searchers searchers_;
    using Key = std::tuple<double, Corners, double, Cell, ObstacleId, std::optional<std::pair<double, double>>,
                           std::vector<ObstacleId>>;
    std::map<Key, Leg> legs_;
};

}  // namespace waybreaker::clearing
