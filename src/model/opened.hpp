// Obstacles that open by themselves (Rules::opened), as planning sees them: those that are open before anybody moves
// never were there, and none ever was where timing is ignored.
#pragma once

#include <optional>
#include <span>

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker {

class OpenedByThemselves {
  public:
    // Both must outlive it.
    OpenedByThemselves(const Map& map, const Mission& mission);

    // Without what is open from the start; ids stay.
    const Map& map() const { return opened_ ? *opened_ : map_; }
    // Only what opens later opens by itself.
    const Mission& mission() const { return mission_; }

  private:
    const Map& map_;
    std::optional<Map> opened_;
    Mission mission_;
};

// Of those that open late on a path, the one that the agent waits for longest; none if it never waits.
std::optional<ObstacleId> most_waited_for(const Map& map, const Agent& agent, std::span<const Point> path,
                                          std::span<const TimedOpening> openings);

}  // namespace waybreaker
