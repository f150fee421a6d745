// What handlers of several routes make their responses and read their requests with.
#pragma once

#include <string>

#include "http/message.hpp"
#include "http/problem.hpp"
#include "service/map_store.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::service {

inline constexpr auto json_type = "application/json";

http::Response ok_response(http::Body body, const std::string& type = json_type);

// What is kept now under `location`: 201 with that, or 200 if it was there already.
http::Response kept_response(std::string body, const std::string& location, bool is_new);

// A map that is kept now.
http::Response upload_response(const MapStore::Upload& added);

// A number of the query string.
std::size_t number_of(const http::Request& request, const std::string& name, std::size_t otherwise, std::size_t least,
                      std::size_t most);

// Throws Problem for a body that takes too much memory to read: parsed JSON takes forty times that of its text. `what`
// it is: "a plan".
void require_size(const http::Request& request, const std::string& what);

// What `parse` makes of a request; its InputErrors are the client's fault.
template <class Parse>
auto read_request(Parse parse) try {
    return parse();
} catch (const InputError& error) {
    throw http::Problem(http::bad_request, error.what());
}

}  // namespace waybreaker::service
