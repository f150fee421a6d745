#include "http/server_event.hpp"

#include <algorithm>

namespace waybreaker::http {

std::string server_event(std::string_view name, std::string_view data, std::string_view id) {
    std::string text = id.empty() ? "" : "id: " + std::string(id) + "\n";
    text += "event: " + std::string(name) + "\n";
    for (std::size_t begin = 0; begin < data.size();) {
        const std::size_t end = std::min(data.find('\n', begin), data.size());
        text.append("data: ").append(data.substr(begin, end - begin)).append("\n");
        begin = end + 1;
    }
    return text + "\n";
}

}  // namespace waybreaker::http
