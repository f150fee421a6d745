// Session: writing responses.
#include <fmt/format.h>

#include <boost/asio/dispatch.hpp>
#include <boost/asio/write.hpp>
#include <utility>

#include "http/response_head.hpp"
#include "http/session.hpp"

namespace waybreaker::http {
namespace {

namespace asio = boost::asio;
using Error = boost::system::error_code;
using std::chrono::milliseconds;

constexpr milliseconds between_ticks(250);
constexpr std::size_t piece_size = 65536;

// An empty one would be the last.
std::string chunk(const std::string& piece) {
    if (piece.empty()) return "";
    return fmt::format("{:x}\r\n{}\r\n", piece.size(), piece);
}

}  // namespace

void Session::answer(Response response) {
    asio::dispatch(socket_.get_executor(), [self = shared_from_this(), response = std::move(response)]() mutable {
        if (self->phase_ != Phase::serving) return;
        if (!self->waiting_.events && self->sending_piece_) {
            self->late_ = std::move(response);
            return;
        }
        if (!self->waiting_.events) return self->start(std::move(response));
        self->waits_ = false;
        self->last_piece_ = std::move(response.body);
        if (!self->sending_piece_) self->piece_sent(false);
    });
}

void Session::start(Response response) {
    host_.release_memory(std::exchange(memory_, 0));
    waits_ = false;
    waiting_ = {};
    last_ = last_ || host_.needs_slots();
    head_ = response_head(response, {.usual = host_.options().headers, .last = last_, .idle = idle_seconds()});
    body_ = without_body_ ? Body() : std::move(response.body);
    sent_ = 0;
    waited_ = {};
    enter(Phase::writing);
    write_next();
}

std::chrono::seconds Session::idle_seconds() const {
    return std::chrono::duration_cast<std::chrono::seconds>(host_.options().timeouts.idle);
}

// Piece by piece, to detect clients that do not take their response.
void Session::write_next() {
    constexpr std::size_t slowest = 64;  // bytes a millisecond
    const std::string_view piece = body_.bytes().substr(sent_, piece_size);
    const std::array<asio::const_buffer, 2> buffers{asio::buffer(head_), asio::buffer(piece.data(), piece.size())};
    const auto waited = std::chrono::duration_cast<milliseconds>(waited_);
    expire_in(host_.options().timeouts.writing + milliseconds(sent_ / slowest) - waited);
    write_began_ = Clock::now();
    asio::async_write(socket_, buffers,
                      [self = shared_from_this(), size = piece.size()](const Error& error, std::size_t) {
                          self->written(size, bool(error));
                      });
}

void Session::written(std::size_t count, bool failed) {
    if (phase_ != Phase::writing) return;
    if (failed) return close();
    waited_ += Clock::now() - write_began_;
    head_.clear();
    sent_ += count;
    if (sent_ < body_.bytes().size()) return write_next();
    body_ = {};
    if (last_) return close_gently();
    without_body_ = false;
    first_ = false;
    advance();
    if (phase_ == Phase::idle) host_.on_answered(*this);
}

// Closing a socket with unread bytes resets the connection, and the client may lose its response: so read what is
// already in flight for a moment first.
void Session::close_gently() {
    constexpr milliseconds moment(500);
    enter(Phase::closing);
    Error ignored;
    socket_.shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
    if (input_ended_) return close();
    expire_in(moment);
    receive();
}

void Session::wait(Waiting waiting) {
    asio::dispatch(socket_.get_executor(), [self = shared_from_this(), waiting = std::move(waiting)]() mutable {
        if (self->phase_ != Phase::serving || self->gone_) {
            waiting.gone();
            return self->close();
        }
        self->waiting_ = std::move(waiting);
        self->waits_ = true;
        self->probed_ = false;
        if (self->waiting_.events) return self->begin_events();
        self->expire_in(self->input_ended_ ? before_probe : between_ticks);
    });
}

void Session::begin_events() {
    last_ = last_ || !takes_chunks_ || host_.needs_slots();
    Response response;
    response.type = "text/event-stream";
    head_ =
        response_head(response, {.usual = host_.options().headers,
                                 .last = last_,
                                 .idle = idle_seconds(),
                                 .length = takes_chunks_ ? Delivery::Length::chunks : Delivery::Length::until_the_end});
    tick();
}

void Session::tick() {
    expire_in(between_ticks);
    if (sending_piece_) {
        if (Clock::now() - write_began_ > host_.options().timeouts.writing) close();
        return;
    }
    std::string text = waiting_.tick();
    if (!text.empty() || !head_.empty()) {
        send_piece(text);
    } else if (waiting_.over && waiting_.over()) {
        end_stream();
    } else if (!waiting_.events && input_ended_ && takes_chunks_ && !std::exchange(probed_, true)) {
        probe();
    }
}

void Session::end_stream() {
    waits_ = false;
    last_piece_ = Body();
    piece_sent(false);
}

// Sends what every client of HTTP/1.1 skips (RFC 9110, 15.2), once, so that one that is gone resets the connection.
void Session::probe() {
    piece_ = continue_text;
    write_piece();
}

void Session::send_piece(const std::string& piece) {
    piece_ = std::exchange(head_, {}) + (takes_chunks_ ? chunk(piece) : piece);
    write_piece();
}

void Session::write_piece() {
    sending_piece_ = true;
    write_began_ = Clock::now();
    asio::async_write(socket_, asio::buffer(piece_),
                      [self = shared_from_this()](const Error& error, std::size_t) { self->piece_sent(bool(error)); });
}

void Session::piece_sent(bool failed) {
    sending_piece_ = false;
    if (phase_ != Phase::serving) return;
    if (failed) return close();
    if (auto response = std::exchange(late_, {})) return start(std::move(*response));
    const std::optional<Body> last = std::exchange(last_piece_, {});
    if (!last) return;
    // The last piece is written like any other response.
    host_.release_memory(std::exchange(memory_, 0));
    std::string end(last->bytes());
    if (takes_chunks_) end = chunk(end) + "0\r\n\r\n";
    waiting_ = {};
    body_ = std::move(end);
    body_.keep(last->kept());
    sent_ = 0;
    waited_ = {};
    enter(Phase::writing);
    write_next();
}

}  // namespace waybreaker::http
