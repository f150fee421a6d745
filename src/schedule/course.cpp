#include "schedule/course.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "model/timeline.hpp"

namespace waybreaker {

Precedence Needs::precedence(std::vector<const Agent*> aircraft, std::vector<std::vector<double>> stays) const {
    Drive drive{unhindered};
    for (std::size_t target = 0; target < targets.size(); ++target) {
        const Breaching& breaching = breachings[target];
        if (!std::isinf(breaching.needed_by)) drive.passages.push_back({target, breaching.needed_by + held});
    }
    Precedence precedence(std::move(aircraft), targets.size(), std::move(stays));
    precedence.add_vehicle({std::move(drive)});
    return precedence;
}

Needs Needs::only(std::uint32_t subset, std::span<const double> stays) const {
    Needs some{{}, {}, unhindered, across, driven, given, held};
    for (std::size_t target = 0; target < targets.size(); ++target) {
        if ((subset >> target & 1U) == 0) continue;
        some.targets.push_back(targets[target]);
        some.breachings.push_back(breachings[target]);
        some.breachings.back().stay = stays[target];
    }
    return some;
}

Needs needs_of(const Map& map, const ScheduleTask& task) {
    Needs needs{targets_of(map, to_breach(task.rules, task.removed), task.flyer.airspace, task.flyer.begin()),
                {},
                0,
                distance(Cell{}, Cell{map.width(), map.height()})};
    needs.driven = drive_through(map, task);
    needs.unhindered = needs.driven.back().t;
    needs.given = given_of(map, task, needs.driven);
    for (const Due& due : needs.given) needs.held = std::max(needs.held, due.opens - due.needed_by);
    needs.unhindered += needs.held;
    for (const Target& target : needs.targets) {
        needs.breachings.push_back(breaching_of(map, task, needs.driven, target.obstacle));
    }
    return needs;
}

Course::Course(const ScheduleTask& task, Needs needs) : task_(task), needs_(std::move(needs)) {
    std::vector<double> stays;
    for (const Breaching& breaching : needs_.breachings) stays.push_back(breaching.stay);
    stays_ = std::accumulate(stays.begin(), stays.end(), 0.0);
    precedence_ = needs_.precedence({&task.flyer}, {std::move(stays)});
    longest_tour_ = needs_.across * double(needs_.targets.size() + 1);
    // A way round zones is at most once at each of their corners.
    if (!task.flyer.airspace.is_open()) longest_tour_ *= double(most_zone_corners + 1);
}

Deadlines Course::deadlines(double ground_finish) const {
    Deadlines deadlines;
    for (const Breaching& breaching : needs_.breachings) {
        deadlines.stay.push_back(breaching.stay * task_.flyer.speed);
        const double latest = breaching.needed_by + needs_.held + ground_finish - needs_.unhindered;
        deadlines.latest.push_back((latest - task_.flyer.ready_at) * task_.flyer.speed);
    }
    return deadlines;
}

double Course::reach(double air_finish) const {
    return std::min((air_finish - task_.flyer.ready_at - stays_) * task_.flyer.speed, longest_tour_);
}

}  // namespace waybreaker
