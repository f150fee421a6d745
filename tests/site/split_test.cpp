// What sections promise, held against the cells themselves.
#include "site/split.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "ascii_map.hpp"
#include "input_error.hpp"
#include "random_map.hpp"
#include "site/random_layer.hpp"

namespace waybreaker::site {
namespace {

// A map of buildings with all that can be known of them, some of which cannot be destroyed.
struct Town {
    DescribedMap whole;
    Lattice lattice;
    DescribedMap cut() const { return split(whole.map, whole.annotations, lattice); }
};

Town random_town(bool weighed = true) {
    DescribedMap whole = described(random_layer(weighed));
    return {std::move(whole), {*number(1, 9), {*number(0, 12), *number(0, 12)}}};
}

int floor_divide(int a, int b) {
    return a / b - (a % b < 0 ? 1 : 0);
}

// The square of the lattice that a cell is in.
std::pair<int, int> square_of(Cell c, const Lattice& lattice) {
    return {floor_divide(c.x - lattice.origin.x, lattice.side), floor_divide(c.y - lattice.origin.y, lattice.side)};
}

using Squares = std::map<std::pair<int, int>, int>;  // destructible cells by square

Squares squares_of(const DescribedMap& cut, ObstacleId id, const Lattice& lattice) {
    Squares squares;
    for_each_cell(cut.map, [&](Cell c) {
        if (cut.map.obstacle_at(c) == id) ++squares[square_of(c, lattice)];
    });
    return squares;
}

bool is_small(int cells, const Lattice& lattice) {
    return 20 * cells < lattice.side * lattice.side;
}

RC_GTEST_PROP(Split, ClearsTogetherWhatCouldBeDestroyed, ()) {
    const Town town = random_town();
    const DescribedMap cut = town.cut();
    const auto can_go = [](const Map& map, Cell c) {
        const ObstacleId id = map.obstacle_at(c);
        return id.value != 0 && map.obstacle(id).destructible;
    };
    for_each_cell(cut.map, [&](Cell c) {
        RC_ASSERT(cut.map.grid().blocked(c) == town.whole.map.grid().blocked(c));
        RC_ASSERT(can_go(cut.map, c) == can_go(town.whole.map, c));
    });
}

RC_GTEST_PROP(Split, LeavesWholeWhatCannotBeDestroyed, ()) {
    const Town town = random_town();
    const DescribedMap cut = town.cut();
    for (const Obstacle& before : town.whole.map.obstacles()) {
        if (before.destructible) continue;
        std::set<std::uint32_t> ids;
        for_each_cell(cut.map, [&](Cell c) {
            if (town.whole.map.obstacle_at(c) == before.id) ids.insert(cut.map.obstacle_at(c).value);
        });
        RC_ASSERT(ids.size() == 1U);
        const Obstacle& after = cut.map.obstacle({*ids.begin()});
        RC_ASSERT(after.cells == before.cells);
        RC_ASSERT(after.source_id == before.source_id);
        RC_ASSERT(after.weight == before.weight);
        RC_ASSERT(after.breach_time == before.breach_time);
        RC_ASSERT(cut.annotations.kinds[after.id.value] == town.whole.annotations.kinds[before.id.value]);
        const bool named =
            !town.whole.annotations.names.empty() && !town.whole.annotations.names[before.id.value].empty();
        if (named) RC_ASSERT(cut.annotations.names[after.id.value] == town.whole.annotations.names[before.id.value]);
        if (!cut.annotations.sections.empty()) RC_ASSERT(cut.annotations.sections.parts[after.id.value].empty());
    }
}

RC_GTEST_PROP(Split, GivesEachSquareOneSectionAndASectionAtMostTwoSquares, ()) {
    const Town town = random_town();
    const DescribedMap cut = town.cut();
    std::map<std::pair<int, int>, std::uint32_t> section_at;
    for_each_cell(cut.map, [&](Cell c) {
        const ObstacleId id = cut.map.obstacle_at(c);
        if (id.value == 0 || !cut.map.obstacle(id).destructible) return;
        const auto [known, is_new] = section_at.emplace(square_of(c, town.lattice), id.value);
        RC_ASSERT(known->second == id.value);
    });
    for (const Obstacle& section : cut.map.obstacles()) {
        if (!section.destructible) continue;
        const Squares squares = squares_of(cut, section.id, town.lattice);
        if (squares.size() == 1) continue;
        RC_ASSERT(squares.size() == 2U);
        const auto& [first, cells] = *squares.begin();
        const auto& [second, more] = *squares.rbegin();
        RC_ASSERT(std::abs(first.first - second.first) + std::abs(first.second - second.second) == 1);
        RC_ASSERT(is_small(cells, town.lattice) || is_small(more, town.lattice));
    }
}

// A sliver stays alone only where all that it touches has a partner already.
RC_GTEST_PROP(Split, JoinsSliversWhereTheyTouchASquareWithoutPartner, ()) {
    const Town town = random_town();
    const DescribedMap cut = town.cut();
    const auto section_at = [&](Cell c) {
        const ObstacleId id = cut.map.grid().contains(c) ? cut.map.obstacle_at(c) : ObstacleId{};
        return id.value != 0 && cut.map.obstacle(id).destructible ? id : ObstacleId{};
    };
    const auto is_pair = [&](ObstacleId id) { return squares_of(cut, id, town.lattice).size() == 2; };
    for_each_cell(cut.map, [&](Cell c) {
        const ObstacleId here = section_at(c);
        if (here.value == 0 || !is_small(int(cut.map.obstacle(here).cells), town.lattice) || is_pair(here)) return;
        for (const Cell step : {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}}) {
            const ObstacleId there = section_at({c.x + step.x, c.y + step.y});
            RC_ASSERT(there.value == 0 || there == here || is_pair(there));
        }
    });
}

RC_GTEST_PROP(Split, KnowsOfWhatEachSectionIsAPart, ()) {
    const Town town = random_town();
    const DescribedMap cut = town.cut();
    for (const Obstacle& section : cut.map.obstacles()) {
        if (!section.destructible) continue;
        std::map<std::uint32_t, int> cells;  // by obstacle before
        for_each_cell(cut.map, [&](Cell c) {
            if (cut.map.obstacle_at(c) == section.id) ++cells[town.whole.map.obstacle_at(c).value];
        });
        const auto& parts = cut.annotations.sections.parts[section.id.value];
        RC_ASSERT(parts.size() == cells.size());
        int most = 0;
        for (const auto& [id, count] : cells) most = std::max(most, count);
        auto part = parts.begin();
        for (const auto& [id, count] : cells) {  // structures are in the order of the obstacles
            const Structure& structure = cut.annotations.sections.structures[*part++];
            const std::string name = town.whole.annotations.names.empty() ? "" : town.whole.annotations.names[id];
            const Obstacle& before = town.whole.map.obstacle({id});
            RC_ASSERT(structure == (Structure{town.whole.annotations.kinds[id], before.source_id, name}));
            if (!name.empty()) RC_ASSERT(cut.annotations.names[section.id.value].find(name) != std::string::npos);
            if (count < most) continue;
            RC_ASSERT(section.source_id == before.source_id);
            RC_ASSERT(cut.annotations.kinds[section.id.value] == structure.kind);
            most = INT_MAX;  // the first one among equals
        }
    }
}

// Who has a tag after the cut has a cell of somebody who had it before.
RC_GTEST_PROP(Split, GivesTagsToWhoHasAPartOfTheTagged, ()) {
    const Town town = random_town();
    const DescribedMap cut = town.cut();
    RC_ASSERT(cut.annotations.tags.size() == town.whole.annotations.tags.size());
    for (const auto& [tag, obstacles] : cut.annotations.tags) {
        std::set<ObstacleId> expected;
        for_each_cell(cut.map, [&, &whole = town.whole.annotations.tags.at(tag)](Cell c) {
            if (std::ranges::count(whole, town.whole.map.obstacle_at(c)) > 0) expected.insert(cut.map.obstacle_at(c));
        });
        RC_ASSERT(std::set<ObstacleId>(obstacles.begin(), obstacles.end()) == expected);
        RC_ASSERT(std::ranges::is_sorted(obstacles) && obstacles.size() == expected.size());
    }
}

RC_GTEST_PROP(Split, SharesWeightsAndBreachTimesByCells, ()) {
    const Town town = random_town();
    const DescribedMap cut = town.cut();
    const auto sums = [](const Map& map) {
        std::pair<double, double> sum;
        for (const Obstacle& o : map.obstacles()) {
            if (o.destructible) sum = {sum.first + o.weight, sum.second + o.breach_time};
        }
        return sum;
    };
    const auto before = town.whole.map.obstacles();
    const bool weighed =
        std::any_of(before.begin(), before.end(), [](const Obstacle& o) { return o.destructible && o.weight != 1; });
    if (weighed) RC_ASSERT(std::abs(sums(cut.map).first - sums(town.whole.map).first) < 1e-9);
    RC_ASSERT(std::abs(sums(cut.map).second - sums(town.whole.map).second) < 1e-9);
}

RC_GTEST_PROP(Split, MakesSectionsWeighOneWhereAllDoes, ()) {
    const DescribedMap cut = random_town(false).cut();
    for (const Obstacle& section : cut.map.obstacles()) RC_ASSERT(section.weight == 1);
}

RC_GTEST_PROP(Split, IsTheSameWhereverTheLatticeIsSaidToBegin, ()) {
    Town town = random_town();
    const DescribedMap once = town.cut();
    town.lattice.origin.x -= 3 * town.lattice.side;
    town.lattice.origin.y += 2 * town.lattice.side;
    const DescribedMap again = town.cut();
    RC_ASSERT(std::equal(once.map.labels().begin(), once.map.labels().end(), again.map.labels().begin()));
    RC_ASSERT(once.annotations.names == again.annotations.names);
    RC_ASSERT(once.annotations.sections == again.annotations.sections);
}

TEST(Split, CutsAlongTheLatticeAndJoinsSlivers) {
    const Map map = map_from_ascii(R"(
        aaaaaaaaaaaa.
        aaaaaaaaaaaa.
        aaaaaaaaaaaa.
        aaaaabbbbbbb.
        aaaaabbbbbb..
        ...........c.
        ...........c.
        ..d..........)");
    const DescribedMap cut = split(map, {}, {.side = 5});
    const auto at = [&](Cell c) { return cut.map.obstacle_at(c).value; };
    EXPECT_EQ(cut.map.obstacles().size(), 5U);
    EXPECT_EQ(at({4, 4}), 1U);
    EXPECT_EQ(at({5, 0}), 2U) << "a and b in one square are one section";
    EXPECT_EQ(at({9, 4}), 2U);
    EXPECT_EQ(at({11, 3}), 3U);
    EXPECT_EQ(at({11, 5}), 4U) << "two of 25 cells are no sliver";
    EXPECT_EQ(at({2, 7}), 5U) << "a sliver that touches nothing stays alone";
    EXPECT_EQ(cut.annotations.sections.parts[2], (std::vector<std::uint32_t>{0, 1}));
    const DescribedMap wider = split(map, {}, {.side = 8});
    EXPECT_EQ(wider.map.obstacles().size(), 2U);
    EXPECT_EQ(wider.map.obstacle_at({2, 7}), ObstacleId{1});
}

TEST(Split, JoinsASliverToWhatItTouchesMost) {
    const Map map = map_from_ascii(R"(
        aaaaaaaa.
        aaaaaaaa.
        aaaaaaaa.
        aaaaaaaa.
        aaaaaaaab
        aaaaaaaab
        aaaaaaaa.
        aaaaaaaa.)");
    const DescribedMap cut = split(map, {}, {.side = 8});
    EXPECT_EQ(cut.map.obstacles().size(), 1U);
    EXPECT_EQ(cut.annotations.sections.parts[1].size(), 2U);
}

TEST(Split, RefusesSquaresOfNoCell) {
    EXPECT_EQ(input_error([] { split(map_from_ascii("#."), {}, {.side = 0}); }),
              "a section needs a side of at least one cell");
}

TEST(Sections, AreCountedByWhatTheyArePartsOf) {
    const Sections sections{.structures = {{ObstacleKind::building, 1, "A"},
                                           {ObstacleKind::barrier, 2, ""},
                                           {ObstacleKind::building, 3, ""},
                                           {ObstacleKind::unknown, 4, ""}},
                            .parts = {{}, {0}, {0, 1}, {}, {0, 2}}};
    EXPECT_EQ(section_count(sections), 3U);
    EXPECT_EQ(structures_text(sections, cut_structures(sections)), "2 buildings, 1 barrier");
    EXPECT_EQ(sections_summary(sections), "3 sections of 2 buildings, 1 barrier");
    const std::vector<ObstacleId> some{{4}, {3}, {1}};
    EXPECT_EQ(structures_of(sections, some), (std::vector<std::uint32_t>{0, 2}));
    EXPECT_EQ(structures_text(sections, std::vector<std::uint32_t>{3}), "1 structure");
}

}  // namespace
}  // namespace waybreaker::site
