// Who a client is, as far as its address tells.
#pragma once

#include <boost/asio/ip/address.hpp>
#include <string>

namespace waybreaker::http {

// The client that an address belongs to: itself, but of IPv6 the first address of its /64 network, as a client has all
// of one.
boost::asio::ip::address client_of(const boost::asio::ip::address& address);
// The same as text.
std::string client_of(const std::string& address);

}  // namespace waybreaker::http
