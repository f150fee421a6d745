// Tuning of the plans of teams: every constant that was chosen by measuring, not by proof. Paths never collide whatever
// they are: they decide which plan is found, and how soon. What was tried besides: docs/notes/tried.md, teams without
// aircraft.
#pragma once

#include <cstddef>
#include <cstdint>

namespace waybreaker::team::tuning {

// Starts (fleet.cpp). How long the start of a vehicle without a path is kept free of others, in radii driven at its
// speed: time enough to get out of the way in most cases. It doubles when that was too short, up to a time in seconds.
inline constexpr double first_hold = 8;
inline constexpr double longest_hold = 1e9;

// Ways past what opens late (vehicle.cpp). Openings up to which they are searched for in time, and expansions of such a
// search.
inline constexpr std::size_t most_openings_in_time = 8;
inline constexpr std::uint64_t most_expansions_in_time = 20'000;

// Rounds of prioritised planning (team.cpp). A round takes less than replanning does: in the first ones, that has to
// mend one or two vehicles at most, later one in ten of all.
inline constexpr int most_rounds = 50;
inline constexpr int first_rounds = 10;
inline constexpr std::size_t most_missing_at_first = 2;
inline constexpr std::size_t share_missing = 10;  // one in so many, and one more

// Bounds (team.cpp). Share of the time left, once there is a plan, to raise the bounds of vehicles.
inline constexpr double share_of_bounds = 0.2;

// Large neighbourhood search (neighbourhoods.cpp). Vehicles replanned together to give one a path; tries, at most so
// many and so many for each vehicle.
inline constexpr std::size_t most_repaired = 8;
inline constexpr std::size_t most_repairs = 50;
inline constexpr std::size_t repairs_for_each = 4;
// Vehicles replanned together to improve a plan, drawn for each try: other numbers gain as much
// for the time. Tries that fail one after the other before the search ends, and so many more for each vehicle.
inline constexpr int fewest_improved = 2;
inline constexpr int most_improved = 5;
inline constexpr std::size_t most_failures = 100;
inline constexpr std::size_t failures_for_each = 20;

// Lockstep (in_lockstep.cpp). Share of the time left to look for a plan by it.
inline constexpr double share_of_lockstep = 0.2;

}  // namespace waybreaker::team::tuning
