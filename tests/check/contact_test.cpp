// What an agent touches, compared with samples at many moments of its path and with the tests' own geometry.
#include "check/contact.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "model/timeline.hpp"
#include "project_folder.hpp"
#include "random_map.hpp"
#include "slow_sight.hpp"

namespace waybreaker::checker {
namespace {

Leg leg_between(Cell from, Cell to, double start, double end) {
    return {{2 * from.x, 2 * from.y}, {2 * to.x, 2 * to.y}, start, end};
}

// A way of moving for which slow_sight.hpp knows what it means.
Body body_of(std::int64_t radius) {
    if (radius == 0) return {.corners = Corners::squeeze};
    return {.radius = double(radius) / 1000};
}

// Room between the agent's middle and the obstacle's nearest cell, less the radius.
double room(const PlainMap& map, std::uint32_t obstacle, Point at, std::int64_t radius) {
    double least = 1e9;
    for (const Cell c : map.cells()) {
        if (map.at(c) != obstacle) continue;
        const double x = std::abs(at.x - c.x) - 0.5;
        const double y = std::abs(at.y - c.y) - 0.5;
        least = std::min(least, radius == 0 ? std::max(x, y) : std::hypot(std::max(x, 0.0), std::max(y, 0.0)));
    }
    return least - double(radius) / 1000;
}

RC_GTEST_PROP(Contact, IsWhatItLooksLike, ()) {
    const Map map((*random_map(14, 14)).grid());
    const PlainMap labels = plain(map);
    const std::int64_t radius = *rc::gen::element(0, 500, 501, 750, 2000);
    const Leg leg = leg_between(any_cell(labels), any_cell(labels), 3, 8);
    std::map<std::uint32_t, Contact> met;
    for (const Contact& contact : contacts(map, leg, radius)) {
        RC_ASSERT(met.emplace(contact.obstacle.value, contact).second);
    }
    constexpr double hair = 1e-7;
    for (const Obstacle& obstacle : map.obstacles()) {
        const auto contact = met.find(obstacle.id.value);
        const bool is_met = contact != met.end();
        if (is_met) {
            RC_ASSERT(contact->second.time >= leg.start && contact->second.time <= leg.end);
            RC_ASSERT(room(labels, obstacle.id.value, contact->second.place, radius) < hair);
            const double share = (contact->second.time - leg.start) / (leg.end - leg.start);
            RC_ASSERT(distance(leg.place(share), contact->second.place) < hair);
        }
        for (int i = 0; i <= 100; ++i) {
            const double share = i / 100.0;
            if (is_met && leg.time(share) >= contact->second.time - hair) break;
            RC_ASSERT(room(labels, obstacle.id.value, leg.place(share), radius) > -hair);
        }
    }
}

// Exactly what is in the way by the tests' own line of sight, which is in integers as well.
RC_GTEST_PROP(Contact, IsWhatHidesTheView, ()) {
    const Map map((*random_map(20, 20)).grid());
    const PlainMap labels = plain(map);
    const std::int64_t radius = *rc::gen::element(0, 500, 501, 750, 2000);
    const Cell from = any_cell(labels);
    const Cell to = any_cell(labels);
    const Leg leg = leg_between(from, to, 0, 1);
    // A plain map knows one kind of blocked cell: a frame, so that its outside is far away.
    PlainMap framed{map.width() + 10, map.height() + 10, {}};
    framed.obstacles.resize(std::size_t(framed.width) * std::size_t(framed.height), 0);
    for (const Cell c : labels.cells()) framed.obstacles[framed.index({c.x + 5, c.y + 5})] = labels.at(c);
    const bool sees = slow::sees(framed, {from.x + 5, from.y + 5}, {to.x + 5, to.y + 5}, body_of(radius));
    RC_ASSERT(contacts(map, leg, radius).empty() == sees);
}

// Cell centres in any order; for points also corners of cells, often along rows and columns.
std::vector<Point> any_path(const PlainMap& map, std::int64_t radius) {
    const bool corners = radius == 0 && *rc::gen::arbitrary<bool>();
    std::vector<Point> path;
    for (int i = 0; i < 4; ++i) {
        Point p = any_cell(map);
        if (corners) p = {p.x + 0.5, p.y - 0.5};
        if (i > 0 && *rc::gen::arbitrary<bool>()) p.x = path.back().x;
        if (i > 0 && *rc::gen::arbitrary<bool>()) p.y = path.back().y;
        path.push_back(p);
    }
    return path;
}

// The planner's own idea of it, over several legs.
RC_GTEST_PROP(Contact, IsWhenThePlannerThinks, ()) {
    const Map map((*random_map(40, 40)).grid());
    RC_PRE(!map.obstacles().empty());
    const std::int64_t radius = *rc::gen::element(0, 0, 500, 501, 750, 2000);
    const ObstacleId obstacle{std::uint32_t(*number(1, int(map.obstacles().size())))};
    const std::vector<Point> path = any_path(plain(map), radius);
    const std::vector<Waypoint> points = timed(path, 2);
    double first = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < points.size(); ++i) {
        const auto vertex = [](Point p) { return Vertex{std::llround(2 * p.x), std::llround(2 * p.y)}; };
        const Leg leg{vertex(path[i - 1]), vertex(path[i]), points[i - 1].t, points[i].t};
        for (const Contact& contact : contacts(map, leg, radius)) {
            if (contact.obstacle == obstacle) first = std::min(first, contact.time);
        }
        for (const Passage& passage : side_passages(map, leg)) {
            if (passage.first == obstacle || passage.second == obstacle) first = std::min(first, passage.time);
        }
    }
    const std::optional<double> planned = first_touch(map, obstacle, points, double(radius) / 1000);
    RC_ASSERT(planned.has_value() == std::isfinite(first));
    if (planned) RC_ASSERT(std::abs(first - *planned) < 1e-7);
}

// Past a corner at exactly half a cell, thousands of cells away from both ends; and a thousandth of a cell nearer.
TEST(Contact, IsExactFarAway) {
    const Leg leg = leg_between({0, 0}, {8099, 180}, 0, 1);  // 8101 long
    Grid grid(8192, 200);
    grid.set_blocked({4095, 90}, true);  // its corner (4094.5, 90.5) lies |180 x - 8099 y| / 8101 = 0.5 from the line
    const Map map(std::move(grid));
    EXPECT_TRUE(contacts(map, leg, 500).empty());
    EXPECT_EQ(contacts(map, leg, 501).size(), 1U);
}

// The judge uses the public map and plan, and nothing of how planners see them.
TEST(Judge, SharesNoGeometryWithThePlanner) {
    const std::set<std::string> allowed{"waybreaker/check.hpp", "waybreaker/error.hpp", "waybreaker/map.hpp",
                                        "waybreaker/mission.hpp", "waybreaker/plan.hpp"};
    const std::vector<std::string> forbidden{"line_of_sight(", "fits(",  ".boundary(", "first_touch(",
                                             "path_length(",   "timed(", " distance(", "OpenedMap"};
    int files = 0;
    for (const auto& file : std::filesystem::directory_iterator(project_folder() / "src" / "check")) {
        std::ifstream text(file.path());
        for (std::string line; std::getline(text, line);) {
            for (const std::string& use : forbidden) EXPECT_EQ(line.find(use), std::string::npos) << line;
            const std::string include = "#include \"";
            if (!line.starts_with(include)) continue;
            const std::string header = line.substr(include.size(), line.size() - include.size() - 1);
            EXPECT_TRUE(allowed.contains(header) || header.starts_with("check/")) << file.path() << " uses " << header;
        }
        ++files;
    }
    EXPECT_GE(files, 6);
}

}  // namespace
}  // namespace waybreaker::checker
