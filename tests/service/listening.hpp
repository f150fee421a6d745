// A client that listens to the events of a live mission.
#pragma once

#include <httplib.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "live_server.hpp"

namespace waybreaker::service {

// Until the server ends the stream, or it leaves.
class Listening {
  public:
    Listening(httplib::Client client, const std::string& path, const httplib::Headers& headers = {})
        : client_(std::move(client)), thread_([this, path, headers] { listen(path, headers); }) {}
    ~Listening() { leave(); }

    void leave() {
        leaving_ = true;
        client_.stop();
        if (thread_.joinable()) thread_.join();
    }
    // Waits for the server to end it.
    void to_the_end() { thread_.join(); }
    bool ended_well() const { return ended_well_; }
    std::string text() const {
        const std::scoped_lock lock(mutex_);
        return text_;
    }
    std::vector<Json> await(std::size_t count) const {
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
        while (events().size() < count && std::chrono::steady_clock::now() < deadline)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        return events();
    }
    // The data of all that came whole, with their ids.
    std::vector<Json> events() const {
        std::vector<Json> all;
        const std::string text = this->text();
        for (std::size_t begin = 0; begin < text.size();) {
            const std::size_t end = text.find("\n\n", begin);
            if (end == std::string::npos) break;
            std::istringstream lines(text.substr(begin, end - begin));
            Json event = Json::object();
            for (std::string line; std::getline(lines, line);) {
                const std::size_t colon = line.find(": ");
                if (colon != std::string::npos) event[line.substr(0, colon)] = line.substr(colon + 2);
            }
            if (event.contains("data")) all.push_back(event);
            begin = end + 2;
        }
        return all;
    }

  private:
    void listen(const std::string& path, const httplib::Headers& headers) {
        const auto result = client_.Get(path, headers, [this](const char* bytes, std::size_t size) {
            const std::scoped_lock lock(mutex_);
            text_.append(bytes, size);
            return !leaving_;
        });
        ended_well_ = result && result->status == 200;
    }

    httplib::Client client_;
    std::atomic<bool> leaving_ = false;
    std::atomic<bool> ended_well_ = false;
    mutable std::mutex mutex_;
    std::string text_;
    std::thread thread_;
};

inline std::vector<std::string> ids_of(const std::vector<Json>& events) {
    std::vector<std::string> ids;
    for (const Json& event : events) ids.push_back(event.value("id", ""));
    return ids;
}

}  // namespace waybreaker::service
