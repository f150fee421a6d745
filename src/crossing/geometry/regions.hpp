// Regions: which obstacles a body must cross to be at a cell.
//
// For the point and the unit square every obstacle is a region of its own. For a wider disc the map is grown by the
// body, as cells; where the growths of several obstacles overlap, the cell belongs to all of them. Each set of
// obstacles that some cell belongs to is a region: docs/exact.md.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/interrupt.hpp"
#include "core/parallel.hpp"
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

// The part that depends on the shape of a map and of a body alone, not on what obstacles weigh: shared by all maps of
// one identity.
struct Shape {
    std::shared_ptr<const void> identity;  // of the map
    Body body;
    bool relaxed = false;
    std::vector<int> half_widths;  // of the growth's rows, by distance from its middle row; empty: not grown
    bool complete = true;
    std::unique_ptr<const Map> grown;                    // none: not grown
    Lists<ObstacleId> members;                           // by region
    Lists<RegionId> regions;                             // by obstacle
    mutable std::unique_ptr<const Permanent> permanent;  // when first asked for
    mutable Once permanent_made;
};

class Regions {
  public:
    // For the body that the options move. Time O(runs of blocked cells * radius) to grow the map, else O(1). The map
    // must outlive every query.
    Regions(const Map& map, const CrossingOptions& options, Interrupt& interrupt);
    // The same regions of a map that differs from theirs only in what its obstacles weigh. O(1).
    Regions(const Regions& known, const Map& map) : shape_(known.shape_), map_(&map) {}
    // False: growing was interrupted, or the growths of so many obstacles overlap that the regions would take much more
    // memory than the map. Then nothing else may be asked.
    bool complete() const { return shape_->complete; }
    // Whether the regions are those of the map and the body, whatever its obstacles weigh.
    bool fit(const Map& map, const CrossingOptions& options) const {
        return shape_->identity == map.identity() && shape_->body == options.body && shape_->relaxed == options.relaxed;
    }
    // Whether weights are those of the map, too.
    bool serve(const Map& map, const CrossingOptions& options) const { return fit(map, options) && map_ == &map; }

    // The map whose obstacles are the regions.
    const Map& map() const { return shape_->grown ? *shape_->grown : *map_; }
    // Cells of it that nothing can free. Made when first asked for, in O(cells).
    const Permanent& permanent() const;
    // Regions are numbered from 1 to this.
    std::size_t count() const { return map().obstacles().size(); }
    // The obstacles' numbers are below this: the edge of the map is one behind the last.
    std::size_t obstacle_limit() const { return map_->obstacles().size() + 2; }

    template <class Visit>
    void for_each_member(RegionId region, Visit visit) const {
        if (!shape_->grown) return visit(ObstacleId{region.value});
        for (const ObstacleId obstacle : shape_->members.of(region.value)) visit(obstacle);
    }
    template <class Visit>
    void for_each_region_of(ObstacleId obstacle, Visit visit) const {
        if (!shape_->grown) return visit(RegionId{obstacle.value});
        for (const RegionId region : shape_->regions.of(obstacle.value)) visit(region);
    }
    // Whether all of a region's obstacles are among these, which are sorted.
    bool within(RegionId region, std::span<const ObstacleId> obstacles) const {
        bool all = true;
        for_each_member(region, [&](ObstacleId obstacle) {
            all = all && std::binary_search(obstacles.begin(), obstacles.end(), obstacle);
        });
        return all;
    }

    // Whether an obstacle can be removed; the edge of the map stands for ever and weighs nothing.
    bool destructible(ObstacleId obstacle) const { return !is_edge(obstacle) && map_->obstacle(obstacle).destructible; }
    double weight(ObstacleId obstacle) const { return is_edge(obstacle) ? 0 : map_->obstacle(obstacle).weight; }
    // Whether the body, a point that stands for a disc, is too wide for a place where two cells touch at a corner.
    bool pinched() const { return shape_->relaxed && shape_->body.radius > 0 && !shape_->grown; }
    // The map is convex, so what it ends at is in the way of no straight line within it.
    bool is_edge(ObstacleId obstacle) const { return obstacle.value > map_->obstacles().size(); }
    // The cells of all its regions lie within.
    Box bounds(ObstacleId obstacle) const {
        const Box box = map_->obstacle(obstacle).bounds;
        const int margin = shape_->half_widths.empty() ? 0 : shape_->half_widths.front();
        return {{box.min.x - margin, box.min.y - margin}, {box.max.x + margin, box.max.y + margin}};
    }

  private:
    Permanent find_permanent() const;

    std::shared_ptr<const Shape> shape_;
    const Map* map_;  // not grown
};

}  // namespace waybreaker::crossing
