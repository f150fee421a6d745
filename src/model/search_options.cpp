#include "waybreaker/search_options.hpp"

#include "core/range.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {

Heuristic heuristic_of(const SearchOptions& options) {
    if (options.planner == Algorithm::dijkstra || options.planner == Algorithm::bfs) return Heuristic::zero;
    if (options.heuristic) return *options.heuristic;
    if (options.planner == Algorithm::theta || options.planner == Algorithm::lazy_theta) return Heuristic::euclidean;
    return options.diagonal ? Heuristic::octile : Heuristic::manhattan;
}

bool can_drive_optimally(const Body& body, bool diagonal) {
    return diagonal && body.corners == Corners::none;
}

void validate(const SearchOptions& options) {
    require_enumerator(options.planner, Algorithm::optimal, "the planner");
    if (options.heuristic) require_enumerator(*options.heuristic, Heuristic::zero, "the heuristic");
    require_enumerator(options.tie_break, TieBreak::g_min, "the tie-break");
    require_range(options.weight, 1, most_heuristic_weight, "the heuristic's weight");
    if (!(options.limits.seconds >= 0))
        throw InputError(ErrorCode::out_of_range, "the time limit", "the time limit of a search cannot be negative");
    validate(options.body);
    if (options.planner == Algorithm::optimal) {
        if (can_drive_optimally(options.body, options.diagonal)) return;
        throw InputError(
            ErrorCode::contradiction, "",
            "the optimal planner drives an agent that passes no blocked corner by eight moves: use theta for others");
    }
    if (options.planner != Algorithm::jps) return;
    if (!options.diagonal)
        throw InputError(ErrorCode::contradiction, "", "jps needs eight neighbours: use astar for four");
    if (options.body.reach() > 0.5) {
        throw InputError(ErrorCode::contradiction, "",
                         "jps plans for a radius of at most 0.5: use astar or theta for larger agents");
    }
}

}  // namespace waybreaker
