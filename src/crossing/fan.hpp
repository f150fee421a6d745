// Fan: where taut paths can go on to, straight, from a vertex: the corners they can bend at next, and the goal.
//
// Only what stands in the way is looked at. Rays go to the goal and along the borders of the sector of taut directions;
// what a ray hits is followed along its outline to the corners it can be passed at, and those are the next rays' aims.
// Why no corner of a shortest path is missed: docs/exact.md.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "crossing/done.hpp"
#include "crossing/ellipse.hpp"
#include "crossing/outline.hpp"
#include "crossing/ray.hpp"

namespace waybreaker {

// A corner of an obstacle: the quadrant of its vertex that the obstacle fills, and the obstacle.
struct Corner {
    Step quadrant;
    Cell cell;
    std::uint32_t obstacle = 0;
};

// A way to be somewhere.
struct Viewpoint {
    Vertex at;
    std::optional<Step> arriving;         // none: the start, where every direction is taut
    std::span<const std::uint32_t> open;  // obstacles that cost nothing any more
    int crossings = 0;                    // how many more may be crossed, and of which weight
    double weight = 0;
    double range = 0;  // longest path from here to the goal, half cells
};

// A vertex in reach, and the further obstacles crossed on the way.
struct Reached {
    Vertex at;
    std::vector<std::uint32_t> crossed;
};

class Fan {
  public:
    void start_query(const Map& map, Body body, Vertex goal, std::span<const ObstacleId> protect,
                     std::span<const double> weights);

    // All corners and the goal that a shortest path can go to next. `alternatives`: also when the goal itself is in
    // reach. What is returned lives until the next call.
    std::span<const Reached> look(const Viewpoint& from, bool alternatives);

    Ray& ray() { return ray_; }
    const Ray& ray() const { return ray_; }

  private:
    // The taut directions around one corner: from straight on to along the obstacle.
    struct Sector {
        Step straight;
        Step sliding;
        int turn = 0;  // sign of cross(straight, sliding); 0: every direction
        Corner around;
        bool holds(Step direction) const {
            return turn == 0 ||
                   (sign(cross(straight, direction)) * turn >= 0 && sign(cross(direction, sliding)) * turn >= 0);
        }
    };
    // A corner to look at, and on which side of it one sees past it.
    struct Aim {
        Vertex at;
        int open;
    };

    bool look_at_goal();
    void look_into(const Sector& sector);
    void look_along(Step direction, int into);
    void look_at(const Aim& aim);
    void walk_on(Vertex from, Step direction);
    void scan_from_hits(Step direction, int only = 0, int only_behind = 0);
    bool scan(const Outline& outline, Side side, int turn);
    std::optional<Side> behind_notch(const Outline& outline, Side side, Step corner, int turn) const;
    bool clear(Vertex a, Vertex b) const;
    bool passed(Vertex bend, const Side& side, Outline::Turn kind);
    void note(Vertex corner, int open);
    std::optional<Corner> corner_at(Vertex v, Step quadrant) const;
    bool bends(Vertex v, std::span<const std::uint32_t> crossed) const;
    void reach(Vertex v);
    void reach(Vertex v, std::size_t squeeze, std::vector<std::uint32_t>& crossed);

    const Map* map_ = nullptr;
    Body body_ = Body::square;
    Vertex goal_;
    Ray ray_;
    Done done_;
    Viewpoint from_;
    Ellipse ellipse_{{}, {}, 0};
    Sector sector_;
    std::vector<Aim> aims_;
    std::vector<Reached> reached_;
};

}  // namespace waybreaker
