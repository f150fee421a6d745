// Route: which handler serves which path. A handler gets a request that has passed the guard, with its body; it returns
// the response, or the work that makes it, or throws Problem.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "http/job_queue.hpp"
#include "http/message.hpp"
#include "http/request_body.hpp"
#include "service/executor.hpp"

namespace waybreaker::service {

struct Call {
    http::Request request;
    std::string id;  // the {id} of the path; empty where it has none
};

// A response that a worker makes.
struct Deferred {
    http::Work work;
    // The event that says how far the work is; then the response, too, is sent as an event. Null: no events.
    std::function<std::string(const http::Job&)> progress = {};
    Lane lane = Lane::planning;
};

// Events that go on until the client leaves, or they are over.
struct Stream {
    std::function<std::string()> next;  // those since the last call; called often, on the I/O thread
    std::function<bool()> over;
};

using Answer = std::variant<http::Response, Deferred, Stream>;

struct Route {
    std::string method;
    std::string path;  // "/api/v1/maps/{id}", as in metrics and openapi.json
    http::BodyType body = http::BodyType::none;
    bool open = false;  // needs no token
    std::function<Answer(Call)> answer;
    bool quick = false;  // reads no file and takes no time

    // The {id} of a path ("" if the route has none); empty if the path does not match.
    std::optional<std::string> id_in(const std::string& asked) const;
};

}  // namespace waybreaker::service
