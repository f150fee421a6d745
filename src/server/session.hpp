// Session: one connection, from accept to close. For the listener alone: whoever includes this includes Asio.
#pragma once

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <memory>
#include <string>

#include "server/exchange.hpp"
#include "server/listener.hpp"
#include "server/request_reader.hpp"

namespace waybreaker::server {

class Session;

// Where sessions live.
class SessionHost {
  public:
    virtual ~SessionHost() = default;
    virtual const ListenerOptions& options() const = 0;
    virtual Reception& reception() = 0;
    virtual void work_on(std::function<void()> task) = 0;  // on a thread that may block
    virtual bool wants_places() const = 0;                 // somebody waits for one, or this is the end
    // Memory for bodies, of all sessions together. Whether there is so much more; it is then theirs until given back.
    virtual bool take_memory(std::size_t bytes) = 0;
    virtual void give_back(std::size_t bytes) = 0;
    virtual void settled(Session& session) = 0;  // it has answered
    virtual void left(Session& session) = 0;     // it has closed
};

// All but Exchange's is called on the thread that reads and writes.
class Session : public Exchange, public std::enable_shared_from_this<Session> {
  public:
    using Clock = std::chrono::steady_clock;
    enum class Phase { idle, reading, serving, writing, closing, closed };

    Session(boost::asio::ip::tcp::socket socket, SessionHost& host);

    void begin();
    void close();
    // Answers with 503 and closes.
    void turn_away();

    Phase phase() const { return phase_; }
    Clock::time_point since() const { return since_; }  // when the phase began
    const boost::asio::ip::address& client() const { return client_; }
    // Whether closing it loses no request that has come.
    bool may_be_closed() const;
    // Whether the head of a request has come whose answer is not yet taken.
    bool has_begun() const;

    void wait(Waiting waiting) override;
    void answer(Response response) override;

  private:
    void enter(Phase phase);
    void expire_in(std::chrono::milliseconds time);
    void expired();
    void receive();
    void received(std::size_t count, bool failed);

    void advance();
    bool proceed();  // whether there is more to be done with what has come
    void begin_reading();
    bool admit();
    void take_memory();
    void give_leave();
    void serve();

    void start(Response response);
    std::chrono::seconds idle_seconds() const;
    void write_next();
    void written(std::size_t count, bool failed);
    void close_gently();

    void begin_events();
    void tick();
    void send_piece(std::string piece);
    void piece_sent(bool failed);

    boost::asio::ip::tcp::socket socket_;
    SessionHost& host_;
    boost::asio::ip::address client_;
    boost::asio::steady_timer timer_;
    RequestReader reader_;
    std::array<char, 16384> buffer_{};
    bool receiving_ = false;
    bool input_ended_ = false;
    std::size_t passed_over_ = 0;  // bytes after the last answer
    Phase phase_ = Phase::idle;
    Clock::time_point since_;

    // The request:
    bool first_ = true;
    bool admitted_ = false;
    bool refused_ = false;  // answered before its body has come
    bool quick_ = false;
    std::size_t memory_ = 0;  // taken for its body
    bool gave_leave_ = false;
    bool last_ = false;  // no other may follow
    bool without_body_ = false;
    bool takes_chunks_ = true;
    Clock::time_point began_;

    // Its answer:
    Waiting waiting_;
    bool waits_ = false;
    std::string head_;
    Body body_;
    std::size_t sent_ = 0;  // of the body
    Clock::time_point write_began_;
    Clock::duration waited_{0};  // for the client to take it
    std::string piece_;          // of events, on its way
    bool sending_piece_ = false;
    std::optional<std::string> last_piece_;
};

}  // namespace waybreaker::server
