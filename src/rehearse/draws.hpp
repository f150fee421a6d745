// Draws: what chance has in store for one run. Each is a function of the seed, the run, what it is for, whom it
// concerns and how often that was before: nothing that another thread or another plan does changes it.
#pragma once

#include <cstdint>

#include "waybreaker/rehearse.hpp"

namespace waybreaker::rehearsal {

enum class Chance : std::uint64_t { fails, delay, is_blocked, blocked_at, is_lost, lost_at };

class Draws {
  public:
    Draws(std::uint64_t seed, std::uint64_t run);

    // At least 0, below 1.
    double share(Chance what, std::uint64_t whom, std::uint64_t count = 0) const;
    // How late an agent is at its move of that number.
    double delay(const Delay& delay, std::uint64_t agent, std::uint64_t move) const;

  private:
    std::uint64_t run_;
};

}  // namespace waybreaker::rehearsal
