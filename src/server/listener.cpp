#include "server/listener.hpp"

#include <fmt/chrono.h>
#include <sys/socket.h>

#include "server/framing.hpp"
#include "server/gzip.hpp"

namespace waybreaker::server {
namespace {

// What is left of a body that nobody wanted is passed over if it is so short; else the connection ends.
constexpr std::uint64_t most_skipped = 65536;

// httplib compresses whatever it can for whoever takes it, which costs more than most plans do. It looks for the word
// in lower case only.
void leave_compression_to_us(httplib::Request& request) {
    const bool taken = accepts_gzip(request.get_header_value("Accept-Encoding"));
    request.headers.erase("Accept-Encoding");
    if (taken) request.set_header("Accept-Encoding", "GZIP");
}

// Now, as HTTP writes it (RFC 9110, 5.6.7).
std::string date() {
    const auto now = std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::system_clock::now());
    return fmt::format("{:%a, %d %b %Y %H:%M:%S} GMT", fmt::gmtime(now));
}

}  // namespace

class Listener::Queue : public httplib::TaskQueue {
  public:
    explicit Queue(Connections& connections) : connections_(connections) {}
    void enqueue(std::function<void()> serve) override { connections_.open(std::move(serve)); }
    void shutdown() override { connections_.close(); }

  private:
    Connections& connections_;
};

Listener::Listener(Patience patience, std::size_t most_connections)
    : patience_(patience), connections_(most_connections) {
    new_task_queue = [this] { return new Queue(connections_); };
    set_keep_alive_timeout(std::chrono::duration_cast<std::chrono::seconds>(patience_.idle).count());
    constexpr std::size_t most_requests = 10000;
    set_keep_alive_max_count(most_requests);  // both are told to clients
    set_post_routing_handler([](const httplib::Request&, httplib::Response& response) {
        response.set_header("Date", date());
        if (response.has_header("Connection")) response.headers.erase("Keep-Alive");
        // Answers without a body have no length either (RFC 9110, 8.6).
        if (response.status == no_content || response.status == not_modified) response.headers.erase("Content-Length");
    });
}

void Listener::lengthen_backlog() {
    constexpr int backlog = 1024;
    ::listen(svr_sock_, backlog);
}

bool Listener::process_and_close_socket(socket_t socket) {
    ClientStream client(socket, patience_);
    bool waits = true;
    for (std::size_t served = 1; waits && serve_request(client) && served < keep_alive_max_count_; ++served) {
        waits = connections_.begin_waiting(socket) && client.wait_for_request();
        // Whose request came as it was sent away is answered all the same.
        if (!connections_.end_waiting(socket)) client.take_for_there();
        client.begin_request();
    }
    close_gently(socket);
    return true;
}

// Whether another request can come.
bool Listener::serve_request(ClientStream& client) {
    bool last = true;
    std::uint64_t headers = 0;
    std::uint64_t body = 0;
    const auto prepare = [&](httplib::Request& request) {
        headers = client.taken();
        body = body_length(request);
        last = !may_be_followed(request) || body > most_skipped || connections_.must_leave();
        if (last) {
            request.headers.erase("Connection");
            request.set_header("Connection", "close");  // so that the answer says it too
        }
        // httplib would read such a body to the connection's end.
        if (!request.has_header("Content-Length") && !request.has_header("Transfer-Encoding")) {
            request.set_header("Content-Length", "0");
        }
        leave_compression_to_us(request);
        // Parts of an answer are never given: with many overlapping ones a small request would ask for much.
        request.ranges.clear();
        request.progress = [&client](std::uint64_t, std::uint64_t) { return client.is_there(); };
    };
    bool closed = false;
    const bool answered = process_request(client, false, closed, prepare);
    return answered && !last && client.skip(headers + body - client.taken());
}

bool client_is_there(const httplib::Request& request) {
    return request.progress(0, 0);
}

}  // namespace waybreaker::server
