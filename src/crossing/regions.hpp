// Regions: which obstacles a body must cross to be at a cell.
//
// For the point and the unit square every obstacle is a region of its own. For a wider disc the map is grown by the
// body, as cells; where the growths of several obstacles overlap, the cell belongs to all of them. Each set of
// obstacles that some cell belongs to is a region: docs/exact.md.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "crossing/interrupt.hpp"
#include "waybreaker/crossing.hpp"

namespace waybreaker::crossing {

// A region. On a map that is not grown its number is that of its one obstacle.
struct RegionId {
    std::uint32_t value = 0;
    friend constexpr auto operator<=>(RegionId, RegionId) = default;
    explicit constexpr operator bool() const { return value != 0; }
};

// The region that a cell of Regions::map() belongs to; false if it is free.
inline RegionId region_at(const Map& map, Cell c) {
    return {map.obstacle_at(c).value};
}

// Cells that stay, as a grid and with x and y exchanged.
struct Permanent {
    Grid rows;
    Grid columns;
};

class Regions {
  public:
    // For the body that the options move. Time O(runs of blocked cells * radius) to grow the map, else O(1). The map
    // must outlive it unless it is grown.
    Regions(const Map& map, const CrossingOptions& options, Interrupt& interrupt);
    Regions(const Regions&) = delete;
    Regions& operator=(const Regions&) = delete;
    // False: growing was interrupted, or the growths of so many obstacles overlap that the regions would take much more
    // memory than the map. Then nothing else may be asked.
    bool complete() const { return complete_; }
    bool serve(const Map& map, const CrossingOptions& options) const {
        const bool same_map = identity_ == map.identity() && (!half_widths_.empty() || original_ == &map);
        return same_map && body_ == options.body && relaxed_ == options.relaxed;
    }

    // Whose obstacles are the regions.
    const Map& map() const { return grown_ ? *grown_ : *original_; }
    // Of its cells those that nothing can free. Made when first asked for, in O(cells).
    const Permanent& permanent() const;
    // Regions are numbered from 1 to this.
    std::size_t count() const { return map().obstacles().size(); }
    // The obstacles' numbers are below this: the edge of the map is one behind the last.
    std::size_t obstacle_limit() const { return obstacles().size() + 2; }

    template <class Visit>
    void for_each_member(RegionId region, Visit visit) const {
        if (!grown_) return visit(ObstacleId{region.value});
        for (const ObstacleId obstacle : members_.of(region.value)) visit(obstacle);
    }
    template <class Visit>
    void for_each_region_of(ObstacleId obstacle, Visit visit) const {
        if (!grown_) return visit(RegionId{obstacle.value});
        for (const RegionId region : regions_.of(obstacle.value)) visit(region);
    }
    // Whether all of a region's obstacles are among these, which are sorted.
    bool within(RegionId region, std::span<const ObstacleId> obstacles) const {
        bool all = true;
        for_each_member(region, [&](ObstacleId obstacle) {
            all = all && std::binary_search(obstacles.begin(), obstacles.end(), obstacle);
        });
        return all;
    }

    // Of an obstacle; the edge of the map stands for ever and weighs nothing.
    bool destructible(ObstacleId obstacle) const {
        return !is_edge(obstacle) && obstacles()[obstacle.value - 1].destructible;
    }
    double weight(ObstacleId obstacle) const { return is_edge(obstacle) ? 0 : obstacles()[obstacle.value - 1].weight; }
    // Whether the body, a point that stands for a disc, is too wide for a place where two cells touch at a corner.
    bool pinched() const { return relaxed_ && body_.radius > 0 && !grown_; }
    // The map is convex, so what it ends at is in the way of no straight line within it.
    bool is_edge(ObstacleId obstacle) const { return obstacle.value > obstacles().size(); }
    // The cells of all its regions lie within.
    Box bounds(ObstacleId obstacle) const {
        const Box box = obstacles()[obstacle.value - 1].bounds;
        return {{box.min.x - margin_, box.min.y - margin_}, {box.max.x + margin_, box.max.y + margin_}};
    }

  private:
    // Lists, by number from 1 on.
    template <class Id>
    class Lists {
      public:
        void add(std::span<const Id> list) {
            items_.insert(items_.end(), list.begin(), list.end());
            begins_.push_back(items_.size());
        }
        std::span<const Id> of(std::uint32_t number) const {
            return {items_.data() + begins_[number], items_.data() + begins_[number + 1]};
        }

      private:
        std::vector<Id> items_;
        std::vector<std::size_t> begins_{0, 0};  // number 0 has none
    };

    std::span<const Obstacle> obstacles() const { return grown_ ? std::span(grown_from_) : original_->obstacles(); }

    Permanent find_permanent() const;

    std::shared_ptr<const void> identity_;  // of the map
    Body body_;
    bool relaxed_;
    std::vector<int> half_widths_;  // of the growth's rows, by distance from its middle row; empty: none
    int margin_ = 0;                // cells by which it reaches beyond an obstacle
    const Map* original_;           // to be used only while it is not grown
    bool complete_ = true;
    std::optional<Map> grown_;
    mutable std::unique_ptr<const Permanent> permanent_;
    mutable std::once_flag permanent_made_;
    std::vector<Obstacle> grown_from_;
    Lists<ObstacleId> members_;  // by region
    Lists<RegionId> regions_;    // by obstacle
};

}  // namespace waybreaker::crossing
