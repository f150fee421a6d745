// A server that runs for one test, and a client that checks every response against openapi.json.
#pragma once

#include <gtest/gtest.h>
#include <httplib.h>

#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "service/service.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::service {

using Json = nlohmann::json;

inline const std::string maps = "/api/v1/maps";
inline const std::string sources = "/api/v1/sources";
inline const std::string imports = "/api/v1/imports";
inline const std::string octets = "application/octet-stream";

// Each "METHOD path status" of openapi.json that a test has seen.
std::set<std::string>& seen();

class LiveServer : public TemporaryFolder {
  protected:
    // Its maps folder holds house.map and wall.map.
    LiveServer();
    ~LiveServer() override { end(); }

    // options_ can be changed before.
    void begin();
    void end();
    int port() const { return service_->port(); }
    httplib::Client client() const;
    std::vector<Json> log() const;

    // The response, whose status, type and schema must be those of openapi.json.
    httplib::Response get(const std::string& path, const httplib::Headers& headers = {}) const;
    httplib::Response post(const std::string& path, const std::string& body,
                           const std::string& type = "application/json", const httplib::Headers& headers = {}) const;
    httplib::Response remove(const std::string& path, const httplib::Headers& headers = {}) const;
    // The same for JSON that must come with that status.
    Json get_json(const std::string& path, int status = 200) const;
    Json post_json(const std::string& path, const Json& body, int status = 200) const;

    ServiceOptions options_;

  private:
    mutable std::mutex mutex_;
    std::vector<Json> log_;
    std::unique_ptr<Service> service_;
    std::thread thread_;
};

inline const Json house_mission{{"mission", {{"start", {1, 3}}, {"goal", {9, 3}}}}, {"options", {{"removals", 1}}}};

// A map on which every search takes long: a random thicket of many small obstacles.
std::string thicket(int side);

}  // namespace waybreaker::service
