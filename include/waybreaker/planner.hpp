// Planner: the paper's method from mission to plan.
//
//     Planner planner;                                   // keeps its memory between missions
//     Plan plan = planner.plan(map, ground_and_air({12, 20}, {400, 380}), {.seconds = 1});
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "waybreaker/expected.hpp"
#include "waybreaker/limits.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/method.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/path_through.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {

// Planning in slices, for a loop that has other things to do:
//
//     PlanningJob job = planner.start(map, mission);
//     while (!job.step(std::chrono::milliseconds(2))) draw();
//     Plan plan = job.plan();
//
// The plan is that of Planner::plan, to the byte. It is made by a thread of the job's own, which runs only while
// a step waits for it; the first step starts it, and where the system has no thread to give, that step does all.
class PlanningJob {
  public:
    PlanningJob(PlanningJob&&) noexcept;
    PlanningJob& operator=(PlanningJob&&) noexcept;
    // Ends the planning early, as Limits::stop does.
    ~PlanningJob();

    // Goes on for about that long; true once the plan is there. It is overrun by what lies between two looks at
    // Limits::stop.
    bool step(std::chrono::nanoseconds time);
    bool done() const;
    // The plan, once; goes on until it is there. Throws what planning threw.
    Plan plan();

  private:
    friend class Planner;
    class Work;
    explicit PlanningJob(std::unique_ptr<Work> work);
    std::unique_ptr<Work> work_;
};

struct Evaluated;  // src/mission/alternatives.hpp

class Planner {
  public:
    Planner();
    ~Planner();
    Planner(Planner&&) noexcept;
    Planner& operator=(Planner&&) noexcept;

    // Validates, searches the ground path without removal, selects obstacles (the paper's section 3, or with proof),
    // and puts all agents in time. With timing enforced no plan is worse than removing nothing, unless rules.force
    // demands removals. More removals can cost more where breaches take time, bases or speeds differ, or a limit ended
    // the choice (docs/exact.md, "What is not proven"); without any limit not so where several agents drive, or several
    // may breach. Aircraft that may breach nothing change no other agent's path. When limits.seconds are over: the best
    // plan found by then, with Plan::limit_reached. Keeps its memory between calls; not for two threads at once.
    Plan plan(const Map& map, const Mission& mission, const Method& method = {}, const Limits& limits = {});

    // The same, bad input as a value; throws nothing but what the standard library does where memory runs out.
    Expected<Plan> try_plan(const Map& map, const Mission& mission, const Method& method = {},
                            const Limits& limits = {});

    // The same in slices. The planner is busy until the job is done or gone; it and the map stay where they are as
    // long. limits.seconds run on between steps, limits.threads is 1, and limits.progress is called within a step.
    // Throws InputError at once.
    [[nodiscard]] PlanningJob start(const Map& map, const Mission& mission, const Method& method = {},
                                    const Limits& limits = {});
    PlanningJob start(const Map&& map, const Mission& mission, const Method& method = {},
                      const Limits& limits = {}) = delete;

    // What each further removal gains: the plans for 0, 1, 2, ... removals, up to the last that gains, at most
    // rules.removals; none is worse than the one before, except to demolish less. limits.seconds is that of all plans
    // together; the last one is explained, if asked for.
    std::vector<Plan> front(const Map& map, const Mission& mission, const Method& method = {},
                            const Limits& limits = {});

    // The plan, first, and the other choices that were evaluated on the way to it and whose objective is above its own
    // by no more than that share of it, 0 to 1: other sets of removals, or none. The better first. No set is evaluated
    // for this alone; several ground agents are planned past each other for each, after the plan, while limits.seconds
    // last. Not explained, but for the plan.
    std::vector<Plan> alternatives(const Map& map, const Mission& mission, double share, const Method& method = {},
                                   const Limits& limits = {});

    // The cheapest way of one agent that breaks by itself what is in its way, one obstacle after the other: no mission,
    // no aircraft. PathThrough::bound says for which body it is proven. No way where start or goal lie in an obstacle.
    // Throws InputError where a cost is below 0 or no number, and on options out of range.
    PathThrough path_through(const Map& map, Cell start, Cell goal, const BreakingCost& cost,
                             const PathThroughOptions& options = {});

    // The same by the default method.
    Plan plan(const Map& map, const Mission& mission, const Limits& limits) { return plan(map, mission, {}, limits); }
    Expected<Plan> try_plan(const Map& map, const Mission& mission, const Limits& limits) {
        return try_plan(map, mission, {}, limits);
    }
    [[nodiscard]] PlanningJob start(const Map& map, const Mission& mission, const Limits& limits) {
        return start(map, mission, {}, limits);
    }
    PlanningJob start(const Map&& map, const Mission& mission, const Limits& limits) = delete;
    std::vector<Plan> front(const Map& map, const Mission& mission, const Limits& limits) {
        return front(map, mission, {}, limits);
    }

  private:
    // The plan, and alternatives where a share is given.
    std::vector<Plan> plans(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
                            std::optional<double> share);
    // The same of a valid mission without zones, but for waits and orders.
    std::vector<Plan> planned(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
                              std::optional<double> share, bool goes_around_late = true);
    // Where vehicles clear for others.
    Plan planned_clearing(const Map& map, const Mission& mission, const Method& method, const Limits& limits);
    // Of a valid mission without idle aircraft. Appends to `evaluated` what the plan was chosen from.
    Plan plan_active(const Map& map, const Mission& mission, const Method& method, const Limits& limits,
                     Evaluated* evaluated = nullptr);
    std::vector<Plan> front_of_active(const Map& map, const Mission& mission, const Method& method,
                                      const Limits& limits);

    struct Memory;
    std::unique_ptr<Memory> memory_;
};

// Plans each mission as Planner::try_plan does, over that many threads (0: all cores), and gives the results in
// the order of the missions: the same whatever the number of threads, measured seconds aside. A mission that cannot be
// put on the map costs the others nothing. The limits hold for each mission; limits.progress is called on several
// threads at a time.
std::vector<Expected<Plan>> plan_all(const Map& map, std::span<const Mission> missions, const Method& method = {},
                                     const Limits& limits = {}, unsigned threads = 0);

}  // namespace waybreaker
