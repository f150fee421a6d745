// Method: how a mission is planned; what the paper fixes is one.
//
//     Mission mission = ground_and_air({12, 20}, {400, 380});
//     Method method;
//     follow_paper(mission.rules, method);
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "waybreaker/limits.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/search_options.hpp"
#include "waybreaker/words.hpp"

namespace waybreaker {

// How obstacles are selected: `exact` proves how far from the best its choice can be, `hits` is the paper's rule,
// `greedy` takes again and again what shortens the ground path (of a team: the objective) most, `none` takes none.
enum class Selection { exact, hits, greedy, none };
template <>
inline constexpr std::array<std::string_view, 4> words_of<Selection>{"exact", "hits", "greedy", "none"};

// How the air agent flies past them: the shortest way, or the paper's for more than one obstacle.
enum class FlightRule { optimal, nearest };
template <>
inline constexpr std::array<std::string_view, 2> words_of<FlightRule>{"optimal", "nearest"};

// How a mission is planned.
struct Method {
    Selection select = Selection::exact;
    FlightRule flight = FlightRule::optimal;
    // Of the ground agent; see planner_of. The members below are SearchOptions' own.
    Algorithm planner = Algorithm::optimal;
    std::optional<Heuristic> heuristic = std::nullopt;
    double weight = 1.0;
    TieBreak tie_break = TieBreak::g_max;
    bool diagonal = true;
    bool bound = false;    // prove a bound whatever the selection (`exact` always does)
    bool explain = false;  // what each removal saves, which would come next, and what each ground agent gains
};

// The planner that drives the ground agent: the one asked for; Theta* in place of `optimal` where hits are to be
// counted, or the agent or its moves are none that `optimal` drives (can_drive_optimally).
Algorithm planner_of(const Method& method, const Body& body);

// The method's search of a ground agent, its planner that of planner_of.
SearchOptions search_options(const Method& method, const Body& body);

// Sets what the paper fixes: Theta*, most hits, obstacles gone from the start, and its flight rules (exact for one
// removal, nearest to the segment for more).
void follow_paper(Rules& rules, Method& method);

// Throws InputError, naming what is wrong, if the mission cannot be put on the map (validate of mission.hpp) or cannot
// be planned by the method, or a limit is none.
void validate(const Map& map, const Mission& mission, const Method& method, const Limits& limits = {});

}  // namespace waybreaker
