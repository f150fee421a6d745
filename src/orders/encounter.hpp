// Two moves whose discs could touch: the pairs of places (on the one's, on the other's) that are nearer than `reach`.
// They are the part of an ellipse, or of a strip where the moves are parallel, that lies in a rectangle: convex. All of
// it by square roots, no steps.
#pragma once

#include "orders/track.hpp"

namespace waybreaker::orders {

class Encounter {
  public:
    Encounter(const Stretch& first, const Stretch& second, double reach);

    bool empty() const { return places_.empty(); }
    // The places on the second's move where the first could be touched. REQUIRES of what follows: not empty.
    const safe_interval::Interval& places() const { return places_; }
    // How far the first has to be, so that the second does not touch it at that place, and has not if it comes from
    // where it leaves; grows up to `worst`, and is no more from there.
    double furthest(double place) const;
    double worst() const { return worst_; }
    // The first place on the second's move where it touches the first one that stands at its own place.
    double met_at(double place_of_first) const;
    // A pair of places that are too near, well within.
    double middle_of_first() const;
    double middle_of_second() const { return (places_.from + places_.to) / 2; }

  private:
    safe_interval::Interval met(safe_interval::Vector offset) const;
    safe_interval::Interval met_between_ends() const;
    safe_interval::Interval beside(double place) const;
    double place_of_worst() const;

    const Stretch& first_;
    const Stretch& second_;
    double reach_;
    double lasts_;                  // the length of the second's move; any other than 0 of one that never moves
    safe_interval::Vector offset_;  // from the first's start to the second's
    safe_interval::Interval places_;
    double worst_ = 0;
    double most_ = 0;  // how far the first has to be there
};

}  // namespace waybreaker::orders
