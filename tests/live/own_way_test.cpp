// Missions under way of an agent that opens its own way.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>

#include "checked_plan.hpp"
#include "live/underway.hpp"
#include "waybreaker/revise.hpp"

namespace waybreaker {
namespace {

Underway any_underway_alone() {
    Underway drawn = any_own_way(14, 1, Left::perhaps_rubble);
    drawn.state.sequence = 1;
    drawn.state.now = drawn.plan.agents.front().path.back().t * *number(0, 100) / 100;
    return drawn;
}

double arrival(const Plan& plan) {
    return plan.agents.front().path.back().t;
}

RC_GTEST_PROP(ReviseOwnWay, WithoutNewsIsNoLater, ()) {
    const Underway old = any_underway_alone();
    Planner planner;
    const double reaction = *rc::gen::element(0.0, 0.0, 1.5);
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state, reaction);
    RC_CLASSIFY(next.status == RevisionStatus::kept);
    RC_CLASSIFY(!old.plan.breaches.empty());
    RC_ASSERT(next.plan.status == PlanStatus::solved);
    RC_ASSERT(revision_faults(old, next) == "");
    RC_ASSERT(arrival(next.plan) <= std::max(arrival(old.plan), old.state.now + reaction) * (1 + 1e-9));
}

// The obstacle stands, and the agent before it.
RC_GTEST_PROP(ReviseOwnWay, AfterAFailedBreachTheRestIsValid, ()) {
    Underway old = any_underway_alone();
    RC_PRE(!old.plan.breaches.empty());
    const Breach failed = old.plan.breaches[std::size_t(*number(0, int(old.plan.breaches.size()) - 1))];
    old.state.now = failed.cleared_at;
    old.state.failed = {{failed.obstacle, failed.cleared_at}};
    Planner planner;
    const Revision next = revise(planner, old.map, old.mission, old.plan, old.state);
    RC_CLASSIFY(next.plan.status == PlanStatus::solved);
    if (next.plan.status != PlanStatus::solved) return;
    RC_ASSERT(revision_faults(old, next) == "");
    RC_ASSERT(next.mission.agents.front().own_breaches < old.mission.agents.front().own_breaches);
    const bool again =
        std::ranges::find(next.plan.breaches, failed.obstacle, &Breach::obstacle) != next.plan.breaches.end();
    if (old.mission.rules.retries == 0) RC_ASSERT(!again);
    RC_ASSERT(arrival(next.plan) >= arrival(old.plan) * (1 - 1e-9));
}

RC_GTEST_PROP(ReviseOwnWay, AfterAnyNewsTheRestIsValid, ()) {
    expect_valid_after_any_news(any_underway_alone());
}

}  // namespace
}  // namespace waybreaker
