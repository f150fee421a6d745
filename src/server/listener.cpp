#include "server/listener.hpp"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

namespace waybreaker::server {
namespace {

using Clock = std::chrono::steady_clock;

bool ready(int socket, short event, std::chrono::milliseconds time) {
    pollfd wanted{socket, event, 0};
    return ::poll(&wanted, 1, int(std::max<std::int64_t>(time.count(), 0))) > 0 && (wanted.revents & event) != 0;
}

class Connection : public httplib::Stream {
  public:
    Connection(int socket, const Patience& patience)
        : socket_(socket), patience_(patience), deadline_(Clock::now() + patience.reading) {}

    bool is_readable() const override { return begin_ < end_ || ready(socket_, POLLIN, left()); }

    // Whether the client is still there.
    bool is_writable() const override {
        char next = 0;
        const ssize_t peeked = ::recv(socket_, &next, 1, MSG_PEEK | MSG_DONTWAIT);
        const bool gone = peeked == 0 || (peeked < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR);
        return !gone && ready(socket_, POLLOUT, patience_.writing);
    }

    ssize_t read(char* target, std::size_t size) override {
        if (begin_ == end_ && !fill()) return -1;
        const std::size_t count = std::min(size, end_ - begin_);
        std::copy_n(buffer_.data() + begin_, count, target);
        begin_ += count;
        return ssize_t(count);
    }

    ssize_t write(const char* bytes, std::size_t size) override {
        if (!ready(socket_, POLLOUT, patience_.writing)) return -1;
        return ::send(socket_, bytes, size, MSG_NOSIGNAL);
    }

    void get_remote_ip_and_port(std::string& ip, int& port) const override { address(::getpeername, ip, port); }
    void get_local_ip_and_port(std::string& ip, int& port) const override { address(::getsockname, ip, port); }
    socket_t socket() const override { return socket_; }

  private:
    std::chrono::milliseconds left() const {
        return std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - Clock::now());
    }

    bool fill() {
        if (total_ > patience_.bytes || !ready(socket_, POLLIN, left())) return false;
        const ssize_t count = ::recv(socket_, buffer_.data(), buffer_.size(), 0);
        if (count <= 0) return false;
        begin_ = 0;
        end_ = std::size_t(count);
        total_ += end_;
        return true;
    }

    template <class Ask>
    void address(Ask ask, std::string& ip, int& port) const {
        sockaddr_storage storage{};
        socklen_t size = sizeof storage;
        if (ask(socket_, reinterpret_cast<sockaddr*>(&storage), &size) != 0) return;
        std::array<char, INET6_ADDRSTRLEN> text{};
        if (storage.ss_family == AF_INET) {
            const auto& v4 = reinterpret_cast<const sockaddr_in&>(storage);
            ::inet_ntop(AF_INET, &v4.sin_addr, text.data(), text.size());
            port = ntohs(v4.sin_port);
        } else if (storage.ss_family == AF_INET6) {
            const auto& v6 = reinterpret_cast<const sockaddr_in6&>(storage);
            ::inet_ntop(AF_INET6, &v6.sin6_addr, text.data(), text.size());
            port = ntohs(v6.sin6_port);
        }
        ip = text.data();
    }

    int socket_;
    Patience patience_;
    Clock::time_point deadline_;
    std::array<char, 16384> buffer_{};
    std::size_t begin_ = 0;
    std::size_t end_ = 0;
    std::size_t total_ = 0;
};

// A socket closed with bytes unread resets the connection, and the client may lose its answer: so those that are
// already on their way are read first, for a moment.
void close_gently(int socket) {
    constexpr std::chrono::milliseconds moment(200);
    constexpr int most_pieces = 64;
    ::shutdown(socket, SHUT_WR);
    std::array<char, 16384> rest{};
    for (int i = 0; i < most_pieces; ++i) {
        if (!ready(socket, POLLIN, moment) || ::recv(socket, rest.data(), rest.size(), MSG_DONTWAIT) <= 0) break;
    }
    ::close(socket);
}

}  // namespace

void Listener::lengthen_backlog() {
    constexpr int backlog = 1024;
    ::listen(svr_sock_, backlog);
}

bool Listener::process_and_close_socket(socket_t socket) {
    Connection connection(socket, patience_);
    bool closed = false;
    // Parts of an answer are never given: with many overlapping ones a small request would ask for much.
    const bool served = process_request(connection, true, closed, [](httplib::Request& r) { r.ranges.clear(); });
    close_gently(socket);
    return served;
}

}  // namespace waybreaker::server
