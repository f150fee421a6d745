#include "waybreaker/plan.hpp"

#include <algorithm>

#include "waybreaker/map_edit.hpp"

namespace waybreaker {
namespace {

template <class Routes>
auto& first(Routes& routes, AgentKind kind) {
    return *std::ranges::find(routes, kind, &Route::kind);
}

}  // namespace

const Route& Outcome::ground() const {
    return first(routes, AgentKind::ground);
}
const Route& Outcome::air() const {
    return first(routes, AgentKind::air);
}
Route& Outcome::ground() {
    return first(routes, AgentKind::ground);
}
Route& Outcome::air() {
    return first(routes, AgentKind::air);
}

std::optional<double> value(const Outcome& outcome, Objective objective) {
    switch (objective) {
        case Objective::makespan:
            return outcome.makespan;
        case Objective::flowtime:
            return outcome.flowtime;
        case Objective::ground_makespan:
            break;
    }
    return outcome.ground_makespan;
}

Map laid_over(const Map& map, std::span<const Found> found) {
    if (found.empty()) return map;
    std::vector<MapEdit> edits;
    for (const Found& part : found) {
        edits.push_back(part.blocked ? MapEdit::add(part.cells, {.destructible = part.destructible})
                                     : MapEdit::free(part.cells));
    }
    return map.with(edits);
}

}  // namespace waybreaker
