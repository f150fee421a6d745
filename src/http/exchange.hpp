// Exchange: the interface between the transport and the request handler.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "http/message.hpp"
#include "http/problem.hpp"

namespace waybreaker::http {

// What happens while a client waits for its response. Called on the I/O thread.
struct Waiting {
    bool events = false;  // stream what `tick` returns, and finally the body passed to Exchange::answer
    // Called four times a second; not while the client has not taken what came before.
    std::function<std::string()> tick = [] { return std::string(); };
    std::function<void()> gone = [] {};  // the client has disconnected
    // Of events that nothing answers: whether they have ended. Such a stream is closed when others need its place, for
    // its client asks again for what comes next.
    std::function<bool()> over = {};
};

// Thread-safe.
class Exchange {
  public:
    virtual ~Exchange() = default;
    // At most once, before `answer`.
    virtual void wait(Waiting waiting) = 0;
    virtual void answer(Response response) = 0;
};

struct Admission {
    std::optional<Response> refusal = {};
    bool body = true;    // whether to read the body
    bool quick = false;  // handle it on the I/O thread: it reads no files and takes no time
};

class RequestHandler {
  public:
    virtual ~RequestHandler() = default;
    // Whether to accept a request, given its head. `length`: of the body; empty if it is chunked.
    virtual Admission admit(const Request& head, std::optional<std::uint64_t> length) = 0;
    // Responds through `exchange`, at once or later.
    virtual void serve(Request request, std::shared_ptr<Exchange> exchange) = 0;
    // The response to something that is not a valid request.
    virtual Response refuse(const Problem& problem, const std::string& client) = 0;
};

}  // namespace waybreaker::http
