#include "http/target.hpp"

#include <algorithm>
#include <charconv>

#include "http/header_list.hpp"
#include "http/problem.hpp"

namespace waybreaker::http {
namespace {

constexpr std::string_view sub_delimiters = "!$&'()*+,;=";

bool is_hex(char c) {
    return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

bool is_one_of(char c, std::string_view set) {
    return set.find(c) != std::string_view::npos;
}

// Whether all characters are letters, digits, members of that set, or escapes such as %20.
bool consists_of(std::string_view text, std::string_view marks) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '%') {
            if (i + 2 >= text.size() || !is_hex(text[i + 1]) || !is_hex(text[i + 2])) return false;
            i += 2;
        } else if (!is_letter_or_digit(text[i]) && !is_one_of(text[i], marks)) {
            return false;
        }
    }
    return true;
}

bool is_path(std::string_view text) {
    return text.starts_with('/') && consists_of(text, "-._~!$&'()*+,;=:@/");
}

// Browsers leave more characters unescaped than RFC 3986 allows.
bool is_query(std::string_view text) {
    return consists_of(text, "-._~!$&'()*+,;=:@/?[]{}|\\^`");
}

bool is_port(std::string_view text) {
    constexpr std::size_t most_digits = 5;
    return text.size() <= most_digits && std::all_of(text.begin(), text.end(), is_digit);
}

std::string_view scheme_of(std::string_view target) {
    for (const std::string_view scheme : {"http://", "https://"}) {
        if (same_word(target.substr(0, scheme.size()), scheme)) return target.substr(0, scheme.size());
    }
    return {};
}

struct Parts {
    std::string_view host;
    std::string_view path;
    std::string_view query;
};

Parts parts_of(std::string_view target) {
    Parts parts;
    if (const std::string_view scheme = scheme_of(target); !scheme.empty()) {
        target.remove_prefix(scheme.size());
        parts.host = target.substr(0, target.find_first_of("/?"));
        target.remove_prefix(parts.host.size());
    }
    const std::size_t mark = target.find('?');
    parts.path = target.substr(0, mark);
    if (mark != std::string_view::npos) parts.query = target.substr(mark + 1);
    if (!parts.host.empty() && parts.path.empty()) parts.path = "/";
    return parts;
}

std::string decoded(std::string_view text, bool plus_is_blank) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '%') {
            unsigned char byte = 0;
            std::from_chars(&text[i + 1], &text[i + 1] + 2, byte, 16);
            result += char(byte);
            i += 2;
        } else {
            result += plus_is_blank && text[i] == '+' ? ' ' : text[i];
        }
    }
    return result;
}

}  // namespace

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_letter_or_digit(char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_host(std::string_view text) {
    std::size_t end = text.find(':');
    if (text.starts_with('[')) {
        const std::size_t bracket = text.find(']');
        if (bracket == std::string_view::npos || bracket < 3) return false;
        const std::string_view inside = text.substr(1, bracket - 1);
        if (!std::all_of(inside.begin(), inside.end(), [](char c) { return is_hex(c) || c == ':' || c == '.'; })) {
            return false;
        }
        if (inside.find(':') == std::string_view::npos) return false;
        end = bracket + 1;
        if (end == text.size()) return true;
        if (text[end] != ':') return false;
    } else if (!consists_of(text.substr(0, end), std::string("-._~").append(sub_delimiters))) {
        return false;
    }
    return end >= text.size() || (end > 0 && is_port(text.substr(end + 1)));
}

void check_target(std::string_view method, std::string_view target) {
    if (method == "CONNECT") throw Problem(not_implemented, "this is no proxy");
    if (method == "OPTIONS" && target == "*") return;
    const Parts parts = parts_of(target);
    const bool absolute = !scheme_of(target).empty();
    if (absolute && (parts.host.empty() || !is_host(parts.host))) {
        throw Problem(bad_request, "the address has no host that can be");
    }
    if (!is_path(parts.path) || !is_query(parts.query)) {
        throw Problem(bad_request, "the address is none; other characters than RFC 3986 knows are written as %20");
    }
}

Target target_of(std::string_view target) {
    const Parts parts = parts_of(target);
    Target result{std::string(parts.host), decoded(parts.path, false), {}};
    std::string_view rest = parts.query;
    while (!rest.empty()) {
        const std::string_view pair = rest.substr(0, rest.find('&'));
        rest.remove_prefix(std::min(pair.size() + 1, rest.size()));
        const std::size_t sign = pair.find('=');
        const std::string_view value = sign == std::string_view::npos ? std::string_view() : pair.substr(sign + 1);
        if (!pair.empty()) result.query.add(decoded(pair.substr(0, sign), true), decoded(value, true));
    }
    return result;
}

}  // namespace waybreaker::http
