// Late entries: aircraft that come to a zone while it holds, and fly in when it is over.
#pragma once

#include <optional>
#include <span>

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker {

// Of an aircraft that is in the interior of a zone at some time after it is ready, but only while the zone does not
// hold: a lower bound of when it is at `place` after that. Until it enters it keeps to its airspace, which is what the
// zones `around` leave it, that zone among them: it comes to an edge from the outer side, from where it begins or from
// a corner, and goes on straight. Infinity where no edge is on the map. REQUIRES: it does not begin in the zone.
double least_arrival_past(const Map& map, const Agent& aircraft, std::span<const Zone> around, const Zone& zone,
                          Point place);

struct LateEntry {
    Point at = {};         // at the outline, a hair outside
    double enters_at = 0;  // when it is there and the zone is over
    double arrival = 0;    // at `place`, by a straight flight
};

// One of these flights that enters when the zone is over, the best of those that come to each edge in the best place.
// Empty if there is none. REQUIRES: as above.
std::optional<LateEntry> earliest_entry(const Map& map, const Agent& aircraft, std::span<const Zone> around,
                                        const Zone& zone, Point place);

// An aircraft as it is when it has come to an entry, in its airspace: it begins there, and the way there is its
// approach. It sets out so late that it need not wait there; one that is in the air hovers. `asked`: as in the mission.
// Empty if there is no way.
std::optional<Agent> come_to(const Map& map, const LateEntry& entry, const Agent& asked, Agent aircraft);

}  // namespace waybreaker
