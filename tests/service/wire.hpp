// A raw connection for tests.
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string>

namespace waybreaker::service {

class Wire {
  public:
    explicit Wire(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(std::uint16_t(port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    }
    ~Wire() { ::close(socket_); }
    Wire(const Wire&) = delete;
    Wire& operator=(const Wire&) = delete;

    bool send(const std::string& text) const {
        return ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL) == ssize_t(text.size());
    }
    // Closes the sending side: the server learns that nothing more comes.
    void end_sending() const { ::shutdown(socket_, SHUT_WR); }
    // All bytes until the server closes the connection.
    std::string rest() const {
        std::string all;
        while (receive(all)) continue;
        return all;
    }
    // All bytes until that text arrives or the server closes the connection.
    std::string until(const std::string& text) const {
        std::string all;
        while (all.find(text) == std::string::npos && receive(all)) continue;
        return all;
    }

  private:
    bool receive(std::string& all) const {
        char piece[4096];
        const ssize_t count = ::recv(socket_, piece, sizeof piece, 0);
        if (count > 0) all.append(piece, std::size_t(count));
        return count > 0;
    }

    int socket_;
};

}  // namespace waybreaker::service
