// The waits that a flight makes necessary. The ground agent waits for an obstacle at the last turn before it touches
// it.
#include "waybreaker/schedule.hpp"

#include <algorithm>
#include <cassert>

#include "plan/timeline.hpp"

namespace waybreaker {
namespace {

// The ground agent's path as it is driven: full speed, with waits at path points.
class Driver {
  public:
    Driver(std::span<const Point> path, double speed) : points_(timed(path, speed)) {}

    // Waits, if it must, so that it comes to a place not before a time; `undelayed` is when it would be there without
    // any wait. Returns when it is there. Places come in the order of the path.
    double reach(double undelayed, double not_before) {
        const double delay = not_before - undelayed;
        if (delay <= delay_) return undelayed + delay_;
        while (next_ < points_.size() && points_[next_].t <= undelayed) drive_on();
        Waypoint waiting = driven_.back();
        waiting.t += delay - delay_;
        delay_ = delay;
        driven_.push_back(waiting);
        return not_before;
    }

    std::vector<Waypoint> finish() {
        while (next_ < points_.size()) drive_on();
        return std::move(driven_);
    }

  private:
    void drive_on() {
        Waypoint point = points_[next_++];
        point.t += delay_;
        driven_.push_back(point);
    }

    std::vector<Waypoint> points_;  // without waits
    std::vector<Waypoint> driven_;
    std::size_t next_ = 0;  // of points_
    double delay_ = 0;
};

struct Entry {
    std::size_t breach;
    double at;  // when the ground agent would be there without waits
};

std::vector<Entry> entries_in_order(const Map& map, const ScheduleTask& task, const Flight& flight) {
    const std::vector<Waypoint> undelayed = timed(task.ground_path, task.ground_speed);
    std::vector<Entry> entries;
    for (std::size_t i = 0; i < flight.breaches.size(); ++i) {
        const std::optional<double> touch = first_touch(map, flight.breaches[i].obstacle, undelayed, task.radius);
        if (touch) entries.push_back({i, *touch});
    }
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.at < b.at; });
    return entries;
}

}  // namespace

Schedule schedule_of(const Map& map, const ScheduleTask& task, const Flight& flight) {
    assert(!task.ground_path.empty());
    Schedule schedule;
    schedule.flight = flight;

    // The air agent stays at each breach point until the obstacle is gone.
    const auto fly_to = [&](Cell to) {
        const Waypoint& from = schedule.air.back();
        const double t = from.t + distance(Point(from.x, from.y), to) / task.air_speed;
        schedule.air.push_back({double(to.x), double(to.y), t});
    };
    schedule.air.push_back({double(task.air_start.x), double(task.air_start.y), 0});
    for (const BreachPoint& breach : flight.breaches) {
        fly_to(breach.at);
        const double stay = task.breach_time.of(map.obstacle(breach.obstacle));
        Waypoint waypoint = schedule.air.back();
        waypoint.t += stay;
        if (stay > 0) schedule.air.push_back(waypoint);
        schedule.cleared_at.push_back(waypoint.t);
    }
    fly_to(task.air_goal);

    // The ground agent waits for each obstacle in its way.
    Driver driver(task.ground_path, task.ground_speed);
    schedule.entered_at.resize(flight.breaches.size());
    for (const Entry& entry : entries_in_order(map, task, flight)) {
        schedule.entered_at[entry.breach] = driver.reach(entry.at, schedule.cleared_at[entry.breach]);
    }
    schedule.ground = driver.finish();

    schedule.makespan = std::max(schedule.ground.back().t, schedule.air.back().t);
    schedule.flowtime = schedule.ground.back().t + schedule.air.back().t;
    return schedule;
}

Schedule best_schedule(const Map& map, const ScheduleTask& task) {
    const Flight shortest = task.removed.empty() ? Flight{{}, distance(task.air_start, task.air_goal)}
                                                 : fly_optimal(map, task.air_start, task.air_goal, task.removed);
    return schedule_of(map, task, shortest);
}

}  // namespace waybreaker
