#include "http/request_reader.hpp"

#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <boost/beast/http/basic_parser.hpp>
#include <limits>
#include <utility>

#include "http/head_check.hpp"
#include "http/header_list.hpp"
#include "http/problem.hpp"
#include "http/target.hpp"

namespace waybreaker::http {
namespace {

namespace http = boost::beast::http;
using Error = boost::system::error_code;

using StringView = boost::beast::string_view;

std::string text(StringView view) {
    return {view.data(), view.size()};
}

// The line before a chunk: the chunk's size, and extensions, which are ignored.
constexpr std::size_t longest_chunk_line = HeadCheck::most_bytes;

// "0", CR LF, no trailers, CR LF: what Beast takes for granted once it has seen the size. More follows any other chunk.
constexpr std::size_t shortest_last_chunk = 5;

// As Beast reads the size: hexadecimal digits up to the first character that is none.
bool is_last_chunk(std::string_view line) {
    const std::size_t digits = std::min(line.find_first_not_of("0123456789ABCDEFabcdef"), line.size());
    return digits > 0 && line.substr(0, digits).find_first_not_of('0') == std::string_view::npos;
}

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
    std::size_t read(std::string_view bytes) {
        if (!is_header_done()) return read_head(bytes);
        if (chunked() && chunk_left_ == 0) {
            if (bytes.size() < shortest_last_chunk) return 0;
            check_chunk(bytes);
        }
        return pass_on(bytes);
    }
    void drop_body() { dropped_ = true; }

    const Request& request() const { return request_; }
    Request take() { return std::move(request_); }
    bool is_old() const { return is_old_; }

  private:
    std::size_t read_head(std::string_view bytes);
    std::size_t pass_on(std::string_view bytes);
    void check_chunk(std::string_view bytes);
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
    void on_chunk_header_impl(std::uint64_t size, StringView, Error&) override {
        expect(size);
        has_chunk_ = true;
        chunk_left_ = size;
    }
    std::size_t on_chunk_body_impl(std::uint64_t, StringView piece, Error&) override {
        chunk_left_ -= piece.size();
        return add(piece);
    }
    void on_finish_impl(Error&) override {}
    void on_response_impl(int, StringView, int, Error&) override {}

    std::size_t most_;
    std::size_t expected_ = 0;  // bytes of the body announced so far
    bool has_chunk_ = false;
    std::uint64_t chunk_left_ = 0;  // bytes of the chunk that are still to come
    HeadCheck check_;
    HeadCheck trailer_check_{HeadCheck::Part::trailers};
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
    return *end;
}

// Before a chunk. Beast reads the trailers after the last one in one piece, and joins folded lines, so they are checked
// first.
void RequestReader::Parser::check_chunk(std::string_view bytes) {
    if (has_chunk_) {
        if (!bytes.starts_with("\r\n")) return;  // Beast waits for it, and takes nothing else
        bytes.remove_prefix(2);
    }
    const std::size_t end = bytes.find("\r\n");
    if (std::min(end, bytes.size()) > longest_chunk_line) {
        throw Problem(bad_request, "a chunk begins and does not end");
    }
    if (end == std::string_view::npos || !is_last_chunk(bytes.substr(0, end))) return;
    if (bytes.substr(0, end).find_first_of("\r\n") != std::string_view::npos) {
        throw Problem(bad_request, "a line ends with CR LF, and neither is anywhere else");
    }
    trailer_check_.end_of_head(bytes.substr(end + 2));
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
    if (size > most_ - expected_) throw body_too_large(most_);
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
    const std::vector<std::string> items = header_list(head().headers.get("Connection"));
    return std::find(items.begin(), items.end(), "close") == items.end();
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

}  // namespace waybreaker::http
