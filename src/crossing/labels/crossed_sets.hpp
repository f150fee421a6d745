// Crossed sets: the sets of obstacles that labels have crossed, with what it costs to cross all of a set: when it is
// open, when its opener has flown home, and its price.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "crossing/labels/obstacle_sets.hpp"
#include "crossing/labels/query.hpp"

namespace waybreaker::crossing {

class CrossedSets {
  public:
    // The query must outlive the sets; clear() before each.
    explicit CrossedSets(const CrossingQuery& query) : query_(query) {}

    void clear();
    // Throws InputError where the caller's functions give no sensible answer for the set.
    std::uint32_t find_or_add(std::span<const ObstacleId> sorted);
    std::span<const ObstacleId> operator[](std::uint32_t set) const { return sets_[set]; }

    // Time until all of them are open; this and all below in half cells.
    double opened_after(std::span<const ObstacleId> sorted) const;
    double paid(std::uint32_t set) const { return paid_.empty() ? 0 : paid_[set]; }
    // Cost that the opener's mission adds to that of a path; 0 unless it is added.
    double added(std::uint32_t set) const { return query_.opener->adds_both && !done_.empty() ? done_[set] : 0; }
    // Cost of a path that takes so long on the ground.
    double cost(double ground, std::uint32_t set) const {
        return (done_.empty() ? ground : with_mission(ground, done_[set])) + paid(set);
    }
    // The same of a set that may not be stored, its price aside.
    double unpaid_cost(double ground, std::span<const ObstacleId> sorted) const;

  private:
    double with_mission(double ground, double done) const {
        return query_.opener->adds_both ? ground + done : std::max(ground, done);
    }

    const CrossingQuery& query_;
    ObstacleSets sets_;
    std::vector<double> done_;  // by set; empty: the query has none
    std::vector<double> paid_;  // likewise
};

}  // namespace waybreaker::crossing
