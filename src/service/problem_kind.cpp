#include "service/problem_kind.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "http/problem.hpp"

namespace waybreaker::service {
namespace {

constexpr std::array kinds{
    ProblemKind{"invalid-request", 400, "The request cannot be read",
                "The detail says what is wrong, in a body as NAME:LINE:COLUMN. Mend the request."},
    ProblemKind{"token-needed", 401, "A token is needed", "Send Authorization: Bearer TOKEN."},
    ProblemKind{"other-site", 403, "Pages of other sites may not ask", "Ask from a page of this server, or no page."},
    ProblemKind{"map-not-removable", 403, "This map cannot be deleted",
                "Only maps that were sent here or drawn can be, while no live mission is on them."},
    ProblemKind{"path-not-found", 404, "There is nothing at this path", "/api/v1/openapi.json describes all paths."},
    ProblemKind{"map-not-found", 404, "There is no map of this name",
                "A map that was sent here is gone after a restart, or once others needed its memory: send it again. "
                "/api/v1/maps lists those there are."},
    ProblemKind{"source-not-found", 404, "There is no map data of this name",
                "What was sent is gone after a restart, an hour after its last use, or once other map data needed its "
                "memory: send it again."},
    ProblemKind{"mission-not-found", 404, "There is no live mission of this name",
                "It was deleted, or the server was started again without its --store. /api/v1/missions lists those "
                "there are."},
    ProblemKind{"revision-not-found", 404, "The mission has no such revision",
                "/api/v1/missions/{id} says which one is the last; the first plan is revision 0."},
    ProblemKind{"wrong-method", 405, "This path has no such method", "The header Allow lists those it has."},
    ProblemKind{"report-out-of-turn", 409, "The report's sequence number is taken, or too low",
                "Number reports upwards, and send the next one when the last is answered. /api/v1/missions/{id} says "
                "which number was the last."},
    ProblemKind{"too-slow", 408, "The request did not come whole in time", "Send it faster."},
    ProblemKind{"body-too-large", 413, "The body is too large", "--max-upload of the server says how large it may be."},
    ProblemKind{"map-too-large", 413, "The map is too large",
                "--max-cells and --max-memory of the server say how large maps may be. Cut a piece out of it."},
    ProblemKind{"source-too-large", 413, "The map data is too large",
                "All map data together may take a quarter of --max-memory. Cut a piece out of it."},
    ProblemKind{"target-too-long", 414, "The path and query are too long", "Send less in them."},
    ProblemKind{"wrong-media-type", 415, "The body has the wrong media type", "The detail says which one is right."},
    ProblemKind{"expectation-unknown", 417, "What is expected is not known", "Expect 100-continue, or nothing."},
    ProblemKind{"wrong-host", 421, "This server has another name",
                "Ask for localhost, or start it with a --name for it."},
    ProblemKind{"unfit-request", 422, "The request does not fit the map", "The detail says why. Mend the request."},
    ProblemKind{"mission-unfit", 422, "The mission does not fit the map", "The detail says why. Mend the mission."},
    ProblemKind{"map-unreadable", 422, "The map cannot be read", "The detail says why, as far as a client may know."},
    ProblemKind{"map-beyond-memory", 422, "The map needs more memory than all maps may take",
                "Start the server with a larger --max-memory, or cut a piece out of the map."},
    ProblemKind{"map-of-many-files", 422, "The map is more than one file", "Only maps of one file can be had back."},
    ProblemKind{"source-unreadable", 422, "The map data cannot be read",
                "The detail says why. OpenStreetMap's .osm.pbf, .osm and .osm.gz are read, and GeoJSON."},
    ProblemKind{"import-unfit", 422, "This cannot be imported from the map data",
                "The detail says why. GET /api/v1/sources/{id} says what the map data covers."},
    ProblemKind{"import-too-long", 422, "The import took too long",
                "Choose a smaller window or larger cells, cut a piece out of the map data, or start the server with a "
                "larger --time-limit."},
    ProblemKind{"import-beyond-memory", 422, "The import needs more memory than it may take",
                "Choose a smaller window or larger cells, or cut a piece out of the map data: it has shapes that are "
                "hard to read."},
    ProblemKind{"plan-invalid", 422, "The plan is not valid for the map", "POST it to check for all that is wrong."},
    ProblemKind{"mission-without-plan", 422, "The mission has no plan to begin with",
                "The detail says why. Change the mission, or allow more time or removals."},
    ProblemKind{"report-unfit", 422, "The report cannot be one of the plan",
                "The detail says why. /api/v1/missions/{id}/plan is the plan that reports speak of."},
    ProblemKind{"headers-too-large", 431, "The headers are too large", "Send fewer or shorter ones."},
    ProblemKind{"internal-error", 500, "The server made a mistake", "Its log says more."},
    ProblemKind{"not-implemented", 501, "The server does not know this way to ask", "Ask in a simpler way."},
    ProblemKind{"busy", 503, "The server has too much to do", "Ask again after the seconds of Retry-After."},
    ProblemKind{"no-memory", 503, "There is no memory left for this", "Ask again when others are done."},
    ProblemKind{"store-unusable", 503, "The server cannot store this now",
                "What was acknowledged before is safe. Ask again when there is room on its disk, or its "
                "database is back: a report that was taken all the same gets its answer."},
    ProblemKind{"version-unknown", 505, "The version of HTTP is not known", "Ask with HTTP/1.1."},
    ProblemKind{"too-many-missions", 507, "As many missions are live as may be",
                "Delete one that has ended, or start the server with a larger --live-missions."},
};

template <class Holds>
const ProblemKind* first(Holds holds) {
    const auto* const found = std::find_if(kinds.begin(), kinds.end(), holds);
    return found == kinds.end() ? nullptr : found;
}

}  // namespace

std::span<const ProblemKind> problem_kinds() {
    return kinds;
}

const ProblemKind* kind_of(std::string_view name) {
    return first([name](const ProblemKind& kind) { return kind.name == name; });
}

const ProblemKind* kind_of(int status) {
    return first([status](const ProblemKind& kind) { return kind.status == status; });
}

std::string problem_json(int status, const std::string& detail, std::string_view kind) {
    const ProblemKind* const known = kind.empty() ? kind_of(status) : kind_of(kind);
    const nlohmann::ordered_json json{{"type", known ? known->type() : "about:blank"},
                                      {"title", known ? std::string(known->title) : http::title_of(status)},
                                      {"status", status},
                                      {"detail", detail}};
    return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace waybreaker::service
