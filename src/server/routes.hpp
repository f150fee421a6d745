// Routes: which path is answered by what. A route's handler gets a request that the guard has let through and whose
// body is read, and makes the answer or throws Problem.
#pragma once

#include <httplib.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "server/desk.hpp"
#include "server/map_shelf.hpp"
#include "server/metrics.hpp"

namespace waybreaker::server {

struct Call {
    const httplib::Request& request;
    std::string body;
    std::string map;  // the {id} of the path; empty where it has none
    std::function<bool()> client_is_there;
    // To be called when a streamed answer ends; others are counted when their handler returns.
    Ended ended;
};

struct Route {
    enum class Body { none, json, bytes };

    std::string method;
    std::string path;  // "/api/v1/maps/{id}", as metrics and the description call it
    Body body = Body::none;
    bool open = false;  // asked without a token
    std::function<void(const Call&, httplib::Response&)> answer;

    // What a path has for {id} (empty where there is none to have), if it is this route's.
    std::optional<std::string> id_in(const std::string& asked) const;
};

// The handlers keep the references.
std::vector<Route> routes(MapShelf& shelf, Desk& desk, const Metrics& metrics, const Limits& limits);

}  // namespace waybreaker::server
