// The first lines of an answer as they are sent (RFC 9112, 4).
#pragma once

#include <chrono>
#include <string>

#include "server/message.hpp"

namespace waybreaker::server {

struct Delivery {
    const Fields& usual;  // headers of every answer that does not say otherwise
    bool last = false;    // the connection ends after it
    std::chrono::seconds idle{0};
    enum class Length { known, chunks, until_the_end } length = Length::known;
};

// The empty line included.
std::string response_head(const Response& response, const Delivery& delivery);

}  // namespace waybreaker::server
