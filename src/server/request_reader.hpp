// Request reader: makes requests of the bytes that a client sends, one after the other. Knows nothing of sockets, so
// that a table of bad requests and a fuzzer can be put to it. The head is checked by ours (head_check.hpp), then read
// by Boost.Beast, and the body by Beast alone: both must take it.
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

#include "server/message.hpp"

namespace waybreaker::server {

class RequestReader {
  public:
    enum class State {
        idle,  // nothing of a request has come
        head,  // a part of its head
        body,  // its head, but not all of its body
        whole
    };

    // `most`: bytes that a body may have.
    explicit RequestReader(std::size_t most);
    ~RequestReader();
    RequestReader(const RequestReader&) = delete;
    RequestReader& operator=(const RequestReader&) = delete;

    void put(std::string_view bytes);
    // Reads as much of a request as is there. Throws Problem if it is none; then all is over.
    State advance();
    // Bytes that have come and are not yet read.
    std::size_t waiting() const;

    // From the state `body` on; the rest of the request, but not its body.
    const Request& head() const;
    // What its headers say of the body's length; nothing if it comes in chunks.
    std::optional<std::uint64_t> length() const;
    // Whether another request may follow on the connection.
    bool may_be_followed() const;
    // Whether an answer may come in chunks: not to HTTP/1.0.
    bool takes_chunks() const;
    // Whether the client waits to be told that its body is wanted.
    bool waits_for_leave() const;
    // Bytes of the body that have come and are kept.
    std::size_t body_size() const;
    // The body is not wanted: it is passed over.
    void drop_body();

    // Precondition: whole. Afterwards the next request can be read.
    Request take();

  private:
    class Parser;
    std::size_t most_;
    std::string waiting_;
    std::unique_ptr<Parser> parser_;
};

}  // namespace waybreaker::server
