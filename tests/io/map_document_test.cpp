#include "io/map_document.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "input_error.hpp"
#include "io/plan_json.hpp"
#include "mapfile/map_info.hpp"
#include "mapfile/map_reader.hpp"
#include "project_folder.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::io {
namespace {

namespace fs = std::filesystem;

DocumentedMap documented(MapFile file) {
    MapPlace place{.georeference = mapfile::georeference_json(file), .frame_crs = mapfile::frame_crs(file)};
    return {.file = std::move(file), .connectivity = Connectivity::four, .place = std::move(place)};
}

DocumentedMap city(const std::string& name) {
    return documented(mapfile::read_map_file((project_folder() / "data" / name).string()));
}

std::string plan_on(const MapFile& map) {
    MissionDocument asked;
    asked.mission = ground_and_air({485, 101}, {425, 488});
    size_agents(asked, map);
    Planner planner;
    return plan_json(planner.plan(map.map, asked.mission, asked.method, asked.limits),
                     {.map = map, .asked = asked, .timing_fields = false});
}

std::string refusal(std::string document, const std::string& part, const std::string& instead) {
    const std::size_t at = document.find(part);
    if (at == std::string::npos) return "there is no " + part;
    document.replace(at, part.size(), instead);
    return input_error([&] { parse_map_document(document, "m.json"); });
}

TEST(MapDocument, HoldsAllThatIsKnownOfACity) {
    int cities = 0;
    for (const fs::directory_entry& file : fs::directory_iterator(project_folder() / "data")) {
        if (file.path().extension() != ".tif") continue;
        ++cities;
        const DocumentedMap map = documented(mapfile::read_map_file(file.path().string()));
        const std::string document = map_document("city", map);
        const DocumentedMap read = parse_map_document(document, "city.json");
        EXPECT_EQ(map_document("city", read), document) << file.path();
        EXPECT_EQ(read.file.annotations.tags, map.file.annotations.tags) << file.path();
        EXPECT_EQ(read.file.annotations.sections, map.file.annotations.sections) << file.path();
        EXPECT_EQ(read.file.has_metres(), map.file.has_metres()) << file.path();
    }
    EXPECT_GT(cities, 5);
}

TEST(MapDocument, PlansOnItEqualThoseOnTheFile) {
    const DocumentedMap map = city("berlin-mitte.tif");
    const DocumentedMap read = parse_map_document(map_document("berlin-mitte.tif", map), "city.json");
    EXPECT_EQ(plan_on(read.file), plan_on(map.file));
}

TEST(MapDocument, HoldsAMapThatIsOnlyCells) {
    MapFile file = mapfile::parse_map("type octile\nheight 2\nwidth 5\nmap\n.@.@@\n..@..\n", "m.map");
    const DocumentedMap read = parse_map_document(map_document("m.map", documented(file)), "m.json");
    EXPECT_EQ(std::vector(read.file.map.labels().begin(), read.file.map.labels().end()),
              std::vector(file.map.labels().begin(), file.map.labels().end()));
    EXPECT_FALSE(read.file.has_metres());
    EXPECT_EQ(read.file.digest, file.digest);
    file.cell_size_given = true;
    EXPECT_TRUE(parse_map_document(map_document("m.map", documented(file)), "m.json").file.has_metres());
}

TEST(MapDocument, SaysWhatIsWrong) {
    const std::string document =
        map_document("m.map", documented(mapfile::parse_map("type octile\nheight 1\nwidth 5\nmap\n.@.@@\n", "m.map")));
    EXPECT_NE(refusal(document, "waybreaker-map/1", "waybreaker-map/2").find("format is not waybreaker-map/1"),
              std::string::npos);
    const std::string runs = R"("runs":[0,1,1,1,0,1,2,2])";
    EXPECT_NE(refusal(document, runs, R"("runs":[0,1,1,1,0,1,2,3])").find("goes beyond the map"), std::string::npos);
    EXPECT_NE(refusal(document, runs, R"("runs":[0,1,1,1,0,1,2,1])").find("ends before the map does"),
              std::string::npos);
    EXPECT_NE(refusal(document, runs, R"("runs":[0,1,1,1,0,1,0,2])").find("does not describe all obstacles"),
              std::string::npos);
    EXPECT_NE(refusal(document, runs, R"("runs":[0,-1])").find("holds what is no number"), std::string::npos);
    EXPECT_NE(refusal(document, R"("width":5,"height":1,"obstacles")", R"("width":0,"height":1,"obstacles")")
                  .find("is not between 1 and"),
              std::string::npos);
    EXPECT_NE(refusal(document, R"("cell_size":1.0)", R"("cell_size":0.0)").find("is no side of a cell"),
              std::string::npos);
}

}  // namespace
}  // namespace waybreaker::io
