// What a plan can reach at best, before it is made: by lower limits of when vehicles arrive.
#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "drive/opening.hpp"
#include "waybreaker/limits.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::clearing {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

class LeastArrivals {
  public:
    // All must outlive it.
    LeastArrivals(const Map& map, const Mission& mission, const Limits& limits, const Deadline& deadline,
                  const Searchers& searchers)
        : map_(map), mission_(mission), limits_(limits), deadline_(deadline), searchers_(searchers) {}

    // No plan's objective is below that: each vehicle crosses as many obstacles as may be removed in all, and waits for
    // none.
    double of_any();

    // The same of plans that remove just these, at these times. `agents`: the mission's, those that clear on their way
    // from where they have breached their last.
    double of(std::span<const TimedOpening> removed, std::span<const Agent> agents);

  private:
    CrossingOptions options_for(const Agent& agent) const;
    double length(std::size_t vehicle, std::vector<ObstacleId> removed);
    double arrival(std::size_t vehicle, std::span<const TimedOpening> removed, const Agent& left);
    double objective(std::span<const double> arrivals) const;

    const Map& map_;
    const Mission& mission_;
    const Limits& limits_;
    const Deadline& deadline_;
    Searchers searchers_;
    std::map<std::pair<std::size_t, std::vector<ObstacleId>>, double> lengths_;
};

}  // namespace waybreaker::clearing
