// Objective: what a plan makes small, from when its agents are at their goals.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "waybreaker/mission.hpp"

namespace waybreaker {

// What an arrival adds to the flowtime: infinity if there is none, whatever it counts for.
inline double weighted(double weight, double time) {
    return std::isinf(time) ? time : weight * time;
}

// Of the agent that counts for least; 0 if there is none.
inline double least_weight_of(std::span<const Agent* const> agents) {
    const auto least = std::ranges::min_element(agents, {}, &Agent::weight);
    return least == agents.end() ? 0 : (*least)->weight;
}

// When agents are at their goals, in units of time.
struct Finish {
    double ground = 0;    // the last of the ground agents
    double air = 0;       // the last of the air agents
    double flowtime = 0;  // sum over all, weighted

    double makespan() const { return std::max(ground, air); }

    void add(AgentKind kind, double time, double weight = 1) {
        double& last = kind == AgentKind::ground ? ground : air;
        last = std::max(last, time);
        flowtime += weighted(weight, time);
    }
    // Never, where an aircraft would fly farther than it may.
    void add(const Agent& agent, double time) {
        const bool may = agent.kind == AgentKind::ground || agent.may_land_at(time);
        add(agent.kind, may ? time : std::numeric_limits<double>::infinity(), agent.weight);
    }
};

// When an agent counts as arrived that is not at its goal by then: no earlier than it is ready, as one under way may be
// after Rules::unreached; infinity if each has to arrive.
inline double unreached_at(const Rules& rules, const Agent& agent) {
    return std::max(rules.unreached.value_or(std::numeric_limits<double>::infinity()), agent.ready_at);
}

// When the aircraft are at their goals, in units of time.
struct Returns {
    double last = 0;
    double sum = 0;  // weighted
};

// Of one ground agent and the aircraft.
inline Finish finish_of(double ground, const Returns& air) {
    return {ground, air.last, ground + air.sum};
}
// Of one ground and one air agent.
inline Finish finish_of_two(double ground, double air) {
    return finish_of(ground, {air, air});
}

// How good it is to finish so, the smaller the better: by the first figure, and of equals by the second. Ties of the
// flowtime go to the makespan, all others to the flowtime.
struct Rank {
    double first = 0;
    double second = 0;
};

inline Rank rank(Objective objective, const Finish& finish) {
    switch (objective) {
        case Objective::makespan:
            return {finish.makespan(), finish.flowtime};
        case Objective::flowtime:
            return {finish.flowtime, finish.makespan()};
        case Objective::ground_makespan:
            break;
    }
    // Whenever the aircraft are home, they have to get there.
    return {std::isinf(finish.air) ? finish.air : finish.ground, finish.flowtime};
}

}  // namespace waybreaker
