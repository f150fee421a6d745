// What an overlay does to each cell, and that it does nothing to others.
#include "site/overlay.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <string>
#include <tuple>

#include "ascii_map.hpp"
#include "input_error.hpp"
#include "site/random_layer.hpp"

namespace waybreaker::site {
namespace {

// All that is known of the obstacle on a cell; numbers change.
using Identity = std::tuple<bool, std::string, ObstacleKind, bool, std::int64_t, double, double, std::set<std::string>>;

Identity identity(const DescribedMap& town, Cell cell) {
    const ObstacleId id = town.map.obstacle_at(cell);
    if (!id) return {};
    const Annotations& known = town.annotations;
    std::set<std::string> tags;
    for (const auto& [tag, ids] : known.tags) {
        if (std::ranges::count(ids, id) > 0) tags.insert(tag);
    }
    const Obstacle& obstacle = town.map.obstacle(id);
    return {true,
            std::string(known.name_of(id)),
            kind_of(known.kinds, id),
            obstacle.destructible,
            obstacle.source_id,
            obstacle.weight,
            obstacle.breach_time,
            tags};
}

std::size_t index(const Map& map, Cell cell) {
    return std::size_t(cell.y) * std::size_t(map.width()) + std::size_t(cell.x);
}

struct Scene {
    DescribedMap town;
    Overlay overlay;
    DescribedMap after() const { return laid_over(town.map, town.annotations, overlay); }
    bool covers(Cell cell) const { return overlay.things.labels[index(town.map, cell)] != 0; }
};

// Some free cells are those of bridges.
Scene random_scene() {
    Scene scene{described(random_layer(true)), {.name = "flood", .use = OverlayUse(*number(0, 4))}};
    const Map& map = scene.town.map;
    for_each_cell(map, [&](Cell cell) {
        if (!map.grid().blocked(cell) && !mostly()) scene.town.annotations.bridges.push_back({cell, 1});
    });
    LabelLayer things = random_layer(true);
    LabelLayer& over = scene.overlay.things;
    over = {.width = map.width(), .height = map.height(), .attributes = things.attributes, .names = things.names};
    over.labels.assign(map.labels().size(), 0);
    for_each_cell(map, [&](Cell cell) {
        if (cell.x >= things.width || cell.y >= things.height) return;
        const std::size_t at = std::size_t(cell.y) * std::size_t(things.width) + std::size_t(cell.x);
        over.labels[index(map, cell)] = things.labels[at];
    });
    return scene;
}

RC_GTEST_PROP(Overlays, of_nothing_change_nothing, ()) {
    Scene scene = random_scene();
    scene.town.annotations.title = "Town";
    std::ranges::fill(scene.overlay.things.labels, 0U);
    const DescribedMap after = scene.after();
    RC_ASSERT(std::ranges::equal(after.map.labels(), scene.town.map.labels()));
    RC_ASSERT(after.annotations.title == "Town");
    for_each_cell(after.map, [&](Cell cell) { RC_ASSERT(identity(after, cell) == identity(scene.town, cell)); });
}

RC_GTEST_PROP(Overlays, leave_other_cells_to_who_has_them, ()) {
    const Scene scene = random_scene();
    const DescribedMap after = scene.after();
    for_each_cell(after.map, [&](Cell cell) {
        if (!scene.covers(cell)) RC_ASSERT(identity(after, cell) == identity(scene.town, cell));
    });
    RC_ASSERT(after.annotations.bridges == scene.town.annotations.bridges);
}

RC_GTEST_PROP(Overlays, take_what_is_theirs_to_take, ()) {
    const Scene scene = random_scene();
    const DescribedMap after = scene.after();
    std::set<Cell> bridges;
    for (const CellRun& run : scene.town.annotations.bridges) bridges.insert(run.first);
    for_each_cell(after.map, [&](Cell cell) {
        if (!scene.covers(cell)) return;
        const ObstacleId before = scene.town.map.obstacle_at(cell);
        const OverlayUse use = scene.overlay.use;
        if (use == OverlayUse::free) return RC_ASSERT(!after.map.grid().blocked(cell));
        const bool on_open_ground = use == OverlayUse::debris || use == OverlayUse::wall;
        const bool stays = (before && (on_open_ground || !scene.town.map.obstacle(before).destructible)) ||
                           (use == OverlayUse::water && bridges.contains(cell));
        if (stays) return RC_ASSERT(identity(after, cell) == identity(scene.town, cell));
        const std::uint32_t thing = scene.overlay.things.labels[index(after.map, cell)];
        const ObstacleAttributes& given = scene.overlay.things.attributes[thing];
        const auto name = scene.overlay.things.names.find(thing);
        const auto [blocked, called, kind, destructible, source, weight, time, tags] = identity(after, cell);
        RC_ASSERT(blocked && destructible == on_open_ground);
        RC_ASSERT(called == (name == scene.overlay.things.names.end() ? "" : name->second));
        RC_ASSERT(kind == (use == OverlayUse::water    ? ObstacleKind::water
                           : use == OverlayUse::closed ? ObstacleKind::forbidden
                                                       : ObstacleKind::barrier));
        RC_ASSERT(source == given.source_id && weight == given.weight && time == given.breach_time);
        const std::string tag = use == OverlayUse::wall ? "barrier=wall" : "barrier=debris";
        RC_ASSERT(tags == (on_open_ground ? std::set<std::string>{tag} : std::set<std::string>()));
    });
}

// Cells that a flood took are free after it has been laid free.
RC_GTEST_PROP(Overlays, lie_on_those_before_them, ()) {
    Scene scene = random_scene();
    scene.town = scene.after();
    scene.overlay.use = OverlayUse::free;
    const DescribedMap after = scene.after();
    for_each_cell(after.map, [&](Cell cell) {
        if (scene.covers(cell)) RC_ASSERT(!after.map.grid().blocked(cell));
    });
}

TEST(Overlays, OfASectionLeaveItsPartsAndName) {
    const Map map = map_from_ascii(R"(
        ..aabb
        ..aabb)");
    Annotations known;
    known.title = "Town";
    known.names = {"", "Mill", "Barn"};
    known.sections = {{{ObstacleKind::building, 7, "Mill"}, {ObstacleKind::building, 8, "Barn"}}, {{}, {0}, {1}}};
    Overlay flood{.name = "rain",
                  .use = OverlayUse::water,
                  .things = {.width = 6, .height = 2, .labels = {0, 9, 9, 0, 0, 0, 0, 9, 0, 0, 0, 0}}};
    flood.things.attributes.resize(10);
    const DescribedMap after = laid_over(map, known, flood);
    EXPECT_EQ(after.map.obstacles().size(), 3U);
    EXPECT_EQ(after.annotations.title, "Town, rain as water");
    const ObstacleId mill = after.map.obstacle_at({3, 0});
    EXPECT_EQ(after.annotations.name_of(mill), "Mill");
    EXPECT_EQ(after.map.obstacle(mill).cells, 3U);
    ASSERT_EQ(after.annotations.sections.parts.size(), 4U);
    EXPECT_EQ(after.annotations.sections.parts[mill.value], std::vector<std::uint32_t>{0});
    EXPECT_TRUE(after.annotations.sections.parts[after.map.obstacle_at({1, 0}).value].empty());
}

TEST(Overlays, DoubtFloodsOnMapsWithoutBridges) {
    const auto doubts = [](OverlayUse use, std::uint32_t label, const Annotations& known) {
        return !doubt(known, {.use = use, .things = {.labels = {0, label}}}).empty();
    };
    EXPECT_TRUE(doubts(OverlayUse::water, 1, {}));
    EXPECT_FALSE(doubts(OverlayUse::water, 0, {}));
    EXPECT_FALSE(doubts(OverlayUse::closed, 1, {}));
    Annotations known;
    known.bridges = {{{0, 0}, 1}};
    EXPECT_FALSE(doubts(OverlayUse::water, 1, known));
}

TEST(Overlays, AreOfTheMapsSize) {
    const Map map = map_from_ascii("..");
    EXPECT_THROW(laid_over(map, {}, {.things = {.width = 1, .height = 2, .labels = {0, 0}}}), InputError);
}

}  // namespace
}  // namespace waybreaker::site
