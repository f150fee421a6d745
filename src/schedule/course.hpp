// Course: a ground path with the obstacles in its way, and when both agents finish if the air agent flies a certain
// tour.
//
// With r the ground agent's release time, v its speed, L the path's length and s the place on the path where it first
// touches an obstacle, it finishes at max(r + L / v, cleared_at + (L - s) / v over all obstacles): it waits for the
// worst of them and no longer. Rubble makes L and s longer.
#pragma once

#include <cstdint>
#include <vector>

#include "flight/exact.hpp"
#include "flight/target.hpp"
#include "schedule/precedence.hpp"
#include "schedule/timetable.hpp"
#include "waybreaker/advanced/schedule.hpp"

namespace waybreaker {

// What a ground path needs open, whoever flies.
struct Needs {
    std::vector<Target> targets;
    std::vector<Breaching> breachings;  // as the targets
    double unhindered = 0;              // when the ground agent finishes if it waits for none of them
    double across = 0;                  // the map's diagonal, cells
    std::vector<Waypoint> driven = {};  // the path in time, with stops for rubble only
    std::vector<Due> given = {};        // what opens by itself
    double held = 0;                    // how long the ground agent waits for that

    // The ground agent past the targets, and those that breach them. `stays`: as those of a precedence.
    Precedence precedence(std::vector<const Agent*> aircraft, std::vector<std::vector<double>> stays) const;
    // Of those of the targets only that a set of bits names, where an aircraft stays so long at each of all.
    Needs only(std::uint32_t subset, std::span<const double> stays) const;
};
// Throws InputError for an obstacle that fills the whole map.
Needs needs_of(const Map& map, const ScheduleTask& task);

class Course {
  public:
    // The task must outlive it.
    Course(const ScheduleTask& task, Needs needs);

    std::span<const Target> targets() const { return needs_.targets; }
    Point start() const { return task_.flyer.begin(); }
    Cell goal() const { return task_.flyer.goal; }
    const Airspace& air() const { return task_.flyer.airspace; }
    const ScheduleTask& task() const { return task_; }

    // When the ground agent finishes if it waits for no target.
    double unhindered() const { return needs_.unhindered; }
    const Breaching& breaching(std::size_t target) const { return needs_.breachings[target]; }
    // How long the ground agent would have to wait for a target; negative if it comes later.
    double lateness(std::size_t target, double cleared_at) const {
        return cleared_at - breaching(target).needed_by - needs_.held;
    }
    std::span<const Waypoint> driven() const { return needs_.driven; }
    std::span<const Due> given() const { return needs_.given; }

    Finish finish(const Tour& tour) const { return precedence_.finish(std::span(&tour, 1)); }

    // What a tour must meet so that the ground agent finishes by a certain time; and how far it may go so that the air
    // agent does.
    Deadlines deadlines(double ground_finish) const;
    double reach(double air_finish) const;

  private:
    const ScheduleTask& task_;
    Needs needs_;
    Precedence precedence_;    // of one vehicle and one aircraft
    double stays_ = 0;         // of all together
    double longest_tour_ = 0;  // cells; no tour without a detour is longer
};

}  // namespace waybreaker
