// Further crossings: a path in time either crosses more than it has, and that opens late, or drives past all else that
// stands. Each gives a better lower bound than the straight line: docs/exact.md.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "crossing/geometry/ray.hpp"
#include "crossing/labels/cost_to_go.hpp"
#include "crossing/labels/crossed_sets.hpp"
#include "crossing/labels/labels.hpp"
#include "crossing/labels/query.hpp"

namespace waybreaker::crossing {

class FurtherCrossings {
  public:
    // All must outlive it.
    FurtherCrossings(const CrossingQuery& query, CrossingProgress& progress, const CrossedSets& sets,
                     CostToGo& cost_to_go, const Ray& ray)
        : query_(query), progress_(progress), sets_(sets), cost_to_go_(cost_to_go), ray_(ray) {}

    void start_query() { through_open_.start_query(query_, CostToGo::Passes::open, progress_.interrupt); }
    // Whenever the limit changes.
    void start_ellipse();

    // Lower bound of the cost of all paths that cross more than the set: whatever they cross next opens with all of the
    // set. 0 if one may cost no more than `than`: then it does not matter how much less.
    double least_with_more(std::uint32_t set, double than);
    // Lower bound of the cost to go for a path that crosses nothing else, if it then costs no more than `most`.
    double cost_to_go_without_more(Vertex v, double cost, std::uint32_t set, double most);
    // Lower bound of the cost of all paths that go on from a label.
    double estimate(const Label& label);

  private:
    double least_with(std::span<const ObstacleId> sorted, double to_go) const;

    // An obstacle that paths which matter may cross, and how far it is from there to the goal at least, half cells.
    struct Openable {
        ObstacleId obstacle;
        double to_go;
    };

    const CrossingQuery& query_;
    CrossingProgress& progress_;
    const CrossedSets& sets_;
    CostToGo& cost_to_go_;
    const Ray& ray_;
    CostToGo through_open_;  // where nothing else is crossed
    std::vector<Openable> openable_;
    std::vector<double> least_with_more_;  // by set; below 0: not known yet
};

}  // namespace waybreaker::crossing
