// Outline: the boundary of an obstacle, followed from corner to corner.
#pragma once

#include "crossing/geometry/lattice.hpp"
#include "crossing/geometry/regions.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::crossing {

// A side of a cell of the obstacle on its boundary, and the direction in which it is followed.
struct Side {
    Cell cell;
    Step outward;
    Step along;
    friend constexpr bool operator==(const Side&, const Side&) = default;
};

class Outline {
  public:
    // `reach`: reach_of the body.
    Outline(const Map& map, int reach, RegionId region) : map_(&map), region_(region), reach_(reach) {}

    // Looks at bits first: they are few enough to stay in the cache.
    bool owns(Cell c) const {
        return map_->grid().blocked(c) && map_->grid().contains(c) && region_at(*map_, c) == region_;
    }

    // The turn at the end of a side. For a square, cells that touch at a corner leave no gap.
    enum class Turn { away, straight, back };  // `away`: a convex corner; `back`: a concave one
    Turn turn(const Side& side) const {
        const bool ahead = owns_beside(side.cell + side.along);
        if (!ahead && reach_ == 1) return Turn::away;
        const bool beside =
            ahead ? owns_beside(side.cell + side.along + side.outward) : owns(side.cell + side.along + side.outward);
        if (beside && (ahead || reach_ == 2)) return Turn::back;
        return ahead ? Turn::straight : Turn::away;
    }

    // Where the boundary of the grown obstacle bends (or goes on, if straight) at the end of a side.
    Vertex bend(const Side& side, Turn turn) const {
        const int ahead = turn == Turn::back ? 2 - reach_ : reach_;
        return {2 * side.cell.x + reach_ * side.outward.x + ahead * side.along.x,
                2 * side.cell.y + reach_ * side.outward.y + ahead * side.along.y};
    }

    static Side next(const Side& side, Turn turn) {
        switch (turn) {
            case Turn::back:
                return {side.cell + side.along + side.outward, -side.along, side.outward};
            case Turn::straight:
                return {side.cell + side.along, side.outward, side.along};
            case Turn::away:
                break;
        }
        return {side.cell, side.along, -side.outward};
    }

  private:
    // The same for a cell beside one of the obstacle's.
    bool owns_beside(Cell c) const {
        return map_->grid().blocked(c) && map_->grid().contains(c) &&
               (!map_->obstacles_touch() || region_at(*map_, c) == region_);
    }

    const Map* map_;
    RegionId region_;
    int reach_;
};

}  // namespace waybreaker::crossing
