// Airspace: how an aircraft flies round zones, the shortest way.
//
//     const Airspace air(mission.rules.zones, map.width(), map.height());
//     air.length({0, 0}, {80, 20});    // cells; straight where no zone is in between
//     air.way({0, 0}, {80, 20});       // where it bends
//
// A flight may touch the outline of a zone and go along it; its interior is closed. Zones that touch are closed where
// they meet: there is no way between two that share a side. A shortest way bends only at corners where the zone's
// interior angle is below 180 degrees, and each piece of it touches the zones at its ends like a tangent (Lozano-Pérez
// and Wesley 1979). All decisions are made in integers, on a lattice of zone_steps to a cell: exact for cell centres
// and for the zones' rounded corners.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "waybreaker/cell.hpp"
#include "waybreaker/zone.hpp"

namespace waybreaker {

class Airspace {
  public:
    // Nothing is closed.
    Airspace() = default;
    // Those of the zones that are `no_fly` are closed, whomever they hold for. Ways bend on the map only.
    // REQUIRES: valid zones. Time O(corners^2) and more where many see each other.
    Airspace(std::span<const Zone> zones, int width, int height);

    // Whether no zone closes any of it.
    bool is_open() const { return parts_ == nullptr; }

    // Whether somebody may be there: not in the interior of a zone.
    [[nodiscard]] bool allows(Point at) const;
    // Whether the straight flight meets no interior.
    [[nodiscard]] bool is_clear(Point a, Point b) const { return is_open() || is_clear_of_zones(a, b); }

    // Whether a box of cells, their areas included, has a place in common with the box round all zones.
    [[nodiscard]] bool comes_near(Cell least, Cell most) const;

    // Of the shortest way, in cells; infinity where there is none. The same in both directions. REQUIRES: points on the
    // map.
    [[nodiscard]] double length(Point a, Point b) const {
        return is_open() || is_clear_of_zones(a, b) ? distance(a, b) : bent_length(a, b);
    }
    // That way: both ends, and between them where it bends; empty where there is none.
    [[nodiscard]] std::vector<Point> way(Point a, Point b) const;
    // The same from the first of some points to the last, by way of all of them in their order. REQUIRES: there is one.
    [[nodiscard]] std::vector<Point> way_past(std::span<const Point> stops) const;

  private:
    class Parts;

    bool is_clear_of_zones(Point a, Point b) const;
    double bent_length(Point a, Point b) const;

    std::shared_ptr<const Parts> parts_;  // null: no zone
};

}  // namespace waybreaker
