// State: what has happened to a plan that is being executed, as its agents report it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waybreaker/cell.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"
#include "waybreaker/words.hpp"

namespace waybreaker {

// What an agent does. `moving`: it drives or flies; `waiting`: it stands and can go on; `breaching`: an air agent is at
// work on an obstacle; `stopped`: it stands and cannot go on, it blocks the way from now on if it is a ground agent;
// `lost`: it takes no further part, and is in nobody's way.
enum class Doing { moving, waiting, breaching, stopped, lost };
template <>
inline constexpr std::array<std::string_view, 5> words_of<Doing>{"driving", "waiting", "breaching", "stopped", "lost"};

struct AgentState {
    std::string id = {};
    std::size_t passed = 0;        // the last point of its planned path, counted from 0, that it has left behind
    std::optional<Point> at = {};  // where it is, in cells; empty: where the plan has it by now
    Doing doing = Doing::moving;
    std::optional<Cell> goal = {};  // it is to go there from now on
    // How long an air agent has been in the air since its battery was full, in units of time; empty: as planned.
    std::optional<double> flown = {};
};

struct State {
    std::uint64_t sequence = 0;             // of reports, rising: one that the plan knows already changes nothing
    double now = 0;                         // units of time, on the clock of the plan
    std::vector<AgentState> agents = {};    // those not named are where the plan has them
    std::vector<TimedOpening> opened = {};  // since the plan, or as it says; or known to open later
    std::vector<TimedOpening> failed = {};  // breaches that left the obstacle standing, and when that was known
    std::vector<Found> found = {};
    std::vector<Agent> joined = {};  // new agents
};

}  // namespace waybreaker
