#include "server/client_stream.hpp"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace waybreaker::server {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

bool ready(int socket, short event, milliseconds time) {
    pollfd wanted{socket, event, 0};
    return ::poll(&wanted, 1, int(std::max<std::int64_t>(time.count(), 0))) > 0 && (wanted.revents & event) != 0;
}

template <class Ask>
void address(Ask ask, int socket, std::string& ip, int& port) {
    sockaddr_storage storage{};
    socklen_t size = sizeof storage;
    if (ask(socket, reinterpret_cast<sockaddr*>(&storage), &size) != 0) return;
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

}  // namespace

void ClientStream::begin_request() {
    deadline_ = Clock::now() + patience_.reading;
    taken_ = 0;
    written_ = 0;
    waited_ = {};
}

bool ClientStream::wait_for_request() const {
    if (begin_ < end_) return true;
    char next = 0;
    return ready(socket_, POLLIN, patience_.idle) && ::recv(socket_, &next, 1, MSG_PEEK | MSG_DONTWAIT) > 0;
}

bool ClientStream::skip(std::uint64_t count) {
    while (count > 0) {
        if (begin_ == end_ && !fill()) return false;
        const std::size_t piece = std::size_t(std::min<std::uint64_t>(count, end_ - begin_));
        begin_ += piece;
        taken_ += piece;
        count -= piece;
    }
    return true;
}

bool ClientStream::is_there() const {
    if (taken_for_there_) return true;
    char next = 0;
    const ssize_t peeked = ::recv(socket_, &next, 1, MSG_PEEK | MSG_DONTWAIT);
    return peeked > 0 || (peeked < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR));
}

bool ClientStream::is_readable() const {
    return begin_ < end_ || ready(socket_, POLLIN, left());
}

bool ClientStream::is_writable() const {
    return is_there() && ready(socket_, POLLOUT, patience_.writing);
}

ssize_t ClientStream::read(char* target, std::size_t size) {
    if (begin_ == end_ && !fill()) return -1;
    const std::size_t count = std::min(size, end_ - begin_);
    std::copy_n(buffer_.data() + begin_, count, target);
    begin_ += count;
    taken_ += count;
    return ssize_t(count);
}

ssize_t ClientStream::write(const char* bytes, std::size_t size) {
    constexpr std::uint64_t slowest = 64;  // bytes a millisecond
    const milliseconds allowed = patience_.writing + milliseconds(written_ / slowest);
    const Clock::time_point began = Clock::now();
    const bool taken = ready(socket_, POLLOUT, allowed - std::chrono::duration_cast<milliseconds>(waited_));
    waited_ += Clock::now() - began;
    if (!taken) return -1;
    const ssize_t count = ::send(socket_, bytes, size, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count < 0) return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR ? 0 : -1;
    written_ += std::uint64_t(count);
    return count;
}

void ClientStream::get_remote_ip_and_port(std::string& ip, int& port) const {
    address(::getpeername, socket_, ip, port);
}

void ClientStream::get_local_ip_and_port(std::string& ip, int& port) const {
    address(::getsockname, socket_, ip, port);
}

milliseconds ClientStream::left() const {
    return std::chrono::duration_cast<milliseconds>(deadline_ - Clock::now());
}

bool ClientStream::fill() {
    if (taken_ > patience_.bytes || !ready(socket_, POLLIN, left())) return false;
    const ssize_t count = ::recv(socket_, buffer_.data(), buffer_.size(), 0);
    if (count <= 0) return false;
    begin_ = 0;
    end_ = std::size_t(count);
    return true;
}

void close_gently(int socket) {
    constexpr milliseconds moment(200);
    constexpr int most_pieces = 64;
    ::shutdown(socket, SHUT_WR);
    std::array<char, 16384> rest{};
    for (int i = 0; i < most_pieces; ++i) {
        if (!ready(socket, POLLIN, moment) || ::recv(socket, rest.data(), rest.size(), MSG_DONTWAIT) <= 0) break;
    }
    ::close(socket);
}

}  // namespace waybreaker::server
