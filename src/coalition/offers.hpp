// Offers: what vehicles pay for obstacles, and what set is paid best.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "coalition/problem.hpp"

namespace waybreaker::coalition {

struct Offer {
    ObstacleId obstacle;
    double paid = 0;    // less what its breach takes
    double detour = 0;  // no aircraft that breaches it flies less
};

class Offers {
  public:
    Offers() = default;
    explicit Offers(std::vector<Offer> offers);

    const std::vector<Offer>& all() const { return offers_; }
    // No set of so many obstacles, beside some that are in it anyway, is paid better, less the longest detour of its
    // obstacles, which is at least `floor`. Of the sets with no longer detour the best holds those that most is paid
    // for: time O(k log n) for k offers. Those of such a set, on request.
    double best(std::size_t most, double floor = 0, const Set& beside = {},
                std::vector<ObstacleId>* chosen = nullptr) const;
    // The fractional knapsack: no set that weighs so much is paid better.
    double best_by_weight(const Map& map, double budget, std::vector<ObstacleId>& chosen) const;

  private:
    std::vector<Offer> offers_;  // of more than nothing; the shortest detour first
};

// What an obstacle that nobody pays for may be offered, if no set of so many is to be paid better than the best is now,
// however many of its members have such an offer.
class FreeOffers {
  public:
    FreeOffers(const Offers& offers, std::size_t most);
    double of(double detour) const;

  private:
    struct Step {
        double detour = 0;
        double paid = 0;   // to the best set with no longer detour
        double least = 0;  // to a member of it; 0 where there is room for more
        double left = 0;   // until a set with a detour as long, or longer, is the best
    };
    std::vector<Step> steps_;  // the shortest detour first
    std::size_t most_;
    double best_;
};

}  // namespace waybreaker::coalition
