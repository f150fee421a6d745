// Stairs: where a straight line crosses one row after the other, in integers.
#pragma once

#include <cstdint>

#include "crossing/geometry/lattice.hpp"

namespace waybreaker::crossing {

// floor((start + i * step) / divisor) for i = 0, 1, ...: additions only after the first.
class Stairs {
  public:
    Stairs(std::int64_t start, std::int64_t step, std::int64_t divisor)
        : value_(floor_divide(start, divisor)),
          rest_(start - value_ * divisor),
          step_(floor_divide(step, divisor)),
          step_rest_(step - step_ * divisor),
          divisor_(divisor) {}

    std::int64_t value() const { return value_; }
    void next() {
        rest_ += step_rest_;
        const bool carry = rest_ >= divisor_;
        rest_ -= carry ? divisor_ : 0;
        value_ += step_ + carry;
    }

  private:
    std::int64_t value_;
    std::int64_t rest_;
    std::int64_t step_;
    std::int64_t step_rest_;
    std::int64_t divisor_;
};

}  // namespace waybreaker::crossing
