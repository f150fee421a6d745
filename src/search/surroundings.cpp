#include "search/surroundings.hpp"

#include <limits>

namespace waybreaker {
namespace {

// Whether the step by (dx, dy) from `from` (coordinates -1..1 around the middle) stays inside and is legal.
bool legal(Neighbourhood blocked, int x, int y, const Step& step, Corners corners) {
    const int to_x = x + step.dx;
    const int to_y = y + step.dy;
    if (to_x < -1 || to_x > 1 || to_y < -1 || to_y > 1) return false;
    if ((blocked & step_bit(to_x, to_y)) != 0) return false;
    if (step.dx == 0 || step.dy == 0) return true;
    const int blocked_sides =
        ((blocked & step_bit(to_x, y)) != 0 ? 1 : 0) + ((blocked & step_bit(x, to_y)) != 0 ? 1 : 0);
    return blocked_sides <= (corners == Corners::none ? 0 : corners == Corners::cut ? 1 : 2);
}

StepTable make_legal_steps(Corners corners, bool diagonal) {
    StepTable table{};
    for (unsigned blocked = 0; blocked < table.size(); ++blocked) {
        for (const Step& step : steps) {
            if (step.cost == 0 || (!diagonal && step.cost != 1)) continue;
            if (legal(Neighbourhood(blocked), 0, 0, step, corners)) table[blocked] |= step_bit(step.dx, step.dy);
        }
    }
    return table;
}

// Shortest paths from one of the nine cells to all others that avoid the middle (Bellman-Ford: eight rounds do).
std::array<double, 9> distances_around(Neighbourhood blocked, int from, Corners corners) {
    std::array<double, 9> distance;
    distance.fill(std::numeric_limits<double>::infinity());
    distance[std::size_t(from)] = 0;
    for (int round = 0; round < 8; ++round) {
        for (int cell = 0; cell < 9; ++cell) {
            if (cell == 4) continue;
            const int x = cell % 3 - 1;
            const int y = cell / 3 - 1;
            for (const Step& step : steps) {
                if (step.cost == 0 || !legal(blocked, x, y, step, corners)) continue;
                double& to = distance[std::size_t(step_index(x + step.dx, y + step.dy))];
                to = std::min(to, distance[std::size_t(cell)] + step.cost);
            }
        }
    }
    return distance;
}

PrunedStepTable make_unpruned_steps(Corners corners) {
    constexpr double rounding = 1e-9;
    const StepTable& allowed = legal_steps(corners, true);
    PrunedStepTable table{};
    for (unsigned blocked = 0; blocked < table.size(); ++blocked) {
        for (const Step& arrival : steps) {
            Neighbourhood& kept = table[blocked][std::size_t(step_index(arrival.dx, arrival.dy))];
            if (arrival.cost == 0) {  // the start: everything
                kept = allowed[blocked];
                continue;
            }
            const auto around = distances_around(Neighbourhood(blocked), step_index(-arrival.dx, -arrival.dy), corners);
            for_each_offset(allowed[blocked], [&](int to) {
                const double through = arrival.cost + steps[std::size_t(to)].cost;
                const double beside = around[std::size_t(to)];
                const bool pruned = arrival.cost == 1 ? beside <= through + rounding : beside < through - rounding;
                if (!pruned) kept |= Neighbourhood(1U << to);
            });
        }
    }
    return table;
}

}  // namespace

const StepTable& legal_steps(Corners corners, bool diagonal) {
    static const std::array<StepTable, 6> tables{
        make_legal_steps(Corners::none, false),    make_legal_steps(Corners::none, true),
        make_legal_steps(Corners::cut, false),     make_legal_steps(Corners::cut, true),
        make_legal_steps(Corners::squeeze, false), make_legal_steps(Corners::squeeze, true)};
    return tables[2 * std::size_t(corners) + (diagonal ? 1 : 0)];
}

const PrunedStepTable& unpruned_steps(Corners corners) {
    static const std::array<PrunedStepTable, 3> tables{
        make_unpruned_steps(Corners::none), make_unpruned_steps(Corners::cut), make_unpruned_steps(Corners::squeeze)};
    return tables[std::size_t(corners)];
}

}  // namespace waybreaker
