#include "http/session.hpp"

#include <algorithm>
#include <boost/asio/write.hpp>
#include <utility>

namespace waybreaker::http {
namespace {

namespace asio = boost::asio;
using Error = boost::system::error_code;
using std::chrono::milliseconds;

// The rest of a refused body is skipped if it is this short; else the connection is closed.
constexpr std::uint64_t most_skipped = 65536;
// How far to read ahead of the current request, for clients that pipeline.
constexpr std::size_t most_ahead = 16384;
constexpr std::size_t most_discarded = std::size_t{1} << 20;  // bytes after the last response

asio::ip::address address_of(const asio::ip::tcp::socket& socket) {
    Error error;
    const auto end = socket.remote_endpoint(error);
    return error ? asio::ip::address() : end.address();
}

}  // namespace

Session::Session(asio::ip::tcp::socket socket, SessionHost& host)
    : socket_(std::move(socket)),
      host_(host),
      client_(address_of(socket_)),
      timer_(socket_.get_executor()),
      reader_(host.options().body_bytes),
      since_(Clock::now()) {}

void Session::begin() {
    Error ignored;
    socket_.set_option(asio::ip::tcp::no_delay(true), ignored);
    expire_in(host_.options().timeouts.reading);
    receive();
}

void Session::close() {
    if (phase_ == Phase::closed) return;
    const auto self = shared_from_this();
    enter(Phase::closed);
    timer_.cancel();
    Error ignored;
    socket_.close(ignored);
    if (std::exchange(waits_, false)) waiting_.gone();
    waiting_ = {};
    host_.release_memory(std::exchange(memory_, 0));
    host_.on_closed(*this);
}

void Session::reject() {
    last_ = true;
    start(host_.handler().refuse(Problem(unavailable, "too many connections come from this address"),
                                 client_.to_string()));
}

bool Session::may_be_closed() const {
    return phase_ == Phase::idle || phase_ == Phase::reading || phase_ == Phase::closing || streams();
}

bool Session::has_begun() const {
    return phase_ != Phase::idle && (phase_ != Phase::reading || admitted_);
}

void Session::enter(Phase phase) {
    phase_ = phase;
    since_ = Clock::now();
}

void Session::expire_in(milliseconds time) {
    timer_.expires_after(time);
    timer_.async_wait([self = shared_from_this()](const Error& error) {
        // The timer may have been reset after it expired, before this handler ran.
        if (!error && self->timer_.expiry() <= Clock::now()) self->expired();
    });
}

void Session::expired() {
    switch (phase_) {
        case Phase::reading:
            last_ = true;
            start(host_.handler().refuse(Problem(request_timeout, "the request did not come whole in time"),
                                         client_.to_string()));
            return;
        case Phase::serving:
            return tick();
        case Phase::idle:
        case Phase::writing:
        case Phase::closing:
            return close();
        case Phase::closed:
            return;
    }
}

void Session::receive() {
    if (receiving_ || input_ended_ || phase_ == Phase::closed) return;
    receiving_ = true;
    socket_.async_read_some(asio::buffer(buffer_), [self = shared_from_this()](const Error& error, std::size_t count) {
        self->receiving_ = false;
        self->received(count, error);
    });
}

void Session::received(std::size_t count, const Error& error) {
    if (phase_ == Phase::closed) return;
    if (phase_ == Phase::closing) {
        discarded_ += count;
        return error || discarded_ > most_discarded ? close() : receive();
    }
    if (error) {
        input_ended_ = true;
        if (phase_ == Phase::idle || phase_ == Phase::reading) return close();
        if (error == asio::error::eof) return end_input();
        gone_ = true;
        if (waits_) close();
        return;
    }
    reader_.put({buffer_.data(), count});
    if (phase_ == Phase::idle || phase_ == Phase::reading) return advance();
    // Keep reading while a response is made, to notice when the client disconnects.
    if (reader_.waiting() < most_ahead) receive();
}

// The client has closed its sending side, and may still want its response. One that has closed the connection looks the
// same, but resets it as soon as something is sent: tick() does that.
void Session::end_input() {
    if (waits_) expire_in(before_probe);
    socket_.async_wait(asio::ip::tcp::socket::wait_error, [self = shared_from_this()](const Error& error) {
        if (error) return;
        self->gone_ = true;
        if (self->waits_) self->close();
    });
}

void Session::advance() {
    try {
        while (proceed()) continue;
    } catch (const Problem& problem) {
        last_ = true;
        start(host_.handler().refuse(problem, client_.to_string()));
    } catch (const std::exception&) {
        close();  // out of memory: do not affect other sessions
    }
}

bool Session::proceed() {
    const RequestReader::State state = reader_.advance();
    if (state == RequestReader::State::idle) {
        if (input_ended_) return close(), false;
        if (phase_ != Phase::idle) {
            enter(Phase::idle);
            expire_in(host_.options().timeouts.idle);
        }
        return receive(), false;
    }
    begin_reading();
    if (state != RequestReader::State::head && !admitted_ && !admit()) return false;
    if (!refused_) take_memory();
    if (state == RequestReader::State::whole) {
        if (!refused_) return serve(), false;
        reader_.take();
        admitted_ = refused_ = false;
        return true;
    }
    if (input_ended_) return close(), false;
    if (state == RequestReader::State::body && !refused_ && !sent_continue_ && reader_.expects_continue()) {
        return send_continue(), false;
    }
    return receive(), false;
}

// The first bytes of a request have arrived.
void Session::begin_reading() {
    if (phase_ == Phase::reading) return;
    enter(Phase::reading);
    began_ = Clock::now();
    sent_continue_ = false;
    // For the first request, the timeout started with the connection.
    if (!std::exchange(first_, false)) expire_in(host_.options().timeouts.reading);
}

// The head of a request is complete. Whether to read on.
bool Session::admit() {
    admitted_ = true;
    const Request& head = reader_.head();
    last_ = !reader_.may_be_followed();
    without_body_ = head.method == "HEAD";
    takes_chunks_ = reader_.takes_chunks();
    Request asked = head;
    asked.client = client_.to_string();
    asked.began = began_;
    Admission admission = host_.handler().admit(asked, reader_.length());
    quick_ = admission.quick;
    if (!admission.body) reader_.drop_body();
    if (!admission.refusal) return true;
    refused_ = true;
    const bool short_enough = reader_.length().value_or(most_skipped + 1) <= most_skipped;
    last_ = last_ || !short_enough || reader_.expects_continue();
    reader_.drop_body();
    start(std::move(*admission.refusal));
    return false;
}

// Small bodies are always accepted.
void Session::take_memory() {
    constexpr std::size_t small = 65536;
    const std::size_t size = reader_.body_size();
    if (size <= std::max(small, memory_)) return;
    if (!host_.take_memory(size - memory_)) {
        throw Problem(unavailable, "too many large bodies come at once; send it again in a moment");
    }
    memory_ = size;
}

void Session::send_continue() {
    sent_continue_ = true;
    asio::async_write(socket_, asio::buffer(continue_text.data(), continue_text.size()),
                      [self = shared_from_this()](const Error& error, std::size_t) {
                          if (self->phase_ != Phase::reading) return;
                          return error ? self->close() : self->advance();
                      });
}

void Session::serve() {
    Request request = reader_.take();
    request.client = client_.to_string();
    request.began = began_;
    admitted_ = false;
    enter(Phase::serving);
    timer_.cancel();
    receive();
    const auto task = std::make_shared<Request>(std::move(request));
    const auto serve = [self = shared_from_this(), task] { self->host_.handler().serve(std::move(*task), self); };
    quick_ ? serve() : host_.run_task(serve);
}

}  // namespace waybreaker::http
