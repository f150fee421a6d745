// Lines of the log: one JSON object each, the time first.
#pragma once

#include <string>

namespace waybreaker::http {

struct RequestLine {
    std::string client;
    std::string method;
    std::string path;  // as the client wrote it
    int status = 0;
    double seconds = 0;
    std::string detail = {};  // what went wrong
};

std::string log_line(const RequestLine& line);
// `event` is "listening", "stopped", ...
std::string log_line(const std::string& event, const std::string& detail);

}  // namespace waybreaker::http
