#include "http/listener.hpp"

#include <algorithm>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "http/client_address.hpp"
#include "http/session.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::http {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using Error = boost::system::error_code;

constexpr int backlog = 1024;               // clients waiting to be accepted
constexpr std::size_t handler_threads = 4;  // several, as handlers may read files
constexpr std::chrono::milliseconds pause(100);

[[noreturn]] void fail(const ListenerOptions& options) {
    throw InputError("cannot listen on " + options.host + " port " + std::to_string(options.port) +
                     ": it is taken, or no address of this machine");
}

// Binds to the first available address of the host.
tcp::acceptor bound(asio::io_context& context, const ListenerOptions& options) {
    Error error;
    tcp::resolver resolver(context);
    const auto found = resolver.resolve(options.host, std::to_string(options.port), tcp::resolver::passive, error);
    for (const auto& entry : found) {
        tcp::acceptor acceptor(context);
        acceptor.open(entry.endpoint().protocol(), error);
        if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
        if (!error) acceptor.bind(entry.endpoint(), error);
        if (!error) acceptor.listen(backlog, error);
        if (!error) return acceptor;
    }
    fail(options);
}

}  // namespace

class Listener::Impl : public SessionHost {
  public:
    Impl(ListenerOptions options, RequestHandler& handler)
        : options_(std::move(options)),
          handler_(handler),
          acceptor_(bound(context_, options_)),
          pause_(context_),
          port_(acceptor_.local_endpoint().port()),
          pool_(handler_threads) {}

    int port() const { return port_; }
    void run();
    void stop() {
        asio::post(context_, [this] { drain(); });
    }

    const ListenerOptions& options() const override { return options_; }
    RequestHandler& handler() override { return handler_; }
    void run_task(std::function<void()> task) override { asio::post(pool_, std::move(task)); }
    bool needs_slots() const override { return draining_ || pending_.has_value(); }
    bool take_memory(std::size_t bytes) override;
    void release_memory(std::size_t bytes) override;
    void on_answered(Session& session) override;
    void on_closed(Session& session) override;

  private:
    using Client = asio::ip::address;

    void accept();
    void accepted(const Error& error, tcp::socket socket);
    void admit(tcp::socket socket);
    void drain();
    std::size_t limit_for(const Client& client) const;
    // Closes one of these sessions that can be closed without losing a request. Whether there was one.
    static bool close_one_of(const std::vector<Session*>& sessions);
    std::vector<Session*> sessions_of(const Client& client) const;
    // The sessions of the client that has the most.
    std::vector<Session*> largest_group() const;

    ListenerOptions options_;
    RequestHandler& handler_;
    asio::io_context context_{1};  // one thread
    asio::executor_work_guard<asio::io_context::executor_type> work_{context_.get_executor()};
    tcp::acceptor acceptor_;
    asio::steady_timer pause_;
    int port_;
    std::map<Session*, std::shared_ptr<Session>> sessions_;
    std::optional<tcp::socket> pending_;  // accepted, waits for a slot
    bool draining_ = false;
    std::size_t memory_ = 0;  // for bodies
    asio::thread_pool pool_;
};

void Listener::Impl::run() {
    accept();
    context_.run();
    pool_.join();
}

void Listener::Impl::accept() {
    if (draining_) return;
    acceptor_.async_accept([this](const Error& error, tcp::socket socket) { accepted(error, std::move(socket)); });
}

void Listener::Impl::accepted(const Error& error, tcp::socket socket) {
    if (draining_) return;
    if (!error) return admit(std::move(socket));
    // No file descriptor is left, or the client is gone already.
    if (close_one_of(largest_group())) return accept();
    pause_.expires_after(pause);
    pause_.async_wait([this](const Error&) { accept(); });
}

void Listener::Impl::admit(tcp::socket socket) {
    Error error;
    const Client client = client_of(socket.remote_endpoint(error).address());
    const bool too_many = sessions_of(client).size() >= limit_for(client);
    const bool may_stay = !too_many || close_one_of(sessions_of(client));
    if (may_stay && sessions_.size() >= options_.connections && !close_one_of(largest_group())) {
        pending_.emplace(std::move(socket));
        return;
    }
    const auto session = std::make_shared<Session>(std::move(socket), *this);
    sessions_.emplace(session.get(), session);
    may_stay ? session->begin() : session->reject();
    accept();
}

bool Listener::Impl::take_memory(std::size_t bytes) {
    constexpr std::size_t largest_at_once = 4;
    if (bytes > largest_at_once * options_.body_bytes - memory_) return false;
    if (!options_.hold(memory_ + bytes)) return false;
    memory_ += bytes;
    return true;
}

void Listener::Impl::release_memory(std::size_t bytes) {
    memory_ -= bytes;
    options_.hold(memory_);
}

void Listener::Impl::on_answered(Session& session) {
    if (draining_) return session.close();
    if (pending_) close_one_of(largest_group());
}

void Listener::Impl::on_closed(Session& session) {
    sessions_.erase(&session);
    if (auto next = std::exchange(pending_, {})) admit(std::move(*next));
    if (draining_ && sessions_.empty()) work_.reset();
}

std::size_t Listener::Impl::limit_for(const Client& client) const {
    if (options_.connections_of_client > 0) return options_.connections_of_client;
    return client.is_loopback() ? options_.connections : std::max<std::size_t>(options_.connections / 2, 1);
}

// Sessions between two requests are closed first, then those whose request is incomplete, then streams of events; of
// each the one that has been in that phase longest.
bool Listener::Impl::close_one_of(const std::vector<Session*>& sessions) {
    const auto order = [](const Session* session) {
        return std::tuple(session->streams(), session->phase() != Session::Phase::idle, session->since());
    };
    Session* victim = nullptr;
    for (Session* session : sessions) {
        if (session->may_be_closed() && (victim == nullptr || order(session) < order(victim))) victim = session;
    }
    if (victim != nullptr) victim->close();
    return victim != nullptr;
}

std::vector<Session*> Listener::Impl::sessions_of(const Client& client) const {
    std::vector<Session*> found;
    for (const auto& [session, owner] : sessions_) {
        if (client_of(session->client()) == client) found.push_back(session);
    }
    return found;
}

std::vector<Session*> Listener::Impl::largest_group() const {
    std::map<Client, std::vector<Session*>> groups;
    for (const auto& [session, owner] : sessions_) {
        if (session->may_be_closed()) groups[client_of(session->client())].push_back(session);
    }
    const auto largest = std::max_element(groups.begin(), groups.end(), [](const auto& one, const auto& other) {
        return one.second.size() < other.second.size();
    });
    return largest == groups.end() ? std::vector<Session*>() : largest->second;
}

void Listener::Impl::drain() {
    if (std::exchange(draining_, true)) return;
    Error ignored;
    acceptor_.close(ignored);
    pause_.cancel();
    pending_.reset();
    std::vector<std::shared_ptr<Session>> sessions;
    for (const auto& [session, owner] : sessions_) sessions.push_back(owner);
    for (const auto& session : sessions) {
        if (!session->has_begun()) session->close();
    }
    if (sessions_.empty()) work_.reset();
}

Listener::Listener(ListenerOptions options, RequestHandler& handler)
    : impl_(std::make_unique<Impl>(std::move(options), handler)) {}
Listener::~Listener() = default;

int Listener::port() const {
    return impl_->port();
}

void Listener::run() {
    impl_->run();
}

void Listener::stop() {
    impl_->stop();
}

}  // namespace waybreaker::http
