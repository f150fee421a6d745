#include "orders/encounter.hpp"

#include <algorithm>
#include <cmath>

namespace waybreaker::orders {

using safe_interval::cross;
using safe_interval::dot;
using safe_interval::Interval;
using safe_interval::Vector;
using safe_interval::within_reach;

Encounter::Encounter(const Stretch& first, const Stretch& second, double reach)
    : first_(first),
      second_(second),
      reach_(reach),
      lasts_(second.length > 0 ? second.length : 1),
      offset_(second.start - first.start) {
    // Within reach of either end of the first's move, or of the line between them.
    const Interval at_end = met(offset_ - first.length * first.direction);
    places_ = met(offset_);
    places_.join(at_end);
    if (first.length > 0) places_.join(met_between_ends());
    if (empty()) return;
    // Rounding must not decide whether it has to get to its end, where it may vanish.
    worst_ = std::clamp(at_end.empty() ? place_of_worst() : at_end.from, places_.from, places_.to);
    most_ = at_end.empty() ? beside(worst_).to : first.length;
}

// The places on the second's move that are within reach of a place.
Interval Encounter::met(Vector offset) const {
    return within_reach(offset, second_.direction, reach_, lasts_);
}

Interval Encounter::met_between_ends() const {
    Interval places{0, lasts_};
    // Keeps those at which least < value + slope * place < most.
    const auto keep = [&](double value, double slope, double least, double most) {
        if (slope == 0) {
            if (!(least < value && value < most)) places = {};
            return;
        }
        const double a = (least - value) / slope;
        const double b = (most - value) / slope;
        places = {std::max(places.from, std::min(a, b)), std::min(places.to, std::max(a, b))};
    };
    keep(cross(first_.direction, offset_), cross(first_.direction, second_.direction), -reach_, reach_);
    keep(dot(first_.direction, offset_), dot(first_.direction, second_.direction), 0, first_.length);
    return places;
}

// Where the first has to be furthest short of its end: where the way between the two is at right angles to the
// second's.
double Encounter::place_of_worst() const {
    const double turn = cross(first_.direction, second_.direction);
    constexpr double parallel = 1e-9;
    if (std::abs(turn) < parallel) return dot(first_.direction, second_.direction) > 0 ? places_.to : places_.from;
    Vector way{second_.direction.y, -second_.direction.x};
    if (dot(way, first_.direction) < 0) way = -1.0 * way;
    const double place = (cross(offset_, second_.direction) + reach_ * cross(way, second_.direction)) / turn;
    return dot(place * first_.direction - offset_, second_.direction);
}

// The places on the first's move that are too near to that one on the second's.
Interval Encounter::beside(double place) const {
    const Vector from = offset_ + place * second_.direction;
    const double along = dot(from, first_.direction);
    const double aside = cross(from, first_.direction);
    const double half = std::sqrt(std::max(reach_ * reach_ - aside * aside, 0.0));
    return {std::clamp(along - half, 0.0, first_.length), std::clamp(along + half, 0.0, first_.length)};
}

double Encounter::furthest(double place) const {
    return place < worst_ ? beside(place).to : most_;
}

double Encounter::met_at(double place_of_first) const {
    const Interval places = met(offset_ - place_of_first * first_.direction);
    return places.empty() ? worst_ : places.from;
}

double Encounter::middle_of_first() const {
    const Interval places = beside(middle_of_second());
    return (places.from + places.to) / 2;
}

}  // namespace waybreaker::orders
