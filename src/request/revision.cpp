#include "request/revision.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "io/json_field.hpp"
#include "io/mission_json.hpp"
#include "io/state_json.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::request {
namespace {

using Json = nlohmann::ordered_json;

// Whether two agents go the same way from then on.
bool same_way(const Itinerary& one, const Itinerary& other, double since) {
    const auto ahead = [since](const Itinerary& agent) {
        constexpr double hair = 1e-9;
        const double from = since * (1 + hair);
        return std::ranges::subrange(std::ranges::upper_bound(agent.path, from, {}, &Waypoint::t), agent.path.end());
    };
    return std::ranges::equal(ahead(one), ahead(other));
}

bool has_agent(const std::vector<Itinerary>& agents, const std::string& id) {
    return std::ranges::find(agents, id, &Itinerary::id) != agents.end();
}

// Agents that were not there, or go another way from where they can decide; and agents that are gone.
void add_agents(Json& event, const Plan& before, const Plan& after) {
    event["changed"] = Json::array();
    event["gone"] = Json::array();
    for (const Itinerary& is : after.agents) {
        const auto was = std::ranges::find(before.agents, is.id, &Itinerary::id);
        double since = 0;
        if (after.revised) {
            const auto& decisions = after.revised->decisions;
            const auto decision = std::ranges::find(decisions, is.id, &Decision::agent);
            since = decision == decisions.end() ? after.revised->now : decision->time;
        }
        if (was == before.agents.end() || !same_way(*was, is, since)) event["changed"].push_back(is.id);
    }
    for (const Itinerary& was : before.agents) {
        if (!has_agent(after.agents, was.id)) event["gone"].push_back(was.id);
    }
}

// Breaches that are new, and those that will not be made.
void add_breaches(Json& event, const Plan& before, const Plan& after, const Mission& left, double now) {
    const auto has = [](const Plan& plan, ObstacleId id) {
        return std::ranges::find(plan.breaches, id, &Breach::obstacle) != plan.breaches.end();
    };
    event["added"] = Json::array();
    event["dropped"] = Json::array();
    for (const Breach& breach : after.breaches) {
        if (!has(before, breach.obstacle)) event["added"].push_back(breach.obstacle.value);
    }
    const std::vector<TimedOpening>& opened = left.rules.opened;
    for (const Breach& breach : before.breaches) {
        const bool opens = std::ranges::find(opened, breach.obstacle, &TimedOpening::obstacle) != opened.end();
        if (breach.cleared_at > now && !opens && !has(after, breach.obstacle))
            event["dropped"].push_back(breach.obstacle.value);
    }
}

Json head_json(const RevisionHead& head) {
    return {{"sequence", head.sequence}, {"revision", head.revision}, {"now", head.now}, {"status", head.status}};
}

}  // namespace

RevisionRequest parse_revision_request(std::string_view bytes, const std::string& name) {
    if (bytes.size() > max_revision_bytes) throw InputError(name, 0, "is too large");
    const auto document = io::parse_json(bytes, name, io::max_plan_depth + 1);
    const io::JsonField root(document);
    root.allow({"plan", "state", "reaction", "time_limit", "no_timing"});
    RevisionRequest request{.before = io::read_plan(root["plan"]), .state = io::read_state(root["state"])};
    if (const auto field = root.find("reaction")) {
        request.reaction = io::read_not_negative(*field);
        if (request.reaction > most_breach_time) field->fail("is no time of a mission");
    }
    if (const auto field = root.find("time_limit")) {
        request.seconds = field->number();
        if (!(request.seconds > 0)) field->fail("is not above 0");
    }
    if (const auto field = root.find("no_timing")) request.timing_fields = !field->truth();
    return request;
}

std::string revision_event(const RevisionHead& head, const Plan& before, const Plan& after, const Mission& left) {
    Json event = head_json(head);
    const std::optional<double> makespan = after.after.makespan;
    event["makespan"] = makespan && std::isfinite(*makespan) ? Json(*makespan) : Json(nullptr);
    add_agents(event, before, after);
    add_breaches(event, before, after, left, head.now);
    event["halts"] = Json::array();
    return event.dump();
}

std::string event_without_plan(const RevisionHead& head, const Plan& none) {
    Json event = head_json(head);
    if (none.revised->status == RevisionStatus::no_plan) event["reason"] = to_string(none.status);
    event["halts"] = Json::array();
    for (const Halt& halt : none.revised->halts)
        event["halts"].push_back({{"agent", halt.agent}, {"point", halt.point}, {"by", halt.by}});
    return event.dump();
}

std::string with_plan(std::string event, const std::string& plan) {
    event.pop_back();
    return event + ", \"plan\": " + (plan.empty() ? "null\n" : plan) + "}\n";
}

std::string revision_answer(const RevisionRequest& request, const revision::RevisedFile& next) {
    const Plan& before = request.before.plan;
    const State& state = request.state;
    if (next.status == RevisionStatus::unchanged) {
        throw InputError("the plan knows report " + std::to_string(state.sequence) +
                         " already: number the next one upwards");
    }
    const bool planned = next.plan.status == PlanStatus::solved;
    const int number = before.revised ? before.revised->number : 0;
    const RevisionHead head{state.sequence, planned ? number + 1 : number, state.now,
                            std::string(to_string(next.status))};
    if (!planned) return with_plan(event_without_plan(head, next.plan), {});
    return with_plan(revision_event(head, before, next.plan, next.asked.mission), next.json(request.timing_fields));
}

}  // namespace waybreaker::request
