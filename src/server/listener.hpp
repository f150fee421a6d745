// Listener: httplib's server with a patience that ends. One request a connection; reading it is bounded in time and
// bytes, headers included, so that neither slow nor endless clients hold a thread or fill the memory.
#pragma once

#include <httplib.h>

#include <chrono>
#include <cstddef>

namespace waybreaker::server {

struct Patience {
    std::chrono::milliseconds reading{10000};  // of the whole request
    std::chrono::milliseconds writing{10000};  // of one piece of the answer
    std::size_t bytes = std::size_t{1} << 25;  // of the whole request
};

class Listener : public httplib::Server {
  public:
    explicit Listener(Patience patience) : patience_(patience) {}

    // More clients may wait to be accepted than httplib lets. To be called when bound.
    void lengthen_backlog();

  private:
    bool process_and_close_socket(socket_t socket) override;

    Patience patience_;
};

}  // namespace waybreaker::server
