#include "http/client_address.hpp"

#include <algorithm>
#include <cstdint>

namespace waybreaker::http {

namespace ip = boost::asio::ip;

ip::address client_of(const ip::address& address) {
    if (!address.is_v6() || address.is_loopback()) return address;
    if (address.to_v6().is_v4_mapped()) return ip::make_address_v4(ip::v4_mapped, address.to_v6());
    auto bytes = address.to_v6().to_bytes();
    std::fill(bytes.begin() + bytes.size() / 2, bytes.end(), std::uint8_t(0));
    return ip::address_v6(bytes);
}

std::string client_of(const std::string& address) {
    boost::system::error_code error;
    const ip::address parsed = ip::make_address(address, error);
    return error ? address : client_of(parsed).to_string();
}

}  // namespace waybreaker::http
