// Shortest paths through cell centres against every path from centre to centre.
#include "drive/centres.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <vector>

#include "random_map.hpp"
#include "slow_sight.hpp"

namespace waybreaker {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// By moving straight between any two cells, as long as that shortens anything.
double shortest(const PlainMap& map, Cell start, Cell goal, const Body& body) {
    const std::vector<Cell> cells = map.free_cells();
    std::vector<double> reached(cells.size(), never);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i] == start && slow::sees(map, start, start, body)) reached[i] = 0;
    }
    for (bool shorter = true; shorter;) {
        shorter = false;
        for (std::size_t a = 0; a < cells.size(); ++a) {
            for (std::size_t b = 0; b < cells.size(); ++b) {
                const double length = reached[a] + distance(cells[a], cells[b]);
                if (length >= reached[b] || !slow::sees(map, cells[a], cells[b], body)) continue;
                reached[b] = length;
                shorter = true;
            }
        }
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i] == goal) return reached[i];
    }
    return never;
}

RC_GTEST_PROP(Centres, TellTheShortestPathThroughThem, ()) {
    const PlainMap plain = *random_map(9, 9);
    const Map map(plain.grid());
    const Cell start = any_free_cell(plain);
    const Cell goal = any_free_cell(plain);
    const Body body{.radius = *rc::gen::element(0.1, 0.2, 0.353, 0.5, 0.5, 0.7, 1.2)};
    const double length = shortest(plain, start, goal, body);
    const double longer = *rc::gen::element(1.0, 1.1, 3.0);
    const double known = length < never ? length * longer : 1.5 * distance(start, goal);
    const OpenedMap opened(map);
    const double expected = length < never ? length : known;
    RC_CLASSIFY(length < never && length > distance(start, goal) + 1e-9, "with bends");
    RC_ASSERT(std::abs(least_through_centres(opened, start, goal, body, known, UINT64_MAX) - expected) < 1e-6);
    // With fewer looks it is less, and no less than the straight line.
    const auto looks = std::uint64_t(*number(0, 200));
    const double less = least_through_centres(opened, start, goal, body, known, looks);
    RC_ASSERT(less <= expected + 1e-6);
    RC_ASSERT(less >= distance(start, goal) - 1e-6);
}

}  // namespace
}  // namespace waybreaker
