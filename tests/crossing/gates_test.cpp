// The gates of a group, one by one, against all of them in order of what they cost.
#include "crossing/in_time/gates.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

#include "random_map.hpp"

namespace waybreaker {
namespace {

using namespace crossing;

// Points in a row, a cell apart.
Border row_of(int count) {
    Border border;
    for (int i = 0; i < count; ++i) {
        border.points.push_back({2 * i, 0});
        border.neighbours.push_back({i > 0 ? std::uint32_t(i - 1) : no_neighbour,
                                     i + 1 < count ? std::uint32_t(i + 1) : no_neighbour, no_neighbour, no_neighbour});
    }
    border.min = border.points.front();
    border.max = border.points.back();
    return border;
}

// How far it is from each point to the goal: a step along the row changes that by at most its length. Infinity where
// that is too far for who starts there.
std::map<int, double> any_rests(const Border& border, Vertex goal) {
    double rest = length(goal - border.points.front()) + *number(0, 40);
    const bool limited = *rc::gen::arbitrary<bool>();
    std::map<int, double> rests;
    for (const Vertex v : border.points) {
        rest = std::max(rest + 0.25 * *number(-8, 8), length(goal - v));
        rests[v.x] = limited && *number(0, 3) == 0 ? infinity : rest;
    }
    return rests;
}

RC_GTEST_PROP(GateGroup, TellsOfEachGateInTheOrderOfItsCost, ()) {
    const Border border = row_of(*number(1, 24));
    const Vertex goal{*number(-10, 60), *number(1, 40)};
    const std::map<int, double> rests = any_rests(border, goal);
    GateGroup::Terms terms;
    terms.from = {*number(-10, 60), *number(-40, -1)};
    terms.arrival = *number(0, 20);
    terms.open = *number(0, 80);
    terms.early = *number(0, 1);
    GateGroup group(terms, border);
    const auto stands = [](Vertex v) { return v.x % 5 != 0; };
    std::map<int, double> expected;  // what it costs by way of each
    for (const Vertex v : border.points) {
        const double arrival = terms.arrival + length(v - terms.from);
        const bool waits = arrival - terms.early < terms.open + (terms.early > 0 ? 0 : 2);
        if (stands(v) && waits && rests.at(v.x) < infinity) {
            expected[v.x] = std::max(terms.open, arrival) - terms.early + rests.at(v.x);
        }
    }
    double before = 0;
    while (group.find_best(goal, stands, [&](Vertex v, double) { return rests.at(v.x); })) {
        const GateGroup::Gate gate = group.best();
        if (!group.proven()) {
            group.prove(terms.arrival + length(gate.at - terms.from));
            continue;
        }
        group.take();
        RC_ASSERT(expected.contains(gate.at.x));
        RC_ASSERT(std::abs(gate.estimate - expected[gate.at.x]) < 1e-9);
        RC_ASSERT(gate.estimate >= before - 1e-9);
        before = gate.estimate;
        expected.erase(gate.at.x);
    }
    RC_ASSERT(expected.empty());
}

}  // namespace
}  // namespace waybreaker
