// Foresight: an agent that is late looks ahead to zones that hold for a time.
#pragma once

#include "mission/zone_stays.hpp"
#include "rehearse/actor.hpp"

namespace waybreaker::rehearsal {

class Foresight {
  public:
    // Both must outlive it.
    Foresight(const Map& map, const Mission& mission) : mission_(mission), watch_(map, mission) {}

    // When an agent may go on: now, unless it would come into a zone that holds, or begins to before it is out, though
    // it is not late again. Then when it would come there as that is over; never, if it has no end. A zone that it is
    // in already does not count: it can only go on out of it.
    double may_go_on(const Actor& actor, double now) const;

  private:
    const Mission& mission_;
    ZoneWatch watch_;
};

}  // namespace waybreaker::rehearsal
