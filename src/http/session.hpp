// Session: one connection, from accept to close. Internal to the listener, as it includes Asio.
#pragma once

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "http/exchange.hpp"
#include "http/listener.hpp"
#include "http/request_reader.hpp"

namespace waybreaker::http {

class Session;

// How long a response may take before it is asked whether a client that sends nothing more is still there.
inline constexpr std::chrono::milliseconds before_probe(20);

inline constexpr std::string_view continue_text = "HTTP/1.1 100 Continue\r\n\r\n";

// The owner of sessions.
class SessionHost {
  public:
    virtual ~SessionHost() = default;
    virtual const ListenerOptions& options() const = 0;
    virtual RequestHandler& handler() = 0;
    virtual void run_task(std::function<void()> task) = 0;  // on a thread that may block
    virtual bool needs_slots() const = 0;                   // a new connection waits for a slot, or the server stops
    // Takes memory for bodies from what all sessions share; false if that is not left.
    virtual bool take_memory(std::size_t bytes) = 0;
    virtual void release_memory(std::size_t bytes) = 0;
    virtual void on_answered(Session& session) = 0;  // the response is sent
    virtual void on_closed(Session& session) = 0;    // the connection is closed
};

// All members but those of Exchange are called on the I/O thread.
class Session : public Exchange, public std::enable_shared_from_this<Session> {
  public:
    using Clock = std::chrono::steady_clock;
    enum class Phase { idle, reading, serving, writing, closing, closed };

    Session(boost::asio::ip::tcp::socket socket, SessionHost& host);

    void begin();
    void close();
    // Responds with 503 and closes.
    void reject();

    Phase phase() const { return phase_; }
    Clock::time_point since() const { return since_; }  // when the phase began
    const boost::asio::ip::address& client() const { return client_; }
    // Whether it can be closed without losing a complete request.
    bool may_be_closed() const;
    // Whether events are sent that have no end of their own.
    bool streams() const { return phase_ == Phase::serving && bool(waiting_.over); }
    // Whether a request is in progress: from its head to the end of its response.
    bool has_begun() const;

    void wait(Waiting waiting) override;
    void answer(Response response) override;

  private:
    void enter(Phase phase);
    void expire_in(std::chrono::milliseconds time);
    void expired();
    void receive();
    void received(std::size_t count, const boost::system::error_code& error);
    void end_input();

    void advance();
    bool proceed();  // whether there is more to do with the bytes received
    void begin_reading();
    bool admit();
    void take_memory();
    void send_continue();
    void serve();

    void start(Response response);
    std::chrono::seconds idle_seconds() const;
    void write_next();
    void written(std::size_t count, bool failed);
    void close_gently();

    void begin_events();
    void tick();
    void end_stream();
    void probe();
    void send_piece(const std::string& piece);
    void write_piece();
    void piece_sent(bool failed);

    boost::asio::ip::tcp::socket socket_;
    SessionHost& host_;
    boost::asio::ip::address client_;
    boost::asio::steady_timer timer_;
    RequestReader reader_;
    std::array<char, 16384> buffer_{};
    bool receiving_ = false;
    bool input_ended_ = false;  // the client has closed its sending side, or is gone
    bool gone_ = false;
    std::size_t discarded_ = 0;  // bytes after the last response
    Phase phase_ = Phase::idle;
    Clock::time_point since_;

    // The request:
    bool first_ = true;
    bool admitted_ = false;
    bool refused_ = false;  // answered before its body arrived
    bool quick_ = false;
    std::size_t memory_ = 0;  // for its body
    bool sent_continue_ = false;
    bool last_ = false;  // close after the response
    bool without_body_ = false;
    bool takes_chunks_ = true;
    Clock::time_point began_;

    // The response:
    Waiting waiting_;
    bool waits_ = false;
    bool probed_ = false;
    std::optional<Response> late_;  // made while a probe is being written
    std::string head_;
    Body body_;
    std::size_t sent_ = 0;  // of the body
    Clock::time_point write_began_;
    Clock::duration waited_{0};  // time spent writing
    std::string piece_;          // events, or a probe, being written
    bool sending_piece_ = false;
    std::optional<Body> last_piece_;
};

}  // namespace waybreaker::http
