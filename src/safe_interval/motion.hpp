// Motion: when two discs that move straight at constant speed overlap. Closed formulas, no steps in time.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace waybreaker::safe_interval {

inline constexpr double for_ever = std::numeric_limits<double>::infinity();

// From `from` to `to`, the ends not included; empty unless from < to.
struct Interval {
    double from = for_ever;
    double to = -for_ever;

    bool empty() const { return !(from < to); }
    // The smallest interval that holds both.
    void join(const Interval& other) {
        if (other.empty()) return;
        from = std::min(from, other.from);
        to = std::max(to, other.to);
    }
};

struct Vector {
    double x = 0;
    double y = 0;
    friend Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
    friend Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
    friend Vector operator*(double s, Vector a) { return {s * a.x, s * a.y}; }
};
inline double dot(Vector a, Vector b) {
    return a.x * b.x + a.y * b.y;
}
inline double cross(Vector a, Vector b) {
    return a.x * b.y - a.y * b.x;
}

// A point that starts to move at a time, or stands (velocity 0, and then `to` can be infinity).
struct Leg {
    Vector start;
    Vector velocity;
    double from = 0;
    double to = 0;

    Vector at(double time) const {
        return velocity.x == 0 && velocity.y == 0 ? start : start + (time - from) * velocity;
    }
};

// While |offset + t * velocity| < reach, for t from 0 to `duration`.
inline Interval within_reach(Vector offset, Vector velocity, double reach, double duration) {
    const double a = dot(velocity, velocity);
    const double c = dot(offset, offset) - reach * reach;
    if (a == 0) return c < 0 ? Interval{0, duration} : Interval{};
    const double b = dot(offset, velocity);
    // Judges by the distance to the line, which is exact where the point passes at just that distance.
    const double aside = cross(offset, velocity);
    const double discriminant = a * reach * reach - aside * aside;
    if (discriminant <= 0) return {};
    const double root = std::sqrt(discriminant);
    return {std::max((-b - root) / a, 0.0), std::min((-b + root) / a, duration)};
}

// While two legs are less than `reach` apart.
inline Interval overlap(const Leg& a, const Leg& b, double reach) {
    const double from = std::max(a.from, b.from);
    const double to = std::min(a.to, b.to);
    if (!(from < to)) return {};
    const Interval found = within_reach(a.at(from) - b.at(from), a.velocity - b.velocity, reach, to - from);
    return {from + found.from, from + found.to};
}

// A straight move whose departure is still open.
struct Move {
    Vector start;
    Vector velocity;
    double duration = 0;
};

// The departures with which the move comes nearer than `reach` to the leg: one interval, because the pairs (share of
// the move, time) at which the two are near are the convex part of an ellipse in a rectangle, and a departure is a
// linear function of such a pair.
inline Interval unsafe_departures(const Move& move, const Leg& leg, double reach) {
    const Vector offset = move.start - leg.start;
    const bool stands = leg.velocity.x == 0 && leg.velocity.y == 0;
    Interval unsafe;
    if (stands) {
        const Interval near = within_reach(offset, move.velocity, reach, move.duration);
        return near.empty() ? near : Interval{leg.from - near.to, leg.to - near.from};
    }
    const double lasts = leg.to - leg.from;
    const Vector back = -1.0 * leg.velocity;
    // The sides of the rectangle: at the move's start and end, and at the leg's.
    const auto shifted = [](const Interval& i, double by) { return Interval{i.from + by, i.to + by}; };
    const auto mirrored = [](const Interval& i, double at) { return i.empty() ? i : Interval{at - i.to, at - i.from}; };
    unsafe.join(shifted(within_reach(offset, back, reach, lasts), leg.from));
    const Vector end = offset + move.duration * move.velocity;
    unsafe.join(shifted(within_reach(end, back, reach, lasts), leg.from - move.duration));
    unsafe.join(mirrored(within_reach(offset, move.velocity, reach, move.duration), leg.from));
    const Vector late = offset - lasts * leg.velocity;
    unsafe.join(mirrored(within_reach(late, move.velocity, reach, move.duration), leg.to));
    // The first and the last departure at which the two only just meet, where that is inside.
    const Vector relative = move.velocity - leg.velocity;
    const double turn = cross(leg.velocity, relative);
    if (turn == 0) return unsafe;
    const double length2 = dot(relative, relative);
    const double shadow = reach * std::sqrt(length2);
    for (const double side : {-shadow, shadow}) {
        const double delay = (cross(offset, relative) + side) / turn;
        const double driven = -dot(offset - delay * leg.velocity, relative) / length2;
        if (driven < 0 || driven > move.duration || driven + delay < 0 || driven + delay > lasts) continue;
        unsafe.from = std::min(unsafe.from, leg.from + delay);
        unsafe.to = std::max(unsafe.to, leg.from + delay);
    }
    return unsafe;
}

}  // namespace waybreaker::safe_interval
