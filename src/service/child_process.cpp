#include "service/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace waybreaker::service {
namespace {

constexpr int between_looks = 20;  // milliseconds, at the stop

class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { close(); }
    int number() const { return number_; }
    void close() {
        if (const int number = std::exchange(number_, -1); number >= 0) ::close(number);
    }

  private:
    int number_;
};

void require(int error, const char* what) {
    if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

class Child {
  public:
    explicit Child(pid_t id) : id_(id) {}
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        if (id_ != 0) end();
    }
    // Its status. Does not change that of one that is ending by itself.
    int end() {
        kill(id_, SIGKILL);
        int status = 0;
        while (waitpid(id_, &status, 0) < 0 && errno == EINTR) continue;
        id_ = 0;
        return status;
    }

  private:
    pid_t id_;
};

// The end of a pair of sockets as its standard input and output: unlike a pipe, it tells us without a signal if the
// child is gone.
pid_t started(const std::vector<std::string>& command, int end) {
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions{};
    require(posix_spawn_file_actions_init(&actions), "posix_spawn_file_actions_init");
    int error = posix_spawn_file_actions_adddup2(&actions, end, STDIN_FILENO);
    if (error == 0) error = posix_spawn_file_actions_adddup2(&actions, end, STDOUT_FILENO);
    if (error == 0) error = posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    if (error == 0) error = posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    pid_t child = 0;
    if (error == 0) error = posix_spawn(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    require(error, "a process cannot be started");
    return child;
}

// What is said to the child and by it.
class Talk {
  public:
    Talk(int wire, std::span<const std::string_view> input) : wire_(wire), input_(input) { skip_empty(); }

    // False once the child says no more.
    bool go_on(std::string& said) {
        std::array<pollfd, 1> watched{{{wire_, short(input_.empty() ? POLLIN : POLLIN | POLLOUT), 0}}};
        if (poll(watched.data(), 1, between_looks) <= 0) return true;
        if ((watched[0].revents & POLLOUT) != 0) tell();
        return (watched[0].revents & (POLLIN | POLLHUP | POLLERR)) == 0 || hear(said);
    }

  private:
    void tell() {
        const ssize_t sent =
            send(wire_, input_.front().data() + sent_, input_.front().size() - sent_, MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent < 0 && errno != EAGAIN && errno != EINTR) input_ = {};  // it does not listen
        if (sent > 0) sent_ += std::size_t(sent);
        skip_empty();
    }

    bool hear(std::string& said) {
        std::array<char, 65536> piece{};
        const ssize_t count = recv(wire_, piece.data(), piece.size(), MSG_DONTWAIT);
        if (count > 0) said.append(piece.data(), std::size_t(count));
        return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
    }

    void skip_empty() {
        while (!input_.empty() && sent_ == input_.front().size()) {
            input_ = input_.subspan(1);
            sent_ = 0;
        }
        if (input_.empty()) shutdown(wire_, SHUT_WR);
    }

    int wire_;
    std::span<const std::string_view> input_;
    std::size_t sent_ = 0;  // of the first
};

}  // namespace

ChildEnd run_child(const std::vector<std::string>& command, std::span<const std::string_view> input, std::size_t most,
                   const StopToken& stop) {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) require(errno, "socketpair");
    const Descriptor ours(ends[0]);
    Descriptor theirs(ends[1]);
    Child child(started(command, theirs.number()));
    theirs.close();
    ChildEnd end;
    Talk talk(ours.number(), input);
    while (!end.stopped && end.said.size() <= most && talk.go_on(end.said)) end.stopped = stop.stop_requested();
    end.status = child.end();  // it has said all, or must end
    return end;
}

}  // namespace waybreaker::service
