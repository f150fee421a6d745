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
// where that is no longer possible. Without figures before removal, and without a bound.
std::optional<Plan> remainder_of(const Report& report, std::span<const Position> positions,
                                 std::span<const Outlook> outlooks, const Map& known, const Mission& left);
// Takes those of another plan of the same mission.
void compare(Plan& rest, const Plan& other, Objective objective);

}  // namespace waybreaker::live
