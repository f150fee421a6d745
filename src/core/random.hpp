// Random numbers that are the same on every platform, which those of <random>'s distributions are not.
//
// The generator is SplitMix64 (Steele, Lea, Flood 2014).
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace waybreaker {

class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }

    // Uniform in 0 .. limit - 1. Precondition: limit > 0.
    int below(int limit) {
        assert(limit > 0);
        const std::uint64_t n = std::uint64_t(limit);
        const std::uint64_t fair = UINT64_MAX - UINT64_MAX % n;  // a multiple of n: no remainder is favoured
        std::uint64_t drawn = next();
        while (drawn >= fair) drawn = next();
        return int(drawn % n);
    }

    template <class Value>
    void shuffle(std::vector<Value>& values) {
        for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[std::size_t(below(int(i)))]);
    }

    // True that often: `share` of 0 never, of 1 always.
    bool chance(double share) { return double(next() >> 11) * 0x1p-53 < share; }

  private:
    std::uint64_t state_;
};

}  // namespace waybreaker
