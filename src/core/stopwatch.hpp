// Stopwatch: seconds since it was made. Deadline: seconds that are left.
#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

namespace waybreaker {

class Stopwatch {
  public:
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

class Deadline {
  public:
    // So many seconds from now; infinity: never.
    explicit Deadline(double seconds = std::numeric_limits<double>::infinity()) : seconds_(seconds) {}

    double left() const { return std::max(seconds_ - watch_.seconds(), 0.0); }
    bool passed() const { return left() <= 0; }
    // When that share of what is left is over.
    Deadline share(double part) const { return Deadline(part * left()); }

  private:
    double seconds_;
    Stopwatch watch_;
};

}  // namespace waybreaker
