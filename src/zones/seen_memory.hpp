// What has been found out of spots, for the next time; of many spots only some are kept. Any number of threads may ask.
#pragma once

#include <cstddef>
#include <cstdint>
#ifndef WAYBREAKER_NO_THREADS
#include <mutex>
#endif
#include <unordered_map>
#include <vector>

#include "zones/lattice.hpp"

namespace waybreaker::zones {

class SeenMemory {
  public:
    // Numbers of corners that are seen from a spot: as look() finds them, the first time.
    template <class Look>
    std::vector<std::size_t> of(Spot at, const Look& look) {
        {
            const Guard guard(mutex_);
            const auto known = known_.find(at);
            if (known != known_.end()) return known->second;
        }
        std::vector<std::size_t> seen = look();
        const Guard guard(mutex_);
        if (known_.size() < most_kept) known_.emplace(at, seen);
        return seen;
    }

  private:
    static constexpr std::size_t most_kept = std::size_t{1} << 16U;

#ifdef WAYBREAKER_NO_THREADS
    struct Mutex {};
    struct Guard {
        explicit Guard(Mutex& /*mutex*/) {}
    };
#else
    using Mutex = std::mutex;
    using Guard = std::lock_guard<std::mutex>;
#endif

    struct Hash {
        std::size_t operator()(Spot spot) const {
            return std::size_t((std::uint64_t(spot.x) * 0x9E3779B97F4A7C15U) ^
                               (std::uint64_t(spot.y) * 0xC2B2AE3D27D4EB4FU));
        }
    };

    Mutex mutex_;
    std::unordered_map<Spot, std::vector<std::size_t>, Hash> known_;
};

}  // namespace waybreaker::zones
