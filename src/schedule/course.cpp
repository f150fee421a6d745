#include "schedule/course.hpp"

#include <algorithm>
#include <cmath>

#include "plan/timeline.hpp"

namespace waybreaker {

Course::Course(const Map& map, const ScheduleTask& task) : task_(task), targets_(targets_of(map, task.removed)) {
    const std::vector<Waypoint> driven = timed(task.ground_path, task.driver.speed);
    unhindered_ = driven.back().t;
    for (const Target& target : targets_) {
        breachings_.push_back(breaching_of(map, task, driven, target.obstacle));
        stays_ += breachings_.back().stay;
    }
    const double across = std::hypot(map.width(), map.height());
    longest_tour_ = across * double(targets_.size() + 1);
}

Finish Course::finish(const Tour& tour) const {
    Finish finish{unhindered_, 0};
    Cell at = start();
    for (const Stop& stop : tour) {
        finish.air += distance(at, stop.at) / task_.flyer.speed + breachings_[stop.target].stay;
        finish.ground = std::max(finish.ground, unhindered_ + lateness(stop.target, finish.air));
        at = stop.at;
    }
    finish.air += distance(at, goal()) / task_.flyer.speed;
    return finish;
}

Deadlines Course::deadlines(double ground_finish) const {
    Deadlines deadlines;
    for (const Breaching& breaching : breachings_) {
        deadlines.stay.push_back(breaching.stay * task_.flyer.speed);
        deadlines.latest.push_back((breaching.needed_by + ground_finish - unhindered_) * task_.flyer.speed);
    }
    return deadlines;
}

double Course::reach(double air_finish) const {
    return std::min((air_finish - stays_) * task_.flyer.speed, longest_tour_);
}

}  // namespace waybreaker
