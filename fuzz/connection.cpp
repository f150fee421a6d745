// Whatever a client sends, requests are found in it or refused; where its bytes are cut into pieces changes nothing.
#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "http/problem.hpp"
#include "http/request_reader.hpp"
#include "laws.hpp"

namespace {

using waybreaker::law;
using waybreaker::http::Problem;
using waybreaker::http::Request;
using waybreaker::http::RequestReader;

struct Outcome {
    std::vector<std::string> requests;
    int status = 0;
    bool operator==(const Outcome&) const = default;
};

std::string text_of(const Request& request, bool last) {
    std::string text = request.method + ' ' + request.path + (last ? " last" : "");
    for (const auto& [name, value] : request.query) text += '\n' + name + '=' + value;
    for (const auto& [name, value] : request.headers) text += '\n' + name + ": " + value;
    return text + "\n\n" + request.body;
}

Outcome outcome(std::string_view bytes, std::size_t piece) {
    constexpr std::size_t most = 1 << 16;
    RequestReader reader(most);
    Outcome result;
    try {
        while (!bytes.empty()) {
            reader.put(bytes.substr(0, piece));
            bytes.remove_prefix(std::min(piece, bytes.size()));
            while (reader.advance() == RequestReader::State::whole) {
                const bool last = !reader.may_be_followed();
                const Request request = reader.take();
                law(request.body.size() <= most);
                law(request.headers.count("Content-Length") + request.headers.count("Transfer-Encoding") <= 1);
                law(request.headers.count("Host") <= 1);
                for (const auto& [name, value] : request.headers) {
                    law(value.find_first_of(std::string_view("\r\n\0", 3)) == std::string::npos);
                }
                result.requests.push_back(text_of(request, last));
            }
        }
    } catch (const Problem& problem) {
        result.status = problem.status();
    }
    return result;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const Outcome whole = outcome(bytes, size + 1);
    law(outcome(bytes, 1) == whole);
    law(outcome(bytes, 7) == whole);
    return 0;
}
