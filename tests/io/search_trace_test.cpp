// Search traces: what the Posthoc visualiser needs to draw a search and the way back from every cell of it.
#include "io/search_trace.hpp"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "ascii_map.hpp"
#include "waybreaker/advanced/search.hpp"

namespace waybreaker::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view picture = R"(
    S.......
    .######.
    ......#.
    ..#...#.
    ......#G)";

struct Traced {
    SearchResult result;
    Json trace;
};

Traced traced(std::string_view map_picture, Algorithm planner) {
    const Map map = map_from_ascii(map_picture);
    const OpenedMap closed(map);
    const Cell start = mark_in_ascii(map_picture, 'S');
    const Cell goal = mark_in_ascii(map_picture, 'G');
    SearchTrace listener(closed, start, goal);
    SearchOptions options;
    options.planner = planner;
    options.listener = &listener;
    SearchResult result = Searcher().find(closed, start, goal, options);
    return {std::move(result), Json::parse(listener.text())};
}

std::vector<std::string> types(const Json& trace) {
    std::vector<std::string> found;
    for (const Json& event : trace["events"]) found.push_back(event["type"]);
    return found;
}

TEST(SearchTrace, IsWhatTheFormatAsksFor) {
    const Json trace = traced(picture, Algorithm::theta).trace;
    EXPECT_EQ(trace["version"], "1.4.0");
    EXPECT_EQ(trace["views"]["main"][0]["$"], "rect");
    EXPECT_TRUE(trace["pivot"].contains("x"));
    std::map<Json, std::pair<int, int>> cell_of;
    for (const Json& event : trace["events"]) {
        // An id is a cell, a cell an id, and 0 is neither: the visualiser takes it for "no parent".
        EXPECT_GT(event["id"], 0);
        const std::pair<int, int> at{event["x"], event["y"]};
        EXPECT_EQ(cell_of.emplace(event["id"], at).first->second, at);
    }
}

TEST(SearchTrace, OfAStepIsWrittenOut) {
    const std::vector<std::string> lines{
        R"({"type": "source", "id": 1, "x": 0, "y": 0})",
        R"({"type": "destination", "id": 2, "x": 1, "y": 0})",
        R"({"type": "generating", "id": 1, "x": 0, "y": 0, "pId": null, "g": 0, "f": 1})",
        R"({"type": "expanding", "id": 1, "x": 0, "y": 0, "pId": null, "g": 0, "f": 1})",
        R"({"type": "generating", "id": 2, "x": 1, "y": 0, "pId": 1, "g": 1, "f": 1})",
        R"({"type": "closing", "id": 1, "x": 0, "y": 0, "pId": null, "g": 0, "f": 1})",
        R"({"type": "expanding", "id": 2, "x": 1, "y": 0, "pId": 1, "g": 1, "f": 1})",
        R"({"type": "end", "id": 2, "x": 1, "y": 0, "pId": 1, "g": 1, "f": 1})",
    };
    const Json trace = traced("SG", Algorithm::astar).trace;
    ASSERT_EQ(trace["events"].size(), lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_EQ(trace["events"][i], Json::parse(lines[i])) << lines[i];
}

TEST(SearchTrace, AgreesWithTheSearch) {
    for (const Algorithm planner : {Algorithm::theta, Algorithm::lazy_theta, Algorithm::astar, Algorithm::jps}) {
        const auto [result, trace] = traced(picture, planner);
        ASSERT_EQ(result.status, SearchStatus::found);
        std::map<std::string, std::uint64_t> count;
        for (const std::string& type : types(trace)) ++count[type];
        EXPECT_EQ(count["expanding"], result.expanded);
        EXPECT_EQ(count["generating"], result.generated);
        EXPECT_EQ(count["closing"], result.expanded - 1);
        EXPECT_EQ(count["end"], 1U);
        EXPECT_EQ(types(trace).back(), "end");
        EXPECT_DOUBLE_EQ(trace["events"].back()["g"], result.length);
    }
}

// Every parent was generated before its child, so that the way back to the start can be drawn at any step.
TEST(SearchTrace, LeadsBackFromEveryCell) {
    for (const Algorithm planner : {Algorithm::theta, Algorithm::lazy_theta, Algorithm::astar, Algorithm::jps}) {
        const Json trace = traced(picture, planner).trace;
        std::set<Json> seen;
        for (const Json& event : trace["events"]) {
            if (!event.contains("pId")) continue;
            if (!event["pId"].is_null()) {
                EXPECT_TRUE(seen.contains(event["pId"])) << event;
            }
            seen.insert(event["id"]);
        }
    }
}

TEST(SearchTrace, EndsWithAClosedCellWhereThereIsNoPath) {
    const auto [result, trace] = traced("S.#G", Algorithm::theta);
    EXPECT_EQ(result.status, SearchStatus::no_path);
    EXPECT_EQ(types(trace).back(), "closing");
}

}  // namespace
}  // namespace waybreaker::io
