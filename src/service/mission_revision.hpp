// What a live mission begins with, and what a report makes of it: pure, but for measured seconds.
#pragma once

#include <span>
#include <string>

#include "http/job_queue.hpp"
#include "request/plan_request.hpp"
#include "service/map_store.hpp"
#include "service/mission_store.hpp"
#include "service/planner_pool.hpp"
#include "waybreaker/state.hpp"

namespace waybreaker::service {

struct LiveTask {
    SharedMap map;
    std::string map_name;  // as the mission calls it
    request::LiveRequest request;
    PlannerPool& planners;
    double seconds = 30;  // upper limit, whatever the request says
};

// Throws Problem if the mission does not fit the map, or has no plan.
ReportRecord first_plan(const LiveTask& task, const http::Worker& worker);

// What comes of a report, given the plan that holds and the states reported since, of which no plan came. Throws
// Problem if the report cannot be one of that plan.
ReportRecord revised_plan(const LiveTask& task, const ReportRecord& held, std::span<const State> since,
                          const State& report, const http::Worker& worker);

// A state, and what an earlier one says that it does not: what is open, failed, found, who has joined, has stopped or
// is lost, and new goals. Where both speak of one thing, the later one is right.
State with_earlier(State later, const State& earlier);

}  // namespace waybreaker::service
