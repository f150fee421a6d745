// Sweep: which cells an agent meets when it moves straight from one cell centre to another. Exact, in integers.
//
// Take u along the segment's longer axis and v along the shorter one, both counted from the start, so that the segment
// runs from (0, 0) to (major, minor), major >= minor >= 0. Twice the distance of cell (u, v)'s centre to the line,
// times the segment's length L, is 2|c| with c = u * minor - v * major; the cell's square reaches (major + minor) / L
// further. So the open strip of half width R around the line meets the cell iff
//
//     2|c| < major + minor + 2 R L        and, the left side being an integer,        2|c| <= reach.
//
// For R <= 0.5 the strip between the end points stays inside the box (0, 0)-(major, minor) and the half discs at its
// ends stay inside the end cells, so box and strip together say it all: one interval of u for each v.
#pragma once

#include <cmath>
#include <cstdint>

namespace waybreaker {

// Smallest integer k with k * k >= n. Precondition: n < 2^52.
inline std::int64_t ceil_sqrt(std::int64_t n) {
    // A double holds n exactly and its square root is correctly rounded, so it is off by less than one.
    const auto root = std::int64_t(std::sqrt(double(n)));
    return root * root < n ? root + 1 : root;
}

// `reach` for a disc of radius 0.5 (R = 1/2) and for a point (R = 0).
inline std::int64_t disc_reach(std::int64_t major, std::int64_t minor) {
    return major + minor + ceil_sqrt(major * major + minor * minor) - 1;
}
inline std::int64_t point_reach(std::int64_t major, std::int64_t minor) {
    return major + minor - 1;
}

// Walks the intervals [first, last] of u, one for each v = 0, 1, ..., minor. Precondition: minor >= 1.
// Additions only: quotient and remainder of the interval's ends are carried from line to line.
class Sweep {
  public:
    Sweep(int major, int minor, std::int64_t reach)
        : major_(major), divisor_(2 * minor), step_(major / minor), step_rest_(2 * (major % minor)) {
        const int quotient = int(reach / divisor_);
        const int rest = int(reach % divisor_);
        first_ = -quotient;
        first_rest_ = rest;
        last_ = quotient;
        last_rest_ = rest;
    }

    int first() const { return first_ < 0 ? 0 : first_; }
    int last() const { return last_ > major_ ? major_ : last_; }

    // Without branches: whether a line carries is as good as random.
    void next_line() {
        first_rest_ -= step_rest_;
        const int borrow = first_rest_ >> 31;  // -1 or 0
        first_rest_ += divisor_ & borrow;
        first_ += step_ - borrow;
        last_rest_ += step_rest_ - divisor_;
        const int no_carry = last_rest_ >> 31;
        last_rest_ += divisor_ & no_carry;
        last_ += step_ + 1 + no_carry;
    }

  private:
    int major_;
    int divisor_;
    int step_;
    int step_rest_;
    int first_;
    int first_rest_;
    int last_;
    int last_rest_;
};

}  // namespace waybreaker
