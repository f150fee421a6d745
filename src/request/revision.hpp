// A revision as a request of its own: a plan, and what has happened to it.
//
//     {"plan": {"format": "waybreaker-plan/1", ...}, "state": {"format": "waybreaker-state/1", ...}, "reaction": 2}
//
// What clients learn of revisions, asked for in this way or by reports of live missions, is one object:
//
//     {"sequence": 1, "revision": 1, "now": 42.5, "status": "revised", "makespan": 391.2, "changed": ["ground"], ...}
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "io/plan_file.hpp"
#include "revision/revised_file.hpp"
#include "waybreaker/state.hpp"

namespace waybreaker::request {

struct RevisionRequest {
    io::PlanFile before;
    State state;
    double reaction = 0;  // how long agents take to learn of a new plan, in units of time
    double seconds = std::numeric_limits<double>::infinity();  // to plan for
    bool timing_fields = true;                                 // false: no measured seconds in the response
};

// Larger requests are refused.
inline constexpr std::size_t max_revision_bytes = std::size_t{4} << 20;

// Throws InputError that says where and what is wrong; `name` is what errors call the input.
RevisionRequest parse_revision_request(std::string_view bytes, const std::string& name = "request");

// What is revised by which report, and what came of it.
struct RevisionHead {
    std::uint64_t sequence = 0;
    int revision = 0;
    double now = 0;
    std::string status;
};

// What clients learn of a plan that follows another: makespan, who goes another way, which breaches are new.
std::string revision_event(const RevisionHead& head, const Plan& before, const Plan& after, const Mission& left);
// The same where there is none: why, and who must stop.
std::string event_without_plan(const RevisionHead& head, const Plan& none);

// An event with a plan, or null, as its last member; the plan's bytes are those of its document.
std::string with_plan(std::string event, const std::string& plan);

// What came of a request: its event with the new plan. Throws InputError if the plan knows that report already.
std::string revision_answer(const RevisionRequest& request, const revision::RevisedFile& next);

}  // namespace waybreaker::request
