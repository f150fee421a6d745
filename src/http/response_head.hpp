// The head of a response as it is sent (RFC 9112, 4).
#pragma once

#include <chrono>
#include <string>

#include "http/message.hpp"

namespace waybreaker::http {

struct Delivery {
    const Fields& usual;  // default headers of every response
    bool last = false;    // the connection is closed after it
    std::chrono::seconds idle{0};
    enum class Length { known, chunks, until_the_end } length = Length::known;
};

// Including the empty line.
std::string response_head(const Response& response, const Delivery& delivery);

}  // namespace waybreaker::http
