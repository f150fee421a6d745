// Fan: where taut paths can go on to, straight, from a vertex: the corners they can bend at next, and the goal.
//
// Only obstacles in the way are looked at. Rays go to the goal and along the borders of the sector of taut directions;
// what a ray hits is followed along its outline to the corners it can be passed at, and those are the next rays' aims.
// Why no corner of a shortest path is missed: docs/exact.md.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/interrupt.hpp"
#include "crossing/geometry/bends.hpp"
#include "crossing/geometry/convex.hpp"
#include "crossing/geometry/ellipse.hpp"
#include "crossing/geometry/outline.hpp"
#include "crossing/geometry/ray.hpp"
#include "crossing/geometry/visited.hpp"

namespace waybreaker::crossing {

// A corner of a region: the quadrant of its vertex that the region fills, and the region.
struct Corner {
    Step quadrant;
    Cell cell;
    RegionId region;
};

// A region that a ray has met, and the side of the cell through which it enters.
struct Front {
    RegionId region;
    Cell cell;
    Step side;
};

// A region that a ray enters, in order, as far as it may.
struct Entered {
    RegionId region;
    double at = 0;       // half cells from the viewpoint
    bool surely = true;  // false: that or another one
    bool first = false;  // of its ray
};

// A vertex to look from, and how a path has come there.
struct Viewpoint {
    Vertex at;
    std::optional<Step> arriving;                 // none: the start, where every direction is taut
    std::optional<std::span<const Front>> ahead;  // regions met straight on, if they are known
    std::span<const ObstacleId> open;             // obstacles that cost nothing any more
    int crossings = 0;                            // how many more may be crossed, and of which weight
    double weight = 0;
    double range = 0;  // longest path from here to the goal, half cells
};

// A vertex in reach, and the further obstacles crossed on the way.
struct Reached {
    Vertex at;
    std::vector<ObstacleId> crossed;
    std::uint32_t fronts_begin = 0;  // regions met straight on from there; 0, 0: not known
    std::uint32_t fronts_end = 0;
};

class Fan {
  public:
    // Keeps what it is given for as long as the query lasts. `pinched`: as of Ray; then the goal is no corner.
    // `convex`: none if it matters which obstacles were crossed even where they are left.
    void start_query(const Regions& regions, Vertex goal, const CrossingOptions& options, bool pinched, Convex* convex,
                     Interrupt& interrupt);

    // All corners and the goal that a shortest path can go to next; some of them if it is interrupted. `alternatives`:
    // also when the goal itself is in reach. What is returned lives until the next call.
    std::span<const Reached> look(const Viewpoint& from, bool alternatives);
    // Regions that the rays of the last look entered, one ray after the other; if obstacles open in time.
    std::span<const Entered> entered() const { return entered_; }
    // Regions that the last look met straight on from a vertex it reached, if they are known.
    std::optional<std::span<const Front>> ahead(const Reached& reached) const;

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
    struct Sum {
        std::size_t count = 0;
        double weight = 0;
    };
    // A corner to look at, and on which side of it one sees past it.
    struct Aim {
        Vertex at;
        int open;
    };

    void begin_look();
    bool look_at_goal();
    void look_into(const Sector& sector);
    void look_along(Step direction, int into);
    void look_at(const Aim& aim);
    bool cast(Step direction, int times);
    void note_entered(double length);
    int times_in_range(Step direction) const;
    void scan_from(Front front, Step direction, int only);
    void keep_ahead(double share);
    bool scan(const Outline& outline, const Side& side, int turn);
    std::optional<std::uint32_t> behind_notch(const Outline& outline, std::uint32_t corner, int turn);
    bool clear(Vertex a, Vertex b) const;
    void note(Vertex corner, int open);
    std::optional<Corner> corner_at(Vertex v, Step quadrant) const;
    bool bends(Vertex v, std::span<const ObstacleId> crossed) const;
    bool affords(std::span<const ObstacleId> obstacles) const;
    Sum sum_of(std::span<const ObstacleId> obstacles) const;
    void reach(Vertex v, double share);
    void choose(Vertex v, std::size_t next, std::size_t rest, std::vector<ObstacleId>& crossed);
    bool is_beaten(std::size_t next, std::span<const ObstacleId> crossed);
    bool left(RegionId region, Vertex v) const;

    const Regions* regions_ = nullptr;
    Convex* convex_ = nullptr;
    const Map* map_ = nullptr;  // of the regions
    Interrupt* interrupt_ = nullptr;
    int reach_ = 2;  // half cells
    Vertex goal_;
    Ray ray_;
    std::array<Bends, 2> bends_of_;  // by reach: of a point, of a square
    Bends* bends_ = nullptr;
    Visited visited_;
    std::uint64_t look_ = 0;  // numbers the sectors looked into
    Viewpoint from_;
    Ellipse ellipse_{{}, {}, 0};
    Sector sector_;
    std::vector<Aim> aims_;
    std::vector<Reached> reached_;
    std::vector<Squeeze> choices_;  // on the way to a corner
    std::vector<Sum> least_;        // of the choices made there
    std::vector<ObstacleId> members_;
    bool notes_entered_ = false;
    std::vector<Entered> entered_;
    std::vector<Hit> in_order_;
    std::vector<ObstacleId> passed_;
    std::vector<Front> fronts_;  // ahead of those reached; the first is none
};

}  // namespace waybreaker::crossing
