// Exchange: one request that is being answered, as the transport and those who answer see each other.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "server/message.hpp"
#include "server/problem.hpp"

namespace waybreaker::server {

// What is done with a client until its answer is there. Called on the thread that reads and writes.
struct Waiting {
    bool events = false;  // the answer comes in pieces: those that `tick` gives, at last the body of Exchange::answer
    std::function<std::string()> tick = [] { return std::string(); };  // called four times a second
    std::function<void()> gone = [] {};  // the client went away; there is nobody to answer any more
};

// From any thread.
class Exchange {
  public:
    virtual ~Exchange() = default;
    // At most once, before `answer`.
    virtual void wait(Waiting waiting) = 0;
    virtual void answer(Response response) = 0;
};

struct Admission {
    std::optional<Response> refusal = {};
    bool body = true;    // whether its body is wanted
    bool quick = false;  // whether it is answered without reading files or long work: on the thread that reads
};

// Whoever answers.
class Reception {
  public:
    virtual ~Reception() = default;
    // Whether a request may go on, of which only the head is there. `length`: of its body, unless it comes in chunks.
    virtual Admission admit(const Request& head, std::optional<std::uint64_t> length) = 0;
    // Answers by `exchange`, at once or later.
    virtual void serve(Request request, std::shared_ptr<Exchange> exchange) = 0;
    // The answer to what is no request.
    virtual Response refuse(const Problem& problem, const std::string& client) = 0;
};

}  // namespace waybreaker::server
