#include "http/guard.hpp"

#include <algorithm>
#include <boost/asio/ip/address.hpp>

#include "http/header_list.hpp"
#include "http/target.hpp"

namespace waybreaker::http {
namespace {

// "localhost:8080" and "[::1]:8080" without the port.
std::string_view without_port(std::string_view host) {
    if (host.starts_with('[')) return host.substr(0, std::min(host.find(']') + 1, host.size()));
    return host.substr(0, host.find(':'));
}

}  // namespace

bool is_loopback(const std::string& address) {
    return address == "localhost" || address == "::1" || address == "127.0.0.1";
}

bool names_loopback(std::string_view host) {
    const std::string_view name = without_port(host);
    return same_word(name, "localhost") || name == "127.0.0.1" || name == "[::1]";
}

bool is_host_name(std::string_view name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return is_letter_or_digit(c) || c == '-' || c == '.' || c == '_';
    });
}

bool is_bearer_token(std::string_view token) {
    constexpr char del = 127;
    return !token.empty() && trimmed(token) == token &&
           std::all_of(token.begin(), token.end(), [](char c) { return (c < 0 || c >= ' ') && c != del; });
}

bool names_one_of(std::string_view host, const std::vector<std::string>& names) {
    return std::any_of(names.begin(), names.end(),
                       [name = without_port(host)](const std::string& one) { return same_word(name, one); });
}

bool is_address(std::string_view host) {
    std::string_view name = without_port(host);
    if (name.starts_with('[') && name.ends_with(']')) name = name.substr(1, name.size() - 2);
    boost::system::error_code error;
    boost::asio::ip::make_address(std::string(name), error);
    return !error;
}

bool same_site(std::string_view origin, std::string_view host) {
    const std::size_t slashes = origin.find("://");
    return slashes != std::string_view::npos && same_word(origin.substr(slashes + 3), host);
}

bool brings_token(std::string_view authorization, std::string_view token) {
    constexpr std::string_view scheme = "Bearer ";
    if (!same_word(authorization.substr(0, scheme.size()), scheme)) return false;
    const std::string_view given = trimmed(authorization.substr(scheme.size()));
    // Compares every character even after a mismatch, so that timing reveals nothing.
    unsigned difference = given.size() == token.size() ? 0 : 1;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const char wanted = token.empty() ? '\0' : token[i % token.size()];
        difference |= unsigned(given[i] != wanted);
    }
    return difference == 0 && !token.empty();
}

}  // namespace waybreaker::http
