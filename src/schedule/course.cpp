#include "schedule/course.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plan/timeline.hpp"

namespace waybreaker {

Course::Course(const Map& map, const ScheduleTask& task) : task_(task), targets_(targets_of(map, task.removed)) {
    const std::vector<Waypoint> driven = timed(task.ground_path, task.driver.speed, task.driver.ready_at);
    unhindered_ = driven.back().t;
    Drive drive{unhindered_};
    std::vector<double> stays;
    for (std::size_t target = 0; target < targets_.size(); ++target) {
        const Breaching& breaching =
            breachings_.emplace_back(breaching_of(map, task, driven, targets_[target].obstacle));
        if (!std::isinf(breaching.needed_by)) drive.passages.push_back({target, breaching.needed_by});
        stays.push_back(breaching.stay);
        stays_ += breaching.stay;
    }
    precedence_ = Precedence({&task.flyer}, std::move(stays));
    precedence_.add_vehicle({std::move(drive)});
    const double across = std::hypot(map.width(), map.height());
    longest_tour_ = across * double(targets_.size() + 1);
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
