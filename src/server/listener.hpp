// Listener: httplib's server, with connections that serve one request after the other, and with what it does not do by
// itself: clients are given so much patience, requests end where their headers say, and answers are compressed by who
// makes them.
#pragma once

#include <httplib.h>

#include <cstddef>

#include "server/client_stream.hpp"
#include "server/connections.hpp"

namespace waybreaker::server {

class Listener : public httplib::Server {
  public:
    Listener(Patience patience, std::size_t most_connections);

    // More clients may wait to be accepted than httplib lets. To be called when bound.
    void lengthen_backlog();

  private:
    class Queue;
    bool process_and_close_socket(socket_t socket) override;
    bool serve_request(ClientStream& client);

    Patience patience_;
    Connections connections_;
};

// Whether the client of a request that is being answered is still there.
bool client_is_there(const httplib::Request& request);

}  // namespace waybreaker::server
