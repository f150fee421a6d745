// Idle aircraft: those that may breach nothing. They fly home, and what the others do does not depend on them.
#pragma once

#include <cstddef>
#include <vector>

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// A mission without its idle aircraft. A single ground agent keeps one aircraft, idle or not; its mission may remove no
// more than its aircraft may breach.
class ActivePart {
  public:
    explicit ActivePart(const Mission& mission);

    const Mission& mission() const { return active_; }

    // The plan of the whole mission, from one of its active part. The best of the one is the best of the other: idle
    // aircraft delay the end of every plan to the same moment, or add the same to every sum.
    Plan whole(const Map& map, Plan plan) const;

  private:
    bool all_active() const { return active_.agents.size() == whole_.agents.size(); }
    double with_idle(double objective) const;
    void add_idle(Outcome& outcome) const;
    std::vector<std::size_t> places_of(AgentKind kind) const;

    const Mission& whole_;
    Mission active_;
    std::vector<bool> idle_;  // by agent of the whole mission
    bool cut_ = false;        // the aircraft may not breach one obstacle more
    double last_idle_ = 0;    // at home
    double sum_of_idle_ = 0;
};

}  // namespace waybreaker
