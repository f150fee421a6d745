#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "geotiff/label_tiff.hpp"
#include "input_error.hpp"
#include "live_server.hpp"
#include "mapfile/map_reader.hpp"
#include "service/built_in_maps.hpp"
#include "service/edited_map.hpp"

namespace waybreaker::service {
namespace {

using request::CellRun;
using request::MapEdits;
using request::parse_map_edits;

StoredMap stored(std::string bytes, Connectivity connectivity = Connectivity::four) {
    io::MapFile file = mapfile::parse_map(bytes, "the map", connectivity);
    return {.file = std::move(file), .connectivity = connectivity, .bytes = std::move(bytes)};
}

StoredMap movingai(const std::string& rows, Connectivity connectivity = Connectivity::four) {
    const std::size_t width = rows.find('\n');
    const std::size_t height = rows.size() / (width + 1);
    return stored(
        "type octile\nheight " + std::to_string(height) + "\nwidth " + std::to_string(width) + "\nmap\n" + rows,
        connectivity);
}

// A map of labels: a letter for each, dots are free. 'a' is called Alpha, 'b' is not to be destroyed.
StoredMap labelled(const std::string& rows) {
    const int width = int(rows.find('\n'));
    std::vector<std::uint32_t> labels;
    for (const char c : rows) {
        if (c != '\n') labels.push_back(c == '.' ? 0 : std::uint32_t(c - 'a' + 1));
    }
    std::vector<ObstacleAttributes> attributes(27);
    for (std::size_t i = 1; i < attributes.size(); ++i) attributes[i].source_id = std::int64_t(i) * 100;
    attributes[2].destructible = false;
    const int height = int(labels.size()) / width;
    const std::string utm = stored(std::string(berlin_mitte_tif())).file.georeference.value().crs;
    geotiff::LabelTiff tiff{.map = Map::from_labels(width, height, labels, attributes),
                            .cell_size = 2.5,
                            .georeference = site::Georeference{utm, {500000, 2.5, 0, 5800000, 0, -2.5}},
                            .annotations = {.title = "Town"}};
    tiff.annotations.names.resize(tiff.map.obstacles().size() + 1);
    for (const Obstacle& o : tiff.map.obstacles()) {
        if (o.source_id == 100) tiff.annotations.names[o.id.value] = "Alpha";
    }
    return stored(geotiff::label_tiff_bytes(tiff));
}

// Obstacles by the last letter of their source ids, those without as digits in the order of their ids.
std::string picture(const Map& map) {
    std::string text;
    std::vector<char> drawn(map.obstacles().size() + 1, '.');
    char next = '1';
    for (const Obstacle& o : map.obstacles()) {
        drawn[o.id.value] = o.source_id == 0 ? next++ : char('a' + o.source_id / 100 - 1);
    }
    for (Cell c; c.y < map.height(); ++c.y) {
        for (c.x = 0; c.x < map.width(); ++c.x) text += drawn[map.obstacle_at(c).value];
        text += '\n';
    }
    return text;
}

std::string after(const StoredMap& map, const std::string& edits) {
    return picture(edited_map(map, parse_map_edits(edits)).file.map);
}

TEST(MapEdits, ConnectedObstaclesMergeAndFallApart) {
    const StoredMap map = movingai(
        "1....\n"
        "1.1..\n"
        "..1..\n");
    EXPECT_EQ(after(map, R"({"block": [[1, 1, 1]]})"),
              "1....\n"
              "111..\n"
              "..1..\n");
    EXPECT_EQ(after(map, R"({"free": [[0, 0, 1], [2, 1, 2]], "block": [[4, 0, 1]]})"),
              "....1\n"
              "2....\n"
              "..3..\n");
    EXPECT_TRUE(edited_map(map, {}).bytes.starts_with("type octile"));
    const std::string corner = "1.\n.1\n";
    EXPECT_EQ(after(movingai(corner), "{}"), "1.\n.2\n");
    EXPECT_EQ(after(movingai(corner, Connectivity::eight), "{}"), corner);
}

TEST(MapEdits, LabelsStayAndWallsStandBesideThem) {
    const StoredMap map = labelled(
        "aa..b\n"
        "a...b\n"
        ".....\n");
    EXPECT_EQ(after(map, R"({"block": [[0, 0, 4], [3, 2, 2], [0, 2, 1]]})"),
              "aa11b\n"
              "a...b\n"
              "2..33\n");
    // Freed first: so what is drawn again is a wall.
    const StoredMap edited =
        edited_map(map, parse_map_edits(R"({"free": [[0, 0, 2], [4, 0, 1]], "block": [[1, 0, 1], [1, 1, 1]]})"));
    EXPECT_EQ(picture(edited.file.map),
              ".1...\n"
              "a1..b\n"
              ".....\n");
    EXPECT_EQ(edited.file.annotations.name_of({2}), "Alpha");
    EXPECT_EQ(edited.file.annotations.name_of({1}), "");
    EXPECT_FALSE(edited.file.map.obstacle({3}).destructible);
    EXPECT_TRUE(edited.file.map.obstacle({1}).destructible);
    EXPECT_EQ(edited.file.cell_size, 2.5);
    EXPECT_EQ(edited.file.annotations.title, "Town");
    ASSERT_TRUE(edited.file.georeference);
    EXPECT_EQ(edited.file.georeference->transform, map.file.georeference->transform);
}

TEST(MapEdits, WhatTheFileCannotHoldStays) {
    const StoredMap task = stored(
        "<root><map><width>2</width><height>1</height><cellsize>1</cellsize><startx>0</startx><starty>0</starty>"
        "<finishx>1</finishx><finishy>0</finishy><grid><row>0 0</row></grid></map></root>");
    const StoredMap edited = edited_map(task, {});
    ASSERT_TRUE(edited.file.task);
    EXPECT_EQ(edited.file.task->goal, (Cell{1, 0}));
}

TEST(MapEdits, TheBuiltInMapKeepsItsNamesAndBackground) {
    const StoredMap city = stored(std::string(berlin_mitte_tif()));
    const StoredMap edited = edited_map(city, {});
    EXPECT_TRUE(
        std::equal(city.file.map.labels().begin(), city.file.map.labels().end(), edited.file.map.labels().begin()));
    EXPECT_EQ(edited.file.annotations.names, city.file.annotations.names);
    EXPECT_EQ(edited.file.annotations.background.features.size(), city.file.annotations.background.features.size());
    EXPECT_EQ(edited_map(city, {}).bytes, edited.bytes);
}

TEST(MapEdits, SaysWhatIsWrong) {
    const auto refusal = [](const std::string& edits) {
        return input_error([&] { edited_map(movingai("...\n...\n"), parse_map_edits(edits)); });
    };
    EXPECT_EQ(refusal("{}"), "");
    EXPECT_EQ(refusal(R"({"block": [[0, 0]]})"), "edits:1:12: block[0] is not a run of cells, [x, y, length]");
    EXPECT_EQ(refusal(R"({"block": [[0, 1, 3]], "free": [[1, 0, 2], [1, 0, 3]]})"),
              "edits: free[1] does not lie on the map");
    EXPECT_EQ(refusal(R"({"free": [[0, 2, 1]]})"), "edits: free[0] does not lie on the map");
    EXPECT_EQ(refusal(R"({"free": [[0, 0, 3], [0, 0, 3], [0, 0, 1]]})"), "edits: free has more cells than the map");
    EXPECT_EQ(refusal(R"({"free": [[-1, 0, 1]]})"), "edits:1:12: free[0][0] is not between 0 and 2147483647");
    EXPECT_NE(refusal(R"({"walls": []})"), "");
}

// Cell by cell: what is blocked afterwards, and whose it is.
RC_GTEST_PROP(MapEditsLaws, DoWhatIsSaidOfEachCell, ()) {
    constexpr int side = 8;
    const auto run = rc::gen::exec([] {
        const int x = *rc::gen::inRange(0, side);
        return CellRun{{x, *rc::gen::inRange(0, side)}, *rc::gen::inRange(1, side - x + 1)};
    });
    std::string rows;
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) rows += "...abc"[*rc::gen::inRange(0, 6)];
        rows += '\n';
    }
    rows[0] = 'a';
    const StoredMap map = labelled(rows);
    const MapEdits edits{.block = *rc::gen::container<std::vector<CellRun>>(3, run),
                         .free = *rc::gen::container<std::vector<CellRun>>(3, run)};
    const Map result = edited_map(map, edits).file.map;
    const auto covers = [](const std::vector<CellRun>& runs, Cell c) {
        return std::any_of(runs.begin(), runs.end(), [c](const CellRun& r) {
            return r.first.y == c.y && r.first.x <= c.x && c.x < r.first.x + r.length;
        });
    };
    for (Cell c; c.y < side; ++c.y) {
        for (c.x = 0; c.x < side; ++c.x) {
            const ObstacleId before = map.file.map.obstacle_at(c);
            const ObstacleId now = result.obstacle_at(c);
            const bool stays = before.value != 0 && !covers(edits.free, c);
            RC_ASSERT((now.value != 0) == (stays || covers(edits.block, c)));
            if (now.value == 0) continue;
            const std::int64_t source = result.obstacle(now).source_id;
            RC_ASSERT(source == (stays ? map.file.map.obstacle(before).source_id : 0));
        }
    }
}

class MapEditsServiceTest : public LiveServer {};

TEST_F(MapEditsServiceTest, MakesMapsAsThoughTheyHadBeenSent) {
    begin();
    const std::string city = "/api/v1/maps/berlin-mitte.tif";
    const Json edits = Json::parse(R"({"block": [[256, 433, 5]]})");
    const Json map = post_json(city + "/edits", edits, 201);
    EXPECT_EQ(post_json(city + "/edits", edits), map);
    const std::string location = "/api/v1/maps/" + map["id"].get<std::string>();
    EXPECT_EQ(get_json(location), map);
    EXPECT_EQ(map["attribution"], get_json(city)["attribution"]);
    EXPECT_GT(get_json(location)["blocked"], get_json(city)["blocked"]);
    // A plan made on it holds on its file.
    const Json mission = Json::parse(R"({"mission": {"start": [256, 434], "goal": [118, 55]}})");
    const Json plan = post_json(location + "/plan", mission);
    const std::string sent = post(maps, get(location + "/file").body, octets).body;
    EXPECT_EQ(Json::parse(sent)["id"], map["id"]);
    EXPECT_EQ(post_json(location + "/check", plan)["valid"], true);
    EXPECT_EQ(plan["map"]["digest"], map["digest"]);
}

}  // namespace
}  // namespace waybreaker::service
