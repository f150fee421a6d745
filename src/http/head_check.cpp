#include "http/head_check.hpp"

#include <algorithm>

#include "http/header_list.hpp"
#include "http/problem.hpp"
#include "http/target.hpp"

namespace waybreaker::http {
namespace {

[[noreturn]] void refuse(const std::string& why) {
    throw Problem(bad_request, why);
}

bool is_token(std::string_view text) {
    constexpr std::string_view marks = "!#$%&'*+-.^_`|~";
    return !text.empty() && std::all_of(text.begin(), text.end(), [&](char c) {
        return is_letter_or_digit(c) || marks.find(c) != std::string_view::npos;
    });
}

// "HTTP/1.1": a digit on either side of the dot.
bool is_version(std::string_view text) {
    constexpr std::string_view name = "HTTP/";
    return text.size() == name.size() + 3 && text.starts_with(name) && is_digit(text[5]) && text[6] == '.' &&
           is_digit(text[7]);
}

}  // namespace

std::optional<std::size_t> HeadCheck::end_of_head(std::string_view bytes) {
    for (; seen_ < bytes.size(); ++seen_) {
        const char c = bytes[seen_];
        if (seen_ >= most_bytes) {
            if (!has_request_line_) throw Problem(target_too_long, "the address is too long");
            throw Problem(head_too_large, "the headers have more than " + std::to_string(most_bytes) + " bytes");
        }
        check_byte(c);
        if (c != '\n') continue;
        const std::string_view line = bytes.substr(line_, seen_ - 1 - line_);
        line_ = seen_ + 1;
        if (end_line(line)) return ++seen_;
    }
    return std::nullopt;
}

// Lines end with CR LF, and contain no other control characters but tabs.
void HeadCheck::check_byte(char c) {
    constexpr char del = 127;
    if (after_return_ != (c == '\n')) refuse("a line ends with CR LF, and neither is anywhere else");
    after_return_ = c == '\r';
    const bool control = (c >= 0 && c < ' ') || c == del;
    if (control && c != '\t' && c != '\r' && c != '\n') refuse("there is a control character in the headers");
}

// Whether it is the empty line that ends the head.
bool HeadCheck::end_line(std::string_view line) {
    if (!has_request_line_) {
        // One empty line before a request is ignored (RFC 9112, 2.2).
        if (line.empty() && !skipped_empty_line_) {
            skipped_empty_line_ = true;
            return false;
        }
        check_request_line(line);
        has_request_line_ = true;
        return false;
    }
    if (line.empty()) {
        if (part_ == Part::head) check_whole();
        return true;
    }
    check_field(line);
    return false;
}

void HeadCheck::check_request_line(std::string_view line) {
    const std::size_t first = line.find(' ');
    const std::size_t last = line.rfind(' ');
    if (first == std::string_view::npos || first == last) refuse("the first line is not METHOD ADDRESS HTTP/1.1");
    const std::string_view method = line.substr(0, first);
    const std::string_view target = line.substr(first + 1, last - first - 1);
    const std::string_view version = line.substr(last + 1);
    if (!is_token(method)) refuse("the method is no word");
    if (!is_version(version)) refuse("the first line does not end with the version of HTTP");
    if (version != "HTTP/1.1" && version != "HTTP/1.0") throw Problem(version_unknown, "only HTTP/1.1 is spoken here");
    if (target.size() > longest_target) throw Problem(target_too_long, "the address is too long");
    check_target(method, target);
    is_old_ = version == "HTTP/1.0";
}

void HeadCheck::check_field(std::string_view line) {
    if (++fields_ > most_fields) {
        throw Problem(head_too_large, "there are more than " + std::to_string(most_fields) + " headers");
    }
    if (line.front() == ' ' || line.front() == '\t') refuse("a header is folded over several lines");
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) refuse("a header has no colon");
    const std::string_view name = line.substr(0, colon);
    if (!is_token(name)) refuse("a header has a name that is none");
    if (part_ == Part::trailers) return;  // their values are ignored
    const std::string_view value = trimmed(line.substr(colon + 1));
    if (same_word(name, "Host")) {
        if (std::exchange(has_host_, true)) refuse("a request has one Host header");
        if (!is_host(value)) refuse("Host is no name with or without a port");
    }
    if (same_word(name, "Content-Length")) check_length(value);
    if (same_word(name, "Transfer-Encoding")) check_coding(value);
}

void HeadCheck::check_length(std::string_view value) {
    constexpr std::size_t most_digits = 18;
    if (std::exchange(has_length_, true)) refuse("Content-Length is said twice");
    if (value.empty() || value.size() > most_digits || !std::all_of(value.begin(), value.end(), is_digit)) {
        refuse("Content-Length is not a number");
    }
}

// "chunked" must be the last coding: only then can the end of the body be found (RFC 9112, 6.1 and 6.3).
void HeadCheck::check_coding(std::string_view value) {
    if (std::exchange(has_coding_, true)) refuse("Transfer-Encoding is said twice");
    const std::vector<std::string> codings = header_list(value);
    if (codings == std::vector<std::string>{"chunked"} && same_word(value, "chunked")) return;
    const auto chunked = std::find(codings.begin(), codings.end(), "chunked");
    if (codings.empty() || (chunked != codings.end() && chunked != codings.end() - 1)) {
        refuse("Transfer-Encoding does not say where the body ends");
    }
    throw Problem(not_implemented, "the only Transfer-Encoding taken is chunked");
}

void HeadCheck::check_whole() const {
    if (!has_host_ && !is_old_) refuse("a request has one Host header");
    if (has_length_ && has_coding_) refuse("the length of the body is said twice");
    if (has_coding_ && is_old_) refuse("HTTP/1.0 has no Transfer-Encoding");
}

}  // namespace waybreaker::http
