#include "service/mission_routes.hpp"

#include <charconv>
#include <climits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "http/problem.hpp"
#include "io/state_json.hpp"
#include "request/revision.hpp"
#include "service/responses.hpp"

namespace waybreaker::service {
namespace {

using Json = nlohmann::ordered_json;

const std::string root = "/api/v1/missions";

Json summary_json(const MissionSummary& summary) {
    return {{"id", summary.mission.id},     {"map", summary.mission.map},   {"digest", summary.mission.digest},
            {"sequence", summary.sequence}, {"revision", summary.revision}, {"now", summary.now},
            {"status", summary.status}};
}

Route begin_route(LiveMissions& missions, MapStore& maps) {
    const auto handle = [&](const Call& call) -> Answer {
        const request::LiveRequest asked =
            read_request([&call] { return request::parse_live_request(call.request.body); });
        if (!MapStore::is_id(asked.map)) throw http::Problem(http::not_found, "map names no map", "map-not-found");
        missions.require_room();
        http::Work work = [&, asked, body = call.request.body,
                           map = maps.if_loaded(asked.map)](const http::Worker& worker) {
            const LiveMissions::Begun begun = missions.begin(asked, body, map ? map : maps.load(asked.map), worker);
            return kept_response(request::with_plan(summary_json(begun.summary).dump(), begun.first.plan),
                                 root + "/" + begun.summary.mission.id, true);
        };
        return Deferred{.work = std::move(work)};
    };
    return {"POST", root, http::BodyType::json, false, handle};
}

Route list_route(const LiveMissions& missions) {
    const auto handle = [&](const Call&) -> Answer {
        Json list = Json::array();
        for (const MissionSummary& summary : missions.list()) list.push_back(summary_json(summary));
        return ok_response(Json{{"missions", std::move(list)}}.dump() + "\n");
    };
    return {"GET", root, http::BodyType::none, false, handle};
}

Route mission_route(const LiveMissions& missions) {
    const auto handle = [&](const Call& call) -> Answer {
        return ok_response(summary_json(missions.summary(call.id)).dump() + "\n");
    };
    return {"GET", root + "/{id}", http::BodyType::none, false, handle};
}

Route delete_route(LiveMissions& missions) {
    const auto handle = [&](const Call& call) -> Answer {
        missions.remove(call.id);
        return http::Response{.status = http::no_content};
    };
    return {"DELETE", root + "/{id}", http::BodyType::none, false, handle};
}

Route report_route(LiveMissions& missions) {
    const auto handle = [&](Call call) -> Answer {
        require_size(call.request, "a report");
        missions.summary(call.id);  // it is there
        http::Work work = [&, id = call.id, body = std::move(call.request.body)](const http::Worker& worker) {
            const State state = read_request([&body] { return io::parse_state(body, "report"); });
            const ReportRecord report = missions.report(id, state, worker);
            return ok_response(request::with_plan(report.event, report.plan));
        };
        return Deferred{.work = std::move(work)};
    };
    return {"POST", root + "/{id}/reports", http::BodyType::json, false, handle};
}

Route plan_route(const LiveMissions& missions) {
    const auto handle = [&](const Call& call) -> Answer {
        std::optional<int> revision;
        if (call.request.query.find("revision")) revision = int(number_of(call.request, "revision", 0, 0, INT_MAX));
        return ok_response(missions.plan(call.id, revision).plan);
    };
    return {"GET", root + "/{id}/plan", http::BodyType::none, false, handle};
}

// The sequence number of the last event that a client has got, if it comes again.
std::optional<std::uint64_t> last_event(const http::Request& request) {
    const std::optional<std::string> text = request.headers.find("Last-Event-ID");
    if (!text || text->empty()) return std::nullopt;
    std::uint64_t id = 0;
    const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), id);
    if (error == std::errc() && end == text->data() + text->size() && id <= INT64_MAX) return id;
    throw http::Problem(http::bad_request, "Last-Event-ID is none of an event of missions: their ids are numbers");
}

Route events_route(LiveMissions& missions) {
    const auto handle = [&](const Call& call) -> Answer {
        const auto stream = missions.events(call.id, last_event(call.request));
        return Stream{.next = [stream] { return stream->take(); }, .over = [stream] { return stream->over(); }};
    };
    return {"GET", root + "/{id}/events", http::BodyType::none, false, handle};
}

}  // namespace

std::vector<Route> mission_routes(LiveMissions& missions, MapStore& maps) {
    return {begin_route(missions, maps), list_route(missions), mission_route(missions), delete_route(missions),
            report_route(missions),      plan_route(missions), events_route(missions)};
}

}  // namespace waybreaker::service
