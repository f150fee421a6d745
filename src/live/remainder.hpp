// The rest of a plan, gone on with as it is.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "live/left.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::live {

// As a plan of the mission that is left on the map as it is known now: agents on their bases, then as planned. Empty
// where that is no longer possible. `before` and the bound are those of `other`, a plan of the same mission.
std::optional<Plan> remainder_of(const Report& report, std::span<const Position> positions,
                                 std::span<const Outlook> outlooks, const Map& known, const Mission& left,
                                 const Plan& other);

}  // namespace waybreaker::live
