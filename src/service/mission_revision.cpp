#include "service/mission_revision.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "http/problem.hpp"
#include "io/plan_file.hpp"
#include "io/sha256.hpp"
#include "io/state_json.hpp"
#include "request/revision.hpp"
#include "service/answers.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/revise.hpp"

namespace waybreaker::service {
namespace {

// The map as it is known since that plan, and weighed as the request asks.
io::MapFile map_now(const LiveTask& task, const Plan& plan) {
    io::MapFile known = io::known_map(task.map->file, plan);
    known.source = task.map_name;
    const request::PlanRequest& asked = task.request.plan;
    request::MissionOnMap weighed = request::on_map(asked.mission, asked.options, known);
    if (weighed.reweighted) known.map = *std::move(weighed.reweighted);
    return known;
}

request::RevisionHead head_of(const ReportRecord& record) {
    return {record.sequence, record.revision, record.now, record.status};
}

}  // namespace

ReportRecord first_plan(const LiveTask& task, const http::Worker& worker) {
    const PlanDocument first = plan_document({task.map, task.request.plan, task.planners, task.seconds}, worker);
    if (first.plan.status != PlanStatus::solved) {
        throw http::Problem(http::unprocessable,
                            "the mission has no plan to begin with: " + std::string(to_string(first.plan.status)),
                            "mission-without-plan");
    }
    ReportRecord record{.status = "planned", .plan = first.text};
    record.event = request::revision_event(head_of(record), {}, first.plan, {});
    return record;
}

ReportRecord revised_plan(const LiveTask& task, const ReportRecord& held, std::span<const State> since,
                          const State& report, const http::Worker& worker) try {
    const io::PlanFile before = io::parse_plan(held.plan, "the plan");
    State state = report;
    for (auto earlier = since.rbegin(); earlier != since.rend(); ++earlier)
        state = with_earlier(std::move(state), *earlier);
    io::MapFile known = map_now(task, before.plan);
    Limits limits = task.request.plan.options.asked.limits;
    limits.stop = worker.stop;
    limits.seconds = std::min(limits.seconds, task.seconds);
    worker.set_time_limit(limits.seconds);
    PlannerPool::Loan planner = task.planners.borrow(task.map);
    Revision made = planner.revise(known.map, before.asked.mission, before.plan, state, task.request.reaction,
                                   before.asked.method, limits);
    const revision::RevisedFile next =
        revision::next_file(before, std::move(known), std::move(made), io::sha256_digest(held.plan));
    const bool planned = next.plan.status == PlanStatus::solved;
    ReportRecord record{.sequence = report.sequence,
                        .revision = planned ? held.revision + 1 : held.revision,
                        .now = report.now,
                        .status = std::string(to_string(next.status)),
                        .state = io::state_json(report).dump()};
    if (!planned) {
        record.event = request::event_without_plan(head_of(record), next.plan);
        return record;
    }
    record.plan = next.json(task.request.plan.timing_fields);
    record.event = request::revision_event(head_of(record), before.plan, next.plan, next.asked.mission);
    return record;
} catch (const InputError& error) {
    throw http::Problem(http::unprocessable, error.what(), "report-unfit");
}

State with_earlier(State later, const State& earlier) {
    for (const AgentState& agent : earlier.agents) {
        const auto known = std::ranges::find(later.agents, agent.id, &AgentState::id);
        if (known != later.agents.end()) {
            if (!known->goal) known->goal = agent.goal;
        } else if (agent.doing == Doing::stopped || agent.doing == Doing::lost) {
            later.agents.push_back(agent);
        } else if (agent.goal) {
            AgentState goes = agent;
            goes.at.reset();  // where the plan has it by now
            goes.doing = Doing::moving;
            later.agents.push_back(std::move(goes));
        }
    }
    const auto speaks_of = [](const State& state, ObstacleId obstacle) {
        return std::ranges::find(state.opened, obstacle, &TimedOpening::obstacle) != state.opened.end() ||
               std::ranges::find(state.failed, obstacle, &TimedOpening::obstacle) != state.failed.end();
    };
    const State said = later;
    for (const TimedOpening& opening : earlier.opened) {
        if (!speaks_of(said, opening.obstacle)) later.opened.push_back(opening);
    }
    for (const TimedOpening& failure : earlier.failed) {
        if (!speaks_of(said, failure.obstacle)) later.failed.push_back(failure);
    }
    std::vector<Found> found = earlier.found;
    for (const Found& part : said.found) {
        if (std::ranges::find(found, part) == found.end()) found.push_back(part);
    }
    later.found = std::move(found);
    for (const Agent& agent : earlier.joined) {
        const bool again = std::ranges::find(said.joined, agent.id, &Agent::id) != said.joined.end();
        if (!again) later.joined.push_back(agent);
    }
    return later;
}

}  // namespace waybreaker::service
