#include "server/request_reader.hpp"

#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <boost/beast/http/basic_parser.hpp>
#include <limits>
#include <utility>

#include "server/head_check.hpp"
#include "server/header_list.hpp"
#include "server/problem.hpp"
#include "server/target.hpp"

namespace waybreaker::server {
namespace {

namespace http = boost::beast::http;
using Error = boost::system::error_code;

using StringView = boost::beast::string_view;

std::string text(StringView view) {
    return {view.data(), view.size()};
}

// Longest line of a chunked body, and longest trailer section.
constexpr std::size_t longest_line = HeadCheck::most_bytes;

}  // namespace

// Builds one request from what Beast parses.
class RequestReader::Parser : public http::basic_parser<true> {
  public:
    explicit Parser(std::size_t most) : most_(most) {
        header_limit(std::uint32_t(HeadCheck::most_bytes));
        // expect() enforces the limit: Beast does not distinguish too large from impossible.
        body_limit(std::numeric_limits<std::uint64_t>::max());
    }

    // Returns the number of bytes parsed.
    std::size_t read(std::string_view bytes) { return is_header_done() ? pass_on(bytes) : read_head(bytes); }
    void drop_body() { dropped_ = true; }

    const Request& request() const { return request_; }
    Request take() { return std::move(request_); }
    bool is_old() const { return is_old_; }

  private:
    std::size_t read_head(std::string_view bytes);
    std::size_t pass_on(std::string_view bytes);
    void expect(std::uint64_t size);
    std::size_t add(StringView piece) {
        if (!dropped_) request_.body.append(piece.data(), piece.size());
        return piece.size();
    }

    void on_request_impl(http::verb, StringView method, StringView target, int version, Error&) override;
    void on_field_impl(http::field, StringView name, StringView value, Error&) override;
    void on_header_impl(Error&) override { has_head_ = true; }
    void on_body_init_impl(const boost::optional<std::uint64_t>& length, Error&) override {
        if (!length) return;
        expect(*length);
        if (!dropped_) request_.body.reserve(std::size_t(*length));  // no pages are touched until bytes arrive
    }
    std::size_t on_body_impl(StringView piece, Error&) override { return add(piece); }
    void on_chunk_header_impl(std::uint64_t size, StringView, Error&) override { expect(size); }
    std::size_t on_chunk_body_impl(std::uint64_t, StringView piece, Error&) override { return add(piece); }
    void on_finish_impl(Error&) override {}
    void on_response_impl(int, StringView, int, Error&) override {}

    std::size_t most_;
    std::size_t expected_ = 0;  // bytes of the body announced so far
    HeadCheck check_;
    bool has_head_ = false;
    bool is_old_ = false;  // HTTP/1.0
    bool dropped_ = false;
    std::string host_;  // of an absolute target
    Request request_;
};

std::size_t RequestReader::Parser::read_head(std::string_view bytes) {
    const std::optional<std::size_t> end = check_.end_of_head(bytes);
    if (!end) return 0;
    std::string_view head = bytes.substr(0, *end);
    if (head.starts_with("\r\n")) head.remove_prefix(2);  // one empty line is allowed
    if (pass_on(head) != head.size() || !is_header_done()) throw Problem(bad_request, "the request cannot be read");
    if (!host_.empty()) request_.headers.set("Host", host_);
    eager(true);
    return *end;
}

std::size_t RequestReader::Parser::pass_on(std::string_view bytes) {
    Error error;
    const std::size_t read = put(boost::asio::const_buffer(bytes.data(), bytes.size()), error);
    if (error && error != http::error::need_more) {
        throw Problem(bad_request, "the request cannot be read: " + error.message());
    }
    return read;
}

// An absurd length is a mistake or an attack, not merely too large.
void RequestReader::Parser::expect(std::uint64_t size) {
    constexpr std::uint64_t longest = 1'000'000'000'000'000'000;
    if (size >= longest) throw Problem(bad_request, "no chunk is as long");
    if (size > most_ - expected_)
        throw body_too_large(most_);
    expected_ += std::size_t(size);
}

void RequestReader::Parser::on_request_impl(http::verb, StringView method, StringView target, int version, Error&) {
    constexpr int current = 11;
    Target parsed = target_of({target.data(), target.size()});
    request_.method = text(method);
    request_.path = std::move(parsed.path);
    request_.query = std::move(parsed.query);
    host_ = std::move(parsed.host);
    is_old_ = version < current;
}

// Trailers after a chunked body are ignored.
void RequestReader::Parser::on_field_impl(http::field, StringView name, StringView value, Error&) {
    if (!has_head_) request_.headers.add(text(name), text(value));
}

RequestReader::RequestReader(std::size_t most) : most_(most), parser_(std::make_unique<Parser>(most)) {}
RequestReader::~RequestReader() = default;

void RequestReader::put(std::string_view bytes) {
    waiting_.append(bytes);
}

RequestReader::State RequestReader::advance() {
    std::size_t begin = 0;
    bool reads = true;
    while (reads && !parser_->is_done()) {
        const std::size_t read = parser_->read(std::string_view(waiting_).substr(begin));
        begin += read;
        reads = read > 0 && begin < waiting_.size();
    }
    waiting_.erase(0, begin);
    if (parser_->is_done()) return State::whole;
    if (!parser_->is_header_done()) return waiting_.empty() ? State::idle : State::head;
    if (waiting_.size() > longest_line) throw Problem(bad_request, "a chunk begins and does not end");
    return State::body;
}

std::size_t RequestReader::waiting() const {
    return waiting_.size();
}

const Request& RequestReader::head() const {
    return parser_->request();
}

std::optional<std::uint64_t> RequestReader::length() const {
    if (parser_->chunked()) return std::nullopt;
    return parser_->content_length().value_or(0);
}

bool RequestReader::may_be_followed() const {
    if (parser_->is_old()) return false;
    const Fields& headers = head().headers;
    return std::none_of(headers.begin(), headers.end(), [](const Fields::Field& field) {
        if (!same_word(field.first, "Connection")) return false;
        const std::vector<std::string> items = header_list(field.second);
        return std::find(items.begin(), items.end(), "close") != items.end();
    });
}

bool RequestReader::takes_chunks() const {
    return !parser_->is_old();
}

bool RequestReader::expects_continue() const {
    return !parser_->is_old() && same_word(head().headers.get("Expect"), "100-continue");
}

std::size_t RequestReader::body_size() const {
    return head().body.size();
}

void RequestReader::drop_body() {
    parser_->drop_body();
}

Request RequestReader::take() {
    Request request = parser_->take();
    parser_ = std::make_unique<Parser>(most_);
    return request;
}

}  // namespace waybreaker::server
