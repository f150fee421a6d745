#include "io/plan_ros_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <vector>

#include "io/map_frame.hpp"
#include "io/path_parts.hpp"
#include "io/shortest_text.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::io {
namespace {

constexpr double most_poses = 1e6;
constexpr double last_second = 2147483647;  // that a stamp can say

// A point of the path, in metres.
struct Pose {
    Point at;
    double t = 0;  // seconds
    double yaw = 0;
};

// Always with a decimal point and never with an exponent: YAML 1.1 takes 1 for a whole number and 1e-06 for a text.
std::string real(double value, int digits) {
    std::string text = fmt::format("{:.{}f}", value, digits);
    text.erase(std::max(text.find_last_not_of('0'), text.find('.') + 1) + 1);
    return text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos ? text.substr(1) : text;
}

std::string header(double seconds) {
    constexpr std::int64_t second = 1000000000;
    const std::int64_t all = std::llround(seconds * double(second));
    return fmt::format("header: {{stamp: {{sec: {}, nanosec: {}}}, frame_id: map}}", all / second, all % second);
}

std::string pose_text(const Pose& pose) {
    constexpr int micrometres = 6;
    constexpr int of_a_quaternion = 9;
    return fmt::format(
        "{{{}, pose: {{position: {{x: {}, y: {}, z: 0.0}}, orientation: {{x: 0.0, y: 0.0, z: {}, w: {}}}}}}}",
        header(pose.t), real(pose.at.x, micrometres), real(pose.at.y, micrometres),
        real(std::sin(pose.yaw / 2), of_a_quaternion), real(std::cos(pose.yaw / 2), of_a_quaternion));
}

// Points each pose towards the next position; the poses at the end keep the last direction.
void turn(std::vector<Pose>& poses) {
    const auto last_move =
        std::adjacent_find(poses.rbegin(), poses.rend(), [](const Pose& b, const Pose& a) { return a.at != b.at; });
    if (last_move == poses.rend()) return;
    const auto direction = [](const Pose& a, const Pose& b) { return std::atan2(b.at.y - a.at.y, b.at.x - a.at.x); };
    double yaw = direction(*(last_move + 1), *last_move);
    for (std::size_t i = poses.size(); i-- > 0;) {
        if (i + 1 < poses.size() && poses[i].at != poses[i + 1].at) yaw = direction(poses[i], poses[i + 1]);
        poses[i].yaw = yaw;
    }
}

// The corners of the path. Points at one place and time, such as a start at which a breach takes no time, are one
// pose: two would look like a wait.
std::vector<Pose> corners_of(std::span<const Waypoint> path, const MapFrame& frame) {
    constexpr double nanosecond = 1e-9;
    std::vector<Pose> corners;
    for (const Waypoint& point : path) {
        const Pose pose{frame.metres({point.x, point.y}), point.t};
        const bool known = !corners.empty() && corners.back().at == pose.at && pose.t - corners.back().t < nanosecond;
        if (!known) corners.push_back(pose);
    }
    turn(corners);
    return corners;
}

double pieces_between(const Pose& a, const Pose& b, double step) {
    constexpr double slack = 1e-9;  // of a piece, so that rounding makes no further one
    return std::max(1.0, std::ceil(std::hypot(b.at.x - a.at.x, b.at.y - a.at.y) / step - slack));
}

std::string name_text(const std::string& id) {
    const bool plain = id == "ground" || id == "air";
    return plain ? id : nlohmann::json(id).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

// The members of a nav_msgs/Path, two spaces deep.
std::string path_text(double stamp, const std::vector<Pose>& corners, double step) {
    std::string text = fmt::format("  {}\n  poses:\n", header(stamp));
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Pose& a = corners[i];
        text += "  - " + pose_text(a) + "\n";
        if (i + 1 == corners.size()) break;
        const Pose& b = corners[i + 1];
        const double pieces = pieces_between(a, b, step);
        for (std::int64_t k = 1; double(k) < pieces; ++k) {
            const double part = double(k) / pieces;
            text += "  - " +
                    pose_text({{a.at.x + (b.at.x - a.at.x) * part, a.at.y + (b.at.y - a.at.y) * part},
                               a.t + (b.t - a.t) * part,
                               a.yaw}) +
                    "\n";
        }
    }
    return text;
}

void require_bounded(const std::vector<Pose>& corners, double step) {
    double poses = 1;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) poses += pieces_between(corners[i], corners[i + 1], step);
    if (!(poses <= most_poses)) {
        throw InputError("a pose every " + shortest_text(step) +
                         " m makes more than a million of them; give a larger step");
    }
    const auto late = [](const Pose& pose) { return !(pose.t >= 0 && pose.t <= last_second); };
    if (std::any_of(corners.begin(), corners.end(), late)) {
        throw InputError("the plan takes longer than the 2^31 s that stamps of ROS can count; give higher speeds");
    }
}

// The texts of all agents, vehicles first; `text_of` makes one of its corners.
template <class TextOf>
std::string document(const Plan& plan, const TextOf& text_of) {
    std::string text;
    std::set<std::string> ids;
    for (const AgentKind kind : {AgentKind::ground, AgentKind::air}) {
        for (const Itinerary& agent : plan.agents) {
            if (agent.kind != kind) continue;
            if (!ids.insert(agent.id).second)
                throw InputError("two agents have the same id, by which ROS paths are named");
            text += name_text(agent.id);
            text += text_of(agent);
        }
    }
    return text.empty() ? "{}\n" : text;
}

std::string openings_text(const std::vector<ObstacleId>& openings) {
    std::vector<std::uint32_t> ids;
    for (const ObstacleId obstacle : openings) ids.push_back(obstacle.value);
    return fmt::format("- openings: [{}]\n", fmt::join(ids, ", "));
}

}  // namespace

std::string plan_ros_path(const Plan& plan, const MapFile& map, std::optional<double> step) {
    const MapFrame frame(map);
    const double metres = step.value_or(map.cell_size);
    return document(plan, [&](const Itinerary& agent) {
        const std::vector<Pose> corners = corners_of(agent.path, frame);
        require_bounded(corners, metres);
        return fmt::format(":\n{}", path_text(0, corners, metres));
    });
}

std::string plan_ros_parts(const Plan& plan, const MapFile& map, const Mission& mission, std::optional<double> step) {
    const MapFrame frame(map);
    const double metres = step.value_or(map.cell_size);
    return document(plan, [&](const Itinerary& agent) {
        const auto place = std::size_t(&agent - plan.agents.data());
        const std::vector<PathPart> parts = path_parts(map.map, mission, plan, place);
        require_bounded(corners_of(agent.path, frame), metres);
        std::string text = parts.empty() ? ": []\n" : ":\n";
        for (const PathPart& part : parts) {
            const std::vector<Pose> corners =
                corners_of(std::span(agent.path).subspan(part.first, part.last - part.first + 1), frame);
            text += openings_text(part.openings) + path_text(corners.front().t, corners, metres);
        }
        return text;
    });
}

}  // namespace waybreaker::io
