#include "orders/track.hpp"

#include <algorithm>
#include <cmath>

namespace waybreaker::orders {

double slack_of(double before, double after) {
    constexpr double rounding = 1e-9;
    const double slack = after - before;
    return std::abs(slack) <= rounding * std::clamp(after, 1.0, 1000.0) ? 0 : slack;
}

Moment departure(std::size_t agent, const std::vector<Waypoint>& path, std::size_t move, double share) {
    const double length = std::hypot(path[move + 1].x - path[move].x, path[move + 1].y - path[move].y);
    if (share * length <= hair) return {agent, move, 0};
    return {agent, move, share - hair / length};
}

double Stretch::time(double place) const {
    return place + hair >= length ? passed : leaves + place / length * (passed - leaves);
}

double Stretch::reached(double time) const {
    if (time >= passed) return length;
    return length > 0 ? (time - leaves) / (passed - leaves) * length : -1;
}

Moment Stretch::arrival(double place) const {
    if (place + hair >= length) return {agent, end, 0};
    return {agent, point, (place + hair) / length};
}

Moment Stretch::departure(double place) const {
    if (place <= hair) return {agent, point, 0};
    return {agent, point, (place - hair) / length};
}

std::vector<Stretch> stretches(std::size_t agent, const std::vector<Waypoint>& path, bool stays) {
    using safe_interval::for_ever;
    std::vector<Stretch> all;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Waypoint& a = path[i - 1];
        const Waypoint& b = path[i];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        if (length == 0) continue;
        all.push_back({{a.x, a.y}, {(b.x - a.x) / length, (b.y - a.y) / length}, length, agent, i - 1, a.t, i, b.t});
    }
    if (all.empty()) {
        const Waypoint& at = path.front();
        all.push_back({{at.x, at.y}, {}, 0, agent, 0, at.t, 0, for_ever});
    }
    if (!stays) {
        all.back().end = path.size() - 1;
        all.back().passed = path.back().t;
    }
    return all;
}

}  // namespace waybreaker::orders
