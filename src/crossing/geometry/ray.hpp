// Ray: which regions a straight move meets, in integers, a word of cells at a time.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "crossing/geometry/lattice.hpp"
#include "crossing/geometry/regions.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::crossing {

// Where a ray first enters a region: through which side of which of its cells.
struct Hit {
    RegionId region;
    Cell cell;
    Step side;           // from the cell outwards
    int row = 0;         // of the cell, across the ray
    double at = 0;       // share of the ray
    bool surely = true;  // false: only as one of a Squeeze
};

// In the order of the ray.
inline bool comes_first(const Hit& a, const Hit& b) {
    return a.at != b.at ? a.at < b.at : a.region < b.region;
}

// Two different regions on both sides of an edge that a point slides along, or of a corner that it passes: one of them
// must go.
struct Squeeze {
    RegionId one;
    RegionId other;
    double at = 0;  // share of the ray
};

class Ray {
  public:
    // Keeps the regions for as long as the query lasts. `pinched`: cells that touch at a corner leave no room.
    void start_query(const Regions& regions, const CrossingOptions& options, bool pinched);

    // Obstacles that the next rays pass as if they were gone.
    void set_open(std::span<const ObstacleId> obstacles);

    // Until the next query: rays pass all that can be removed as if it were gone.
    void pass_destructible();

    // Casts a ray that passes at most so many further obstacles, of at most that weight together. False when it was
    // stopped: by a region that cannot be passed any more, or by the edge of the map. What it met before is in
    // hits(). Squeezes count as the cheaper of their regions, so a ray can get farther than a path does.
    bool cast(Vertex from, Vertex to, int crossings, double weight);
    // Whether it got to that share of its length.
    bool reaches(double share) const { return !stopped_ || stopped_at_ >= share; }

    // Whether a segment passes between two standing cells that touch at a corner, its ends not counted.
    bool pinched(Vertex from, Vertex to) const;

    // The regions that the ray met, each once; when stopped also those that stop it. Their order means nothing.
    std::span<const Hit> hits() const { return hits_; }
    std::span<const Squeeze> squeezes() const { return squeezes_; }

    bool met(RegionId region) const { return region_marks_[region.value].ray == ray_; }
    // Whether all its obstacles are open.
    bool open(RegionId region) const {
        return region_marks_[region.value].open == opening_ || (passes_destructible_ && !solid(region));
    }
    // Never passed.
    bool solid(RegionId region) const;
    // Never removed, unless it is open.
    bool stays(ObstacleId obstacle) const {
        const ObstacleMark& mark = obstacle_marks_[obstacle.value];
        return !regions_->destructible(obstacle) || mark.protect == query_ || (allows_some_ && mark.allow != query_);
    }
    // Share of an obstacle in what may be crossed: its weight where a budget limits that, else its price, in half
    // cells.
    double weight(ObstacleId obstacle) const {
        if (weighs_) return regions_->weight(obstacle);
        return prices_.empty() || regions_->is_edge(obstacle) ? 0 : 2 * prices_[obstacle.value];
    }
    // Whether weights are prices.
    bool prices() const { return !prices_.empty(); }
    // Whether nothing of a region stands that is not in the list.
    bool opens(RegionId region, std::span<const ObstacleId> obstacles) const {
        bool all = true;
        regions_->for_each_member(region, [&](ObstacleId obstacle) {
            const bool open = obstacle_marks_[obstacle.value].open == opening_;
            all = all && (open || std::ranges::find(obstacles, obstacle) != obstacles.end());
        });
        return all;
    }
    // Adds the obstacles that must be crossed for a region: those that are neither open nor in the list.
    void add_missing(RegionId region, std::vector<ObstacleId>& obstacles) const {
        regions_->for_each_member(region, [&](ObstacleId obstacle) {
            if (obstacle_marks_[obstacle.value].open == opening_) return;
            if (std::ranges::find(obstacles, obstacle) == obstacles.end()) obstacles.push_back(obstacle);
        });
    }

  private:
    struct RegionMark {
        std::uint32_t open = 0;  // the set_open() that opened it
        std::uint32_t ray = 0;   // the ray that met it
        std::uint32_t hit = 0;   // its index in hits_, if so
    };
    struct ObstacleMark {
        std::uint32_t open = 0;     // the set_open() that named it
        std::uint32_t ray = 0;      // the ray that counted it
        std::uint32_t protect = 0;  // the query that protects it
        std::uint32_t allow = 0;    // the query that allows it alone, with others
    };
    // Cost of passing a region.
    struct Price {
        int crossings = 0;
        double weight = 0;
    };
    struct Free {
        void operator()(void* memory) const;
    };
    // A segment with x along its longer axis.
    struct Frame {
        const Grid* grid;
        bool steep;
        int x, y, dx, dy;
    };

    void walk_line(const Frame& frame);
    void walk_edge(const Frame& frame);
    void visit_run(const Frame& frame, int row, std::int64_t first, std::int64_t last);
    void visit_rightwards(const Frame& frame, int row, std::size_t from, std::size_t to);
    void visit_leftwards(const Frame& frame, int row, std::size_t from, std::size_t to);
    void visit_cell(const Frame& frame, int x, int row);
    void visit_pair(const Frame& frame, int x, int upper);
    void pass_corners(Vertex from, Step step, Price left);
    void visit_corner(Vertex corner, Step step, double at);
    bool look_beside(Vertex corner, Step cell, Step side, Hit& hit) const;
    void pinch(const Hit& one, const Hit& other);
    void count_pinch(const Hit& one, const Hit& other);
    void count_hits(double before);
    void count(RegionId region);
    void meet(const Hit& hit);
    Price price(RegionId region) const;
    void pay(RegionId region);
    void meet_beside(const Hit& hit, bool begins);
    void stop(double at);
    static bool outside(const Frame& frame, int x, int row);
    RegionId region_of(const Frame& frame, int x, int row) const;
    Hit entry(const Frame& frame, int x, int row) const;
    Hit edge_entry(const Frame& frame, int x, int row, int across) const;

    const Regions* regions_ = nullptr;
    const Map* map_ = nullptr;  // of the regions
    int reach_ = 2;
    bool touching_ = false;
    bool pinched_ = false;      // between cells that touch at a corner
    bool allows_some_ = false;  // and no others
    bool passes_destructible_ = false;
    const Grid* rows_ = nullptr;  // what rays look for
    const Grid* columns_ = nullptr;
    bool weighs_ = false;             // whether the budget is limited
    std::span<const double> prices_;  // by id; empty: nothing is paid, or the budget is limited
    std::unique_ptr<RegionMark[], Free> region_marks_;
    std::unique_ptr<ObstacleMark[], Free> obstacle_marks_;
    std::size_t region_limit_ = 0;
    std::size_t obstacle_limit_ = 0;
    std::uint32_t query_ = 0;
    std::uint32_t opening_ = 0;
    std::uint32_t ray_ = 0;

    std::vector<Hit> hits_;
    std::vector<Squeeze> squeezes_;
    int crossings_left_ = 0;
    double weight_left_ = 0;
    bool stopped_ = false;
    double stopped_at_ = 0;  // the share at which it was stopped
    // Left at a pinch, at most, after what is passed before it.
    Price left_at_pinch_;
    std::vector<ObstacleId> counted_;
    std::vector<Hit> to_count_;  // met for certain, the nearest last
};

}  // namespace waybreaker::crossing
