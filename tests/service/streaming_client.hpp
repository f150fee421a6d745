// A client that keeps a worker busy: a long plan is streamed to it until it disconnects.
#pragma once

#include <httplib.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>
#include <thread>

#include "live_server.hpp"

namespace waybreaker::service {

class StreamingClient {
  public:
    // Returns when a worker has started the plan.
    StreamingClient(httplib::Client client, const std::string& path, const Json& request)
        : client_(std::move(client)), thread_([this, path, body = request.dump()] { ask(path, body); }) {
        while (!done_ && events().find("\"planning\"") == std::string::npos) {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
    }
    ~StreamingClient() { leave(); }

    void leave() {
        leaving_ = true;
        if (thread_.joinable()) thread_.join();
    }
    bool done() const { return done_; }  // whether the response is complete
    std::string events() const {
        const std::scoped_lock lock(mutex_);
        return events_;
    }

  private:
    void ask(const std::string& path, const std::string& body) {
        httplib::Request request;
        request.method = "POST";
        request.path = path;
        request.body = body;
        request.headers = {{"Content-Type", "application/json"}, {"Accept", "text/event-stream"}};
        request.content_receiver = [this](const char* bytes, std::size_t size, std::uint64_t, std::uint64_t) {
            const std::scoped_lock lock(mutex_);
            events_.append(bytes, size);
            return !leaving_;
        };
        client_.send(request);
        done_ = true;
    }

    httplib::Client client_;
    std::atomic<bool> leaving_ = false;
    std::atomic<bool> done_ = false;
    mutable std::mutex mutex_;
    std::string events_;
    std::thread thread_;
};

// A mission on thicket() that takes every planner long to prove optimal.
inline Json long_mission(int side) {
    return {{"mission", {{"start", {0, 0}}, {"goal", {side - 1, side - 1}}}}, {"options", {{"removals", 20}}}};
}

}  // namespace waybreaker::service
