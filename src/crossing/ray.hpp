// Ray: which obstacles a straight move meets, in integers, a word of cells at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "crossing/lattice.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::crossing {

// Where a ray first enters an obstacle: through which side of which of its cells.
struct Hit {
    std::uint32_t obstacle = 0;
    Cell cell;
    Step side;           // from the cell outwards
    int row = 0;         // of the cell, across the ray
    double at = 0;       // share of the ray
    bool surely = true;  // false: only as one of a Squeeze
};

// Two different obstacles on both sides of an edge that a point slides along: one of them must go.
struct Squeeze {
    std::uint32_t one = 0;
    std::uint32_t other = 0;
    double at = 0;  // share of the ray
};

class Ray {
  public:
    void start_query(const Map& map, const CrossingOptions& options);

    // Obstacles that the next rays pass as if they were gone.
    void set_open(std::span<const std::uint32_t> obstacles);

    // Casts a ray that passes at most so many further obstacles, of at most that weight together. False when it was
    // stopped: by an obstacle that cannot be passed any more, or by the edge of the map. What it met before is in
    // hits(). Squeezes count as the cheaper of their obstacles, so a ray can get farther than a path does.
    bool cast(Vertex from, Vertex to, int crossings, double weight);
    // Whether it got to that share of its length.
    bool reaches(double share) const { return !stopped_ || stopped_at_ >= share; }

    // The obstacles that the ray met, each once; when stopped also those that stop it. Their order means nothing.
    std::span<const Hit> hits() const { return hits_; }
    std::span<const Squeeze> squeezes() const { return squeezes_; }

    bool met(std::uint32_t obstacle) const { return marks_[obstacle].ray == ray_; }
    bool open(std::uint32_t obstacle) const { return marks_[obstacle].open == opening_; }
    // Never passed.
    bool solid(std::uint32_t obstacle) const;
    // Against the budget; 0 where it is not limited.
    double weight(std::uint32_t obstacle) const { return weighs_ ? map_->obstacle(ObstacleId{obstacle}).weight : 0; }

  private:
    struct Mark {
        std::uint32_t open = 0;     // the set_open() that named it
        std::uint32_t ray = 0;      // the ray that met it
        std::uint32_t hit = 0;      // its index in hits_, if so
        std::uint32_t protect = 0;  // the query that protects it
        std::uint32_t allow = 0;    // the query that allows it alone, with others
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
    void meet(const Hit& hit);
    void meet_beside(const Hit& hit, bool begins);
    void stop(double at);
    static bool outside(const Frame& frame, int x, int row);
    std::uint32_t label(const Frame& frame, int x, int row) const;
    Hit entry(const Frame& frame, int x, int row) const;
    Hit edge_entry(const Frame& frame, int x, int row, int across) const;

    const Map* map_ = nullptr;
    int reach_ = 2;
    bool touching_ = false;
    bool allows_some_ = false;  // and no others
    bool weighs_ = false;       // whether the budget is limited
    std::unique_ptr<Mark[], Free> marks_;
    std::size_t mark_count_ = 0;
    std::uint32_t query_ = 0;
    std::uint32_t opening_ = 0;
    std::uint32_t ray_ = 0;

    std::vector<Hit> hits_;
    std::vector<Squeeze> squeezes_;
    int crossings_left_ = 0;
    double weight_left_ = 0;
    bool stopped_ = false;
    double stopped_at_ = 0;  // the share at which it was stopped
};

}  // namespace waybreaker::crossing
