#include "schedule/course.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "plan/timeline.hpp"

namespace waybreaker {

Course::Course(const Map& map, const ScheduleTask& task) : task_(task), targets_(targets_of(map, task.removed)) {
    const std::vector<Waypoint> driven = timed(task.ground_path, task.ground_speed);
    unhindered_ = driven.back().t;
    for (const Target& target : targets_) {
        const std::optional<double> touch = first_touch(map, target.obstacle, driven, task.radius);
        entries_.push_back(touch.value_or(std::numeric_limits<double>::infinity()));
        stays_.push_back(task.breach_time.of(map.obstacle(target.obstacle)));
    }
}

Finish Course::finish(const Tour& tour) const {
    Finish finish{unhindered_, 0};
    Cell at = start();
    for (const Stop& stop : tour) {
        finish.air += distance(at, stop.at) / task_.air_speed + stays_[stop.target];
        finish.ground = std::max(finish.ground, unhindered_ + lateness(stop.target, finish.air));
        at = stop.at;
    }
    finish.air += distance(at, goal()) / task_.air_speed;
    return finish;
}

Deadlines Course::deadlines(double ground_finish) const {
    Deadlines deadlines;
    for (std::size_t i = 0; i < targets_.size(); ++i) {
        deadlines.stay.push_back(stays_[i] * task_.air_speed);
        deadlines.latest.push_back((entries_[i] + ground_finish - unhindered_) * task_.air_speed);
    }
    return deadlines;
}

double Course::reach(double air_finish) const {
    return (air_finish - std::accumulate(stays_.begin(), stays_.end(), 0.0)) * task_.air_speed;
}

}  // namespace waybreaker
