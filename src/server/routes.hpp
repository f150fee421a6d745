// Routes: which path is answered by what. A route's handler gets a request that the guard has let through and whose
// body is read; it gives the answer or the work that makes it, or throws Problem.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "server/desk.hpp"
#include "server/map_shelf.hpp"
#include "server/message.hpp"
#include "server/metrics.hpp"

namespace waybreaker::server {

struct Call {
    Request request;
    std::string map;  // the {id} of the path; empty where it has none
};

// An answer that takes its time: it waits for a worker, and the client may be told meanwhile how far it is.
struct Later {
    Work work;
    bool events = false;
};

using Answer = std::variant<Response, Later>;

struct Route {
    enum class Body { none, json, bytes };

    std::string method;
    std::string path;  // "/api/v1/maps/{id}", as metrics and the description call it
    Body body = Body::none;
    bool open = false;  // asked without a token
    std::function<Answer(Call)> answer;
    bool quick = false;  // reads no file and takes no time

    // What a path has for {id} (empty where there is none to have), if it is this route's.
    std::optional<std::string> id_in(const std::string& asked) const;
};

// Their handlers keep the references.
std::vector<Route> routes(MapShelf& shelf, const Desk& desk, const Metrics& metrics, const ServiceLimits& limits);

}  // namespace waybreaker::server
