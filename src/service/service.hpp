// The service: waybreaker over HTTP (docs/server.md, openapi.json).
//
//     Service service({.maps = "data", .log = [](const std::string& line) { std::cerr << line; }});
//     std::cout << service.port();
//     service.run();    // until service.stop(), from any thread; requests in progress are finished
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "service/limits.hpp"

namespace waybreaker::service {

struct ServiceOptions {
    std::string maps;  // a folder; empty: the built-in map and uploaded ones
    // Of live missions: a file, or the postgresql:// URL of a database that services share. Empty: they are kept in
    // memory, and gone with the service.
    std::string store;
    std::string host = "127.0.0.1";
    int port = 0;  // 0: any that is free
    std::string token;
    bool insecure = false;  // serve other machines without a token
    // What clients call the server; then it answers to no other name but this machine's own.
    std::vector<std::string> names = {};
    ServiceLimits limits;
    // A program and its arguments, which calls run_import_worker() (import_worker.hpp) with those that are added.
    // Empty: nothing can be imported.
    std::vector<std::string> import_worker;
    std::function<void(const std::string&)> log = [](const std::string&) {
    };  // one JSON object a line; called from any thread
};

class Service {
  public:
    // Binds. Throws InputError if that fails, or if the service would be open to other machines unintentionally.
    explicit Service(ServiceOptions options);
    ~Service();
    Service(const Service&) = delete;
    Service& operator=(const Service&) = delete;

    int port() const;
    std::string url() const;  // of the page
    // Call once. stop() may be called from any thread.
    void run();
    void stop();

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

// The served description of the service, OpenAPI 3.1 (defined by the build, of openapi.json).
std::string_view openapi_json();
// JSON Schema of the mission file (of mission.schema.json).
std::string_view mission_schema();

}  // namespace waybreaker::service
