#include "rehearse/foresight.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace waybreaker::rehearsal {
namespace {

// With the works and the planned times that are left.
std::vector<Waypoint> path_ahead(const Actor& actor, double now) {
    std::vector<Waypoint> path{{actor.here().at.x, actor.here().at.y, now}};
    double time = now;
    for (std::size_t i = actor.stop + 1; i < actor.script.size(); ++i) {
        const Stop& stop = actor.script[i];
        const double length = distance(actor.script[i - 1].at, stop.at);
        time += length > 0 ? length / actor.speed : stop.work;
        path.push_back({stop.at.x, stop.at.y, time});
        if (stop.not_before <= time) continue;
        time = stop.not_before;
        path.push_back({stop.at.x, stop.at.y, time});
    }
    return path;
}

}  // namespace

double Foresight::may_go_on(const Actor& actor, double now) const {
    const std::optional<ZoneBreach> breach = watch_.first_breach(actor.planned_as, path_ahead(actor, now));
    if (!breach || !breach->stay.entered) return now;
    return now + mission_.rules.zones[breach->zone].until - breach->stay.from;
}

}  // namespace waybreaker::rehearsal
