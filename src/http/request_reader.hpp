// Request reader: parses the bytes that a client sends into requests. Knows nothing of sockets, so that tests and a
// fuzzer can feed it. Our own check (head_check.hpp) and Boost.Beast must both accept the head; Beast parses the body.
//
//     RequestReader reader(limit);
//     reader.put(bytes);
//     while (reader.advance() == RequestReader::State::whole) answer(reader.take());
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "http/message.hpp"

namespace waybreaker::http {

class RequestReader {
  public:
    enum class State {
        idle,  // no bytes of a request yet
        head,  // part of its head
        body,  // the whole head, but not the whole body
        whole
    };

    // `most`: largest body, in bytes.
    explicit RequestReader(std::size_t most);
    ~RequestReader();
    RequestReader(const RequestReader&) = delete;
    RequestReader& operator=(const RequestReader&) = delete;

    void put(std::string_view bytes);
    // Parses as much of a request as is there. Throws Problem if it is malformed; the reader is of no use then.
    State advance();
    // Bytes received and not parsed yet.
    std::size_t waiting() const;

    // The request without its body. Precondition: the state is `body` or `whole`.
    const Request& head() const;
    // The length of the body as its headers state it; empty if it is chunked.
    std::optional<std::uint64_t> length() const;
    // Whether the connection may be kept alive.
    bool may_be_followed() const;
    // Whether the response may be chunked: not for HTTP/1.0.
    bool takes_chunks() const;
    // Whether the client waits for 100 Continue before it sends the body.
    bool expects_continue() const;
    // Bytes of the body that are kept in memory.
    std::size_t body_size() const;
    // Skips the body.
    void drop_body();

    // Precondition: whole. Afterwards the next request can be parsed.
    Request take();

  private:
    class Parser;
    std::size_t most_;
    std::string waiting_;
    std::unique_ptr<Parser> parser_;
};

}  // namespace waybreaker::http
