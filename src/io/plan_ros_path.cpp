#include "io/plan_ros_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "io/map_frame.hpp"
#include "io/shortest_text.hpp"

namespace waybreaker::io {
namespace {

// To a millionth, which is enough for metres and quaternions; always with a decimal point, as ROS asks of a float.
std::string real(double value) {
    constexpr double millionths = 1e6;
    const std::string text = shortest_text(std::round(value * millionths) / millionths + 0.0);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string header(double seconds, const std::string& indent) {
    constexpr double last = 2147483647;  // what ROS counts to
    const auto all = std::int64_t(std::clamp(seconds, 0.0, last) * 1e9);
    const std::int64_t second = 1000000000;
    return "header:\n" + indent + "  stamp: {sec: " + std::to_string(all / second) +
           ", nanosec: " + std::to_string(all % second) + "}\n" + indent + "  frame_id: map\n";
}

// The direction from each point to the next one elsewhere; at the end, that it came in.
std::vector<double> headings(const std::vector<Point>& points) {
    std::vector<double> result(points.size(), 0);
    for (std::size_t i = points.size(); i-- > 0;) {
        const bool moves = i + 1 < points.size() && (points[i + 1].x != points[i].x || points[i + 1].y != points[i].y);
        if (moves) {
            result[i] = std::atan2(points[i + 1].y - points[i].y, points[i + 1].x - points[i].x);
        } else if (i + 1 < points.size()) {
            result[i] = result[i + 1];
        }
    }
    std::size_t last = points.size();
    while (last > 1 && points[last - 1].x == points.back().x && points[last - 1].y == points.back().y) --last;
    for (std::size_t i = last; last > 0 && i < points.size(); ++i) result[i] = result[last - 1];
    return result;
}

std::string path_text(const AgentPlan& agent, const MapFrame& frame) {
    std::vector<Point> points;
    for (const Waypoint& point : agent.path) points.push_back(frame.metres({point.x, point.y}));
    const std::vector<double> yaw = headings(points);
    std::string text = "# " + agent.id + "\n" + header(0, "") + "poses:\n";
    for (std::size_t i = 0; i < points.size(); ++i) {
        text += "- " + header(agent.path[i].t, "  ") + "  pose:\n    position: {x: " + real(points[i].x) +
                ", y: " + real(points[i].y) +
                ", z: 0.0}\n    orientation: {x: 0.0, y: 0.0, z: " + real(std::sin(yaw[i] / 2)) +
                ", w: " + real(std::cos(yaw[i] / 2)) + "}\n";
    }
    return text;
}

}  // namespace

std::string plan_ros_path(const Plan& plan, const MapFile& map) {
    const MapFrame frame(map);
    std::string text;
    for (const AgentKind kind : {AgentKind::ground, AgentKind::air}) {
        for (const AgentPlan& agent : plan.agents) {
            if (agent.kind == kind) text += (text.empty() ? "" : "---\n") + path_text(agent, frame);
        }
    }
    return text;
}

}  // namespace waybreaker::io
