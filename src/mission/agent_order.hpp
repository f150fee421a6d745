// Agent order: agents are planned in one order, whatever their order in the mission and their names, so that the same
// agents have the same plan.
#pragma once

#include <cstddef>
#include <vector>

#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

class AgentOrder {
  public:
    explicit AgentOrder(const Mission& mission);

    // The mission with its agents in order of what they are to do.
    const Mission& mission() const { return ordered_; }
    // The plan of the mission as it was given, from one of the ordered one.
    Plan restored(Plan plan) const;

  private:
    Mission ordered_;
    std::vector<std::size_t> from_;  // by place in the order: the place in the mission
};

}  // namespace waybreaker
