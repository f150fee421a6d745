#include "http/log_line.hpp"

#include <fmt/chrono.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "http/problem.hpp"

namespace waybreaker::http {
namespace {

using Json = nlohmann::ordered_json;

Json entry(const std::string& level, const std::string& event) {
    const auto now = std::chrono::time_point_cast<std::chrono::milliseconds>(std::chrono::system_clock::now());
    const auto seconds = std::chrono::time_point_cast<std::chrono::seconds>(now);
    const auto rest = (now - seconds).count();
    const std::string time = fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(seconds), rest);
    return {{"time", time}, {"level", level}, {"event", event}};
}

std::string text_of(const Json& json) {
    return json.dump(-1, ' ', true, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string log_line(const RequestLine& line) {
    constexpr std::size_t longest_path = 200;
    Json json = entry(line.status == internal_error ? "error" : "info", "request");
    json["client"] = line.client;
    json["method"] = line.method;
    json["path"] = line.path.substr(0, longest_path);
    json["status"] = line.status;
    json["seconds"] = line.seconds;
    if (!line.detail.empty()) json["detail"] = line.detail;
    return text_of(json);
}

std::string log_line(const std::string& event, const std::string& detail) {
    Json json = entry("info", event);
    json["detail"] = detail;
    return text_of(json);
}

}  // namespace waybreaker::http
