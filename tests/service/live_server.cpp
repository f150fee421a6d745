#include "live_server.hpp"

#include <algorithm>
#include <mutex>
#include <random>

#include "schema_check.hpp"
#include "service/import_worker.hpp"

namespace waybreaker::service {
namespace {

const Json& api() {
    static const Json description = Json::parse(openapi_json());
    return description;
}

// The path template of openapi.json that matches a request's path; "" if none.
std::string described_path(const std::string& path) {
    const std::string bare = path.substr(0, path.find('?'));
    for (const auto& [name, item] : api().at("paths").items()) {
        const std::size_t id = name.find("{id}");
        if (id == std::string::npos
                ? bare == name
                : bare.starts_with(name.substr(0, id)) && bare.ends_with(name.substr(id + 4)) &&
                      bare.size() > name.size() - 4 &&
                      bare.find('/', id) ==
                          (name.size() > id + 4 ? bare.size() - name.size() + id + 4 : std::string::npos)) {
            return name;
        }
    }
    return "";
}

void hold_against_description(const std::string& method, const std::string& path, const httplib::Response& answer) {
    EXPECT_EQ(answer.get_header_value("X-Content-Type-Options"), "nosniff");
    EXPECT_TRUE(answer.get_header_value("Date").ends_with(" GMT"));
    EXPECT_NE(answer.get_header_value("Content-Security-Policy").find("default-src 'none'"), std::string::npos);
    const std::string name = described_path(path);
    const std::string type = answer.get_header_value("Content-Type");
    if (name.empty() || answer.status == 405) {
        EXPECT_EQ(type, "application/problem+json") << method << ' ' << path;
        EXPECT_TRUE(schema_faults(api(), api()["components"]["schemas"]["Problem"], Json::parse(answer.body)).empty());
        return;
    }
    const Json& responses = api()["paths"][name][method].at("responses");
    const std::string status = std::to_string(answer.status);
    ASSERT_TRUE(responses.contains(status)) << method << ' ' << path << " gives " << status << ' ' << answer.body;
    {
        static std::mutex several_clients;
        const std::scoped_lock lock(several_clients);
        seen().insert(method + ' ' + name + ' ' + status);
    }
    const Json& described = resolved(api(), responses[status]);
    if (!described.contains("content")) {
        EXPECT_TRUE(answer.body.empty() && type.empty() && !answer.has_header("Content-Length"));
        return;
    }
    const Json& content = described.at("content");
    const std::string bare_type = type.substr(0, type.find(';'));
    ASSERT_TRUE(content.contains(bare_type)) << method << ' ' << path << " gives " << type;
    const bool is_json = bare_type.ends_with("json");
    const Json value = is_json ? Json::parse(answer.body) : Json(answer.body);
    for (const std::string& fault : schema_faults(api(), content[bare_type]["schema"], value)) {
        ADD_FAILURE() << method << ' ' << path << ' ' << status << ": " << fault;
    }
    EXPECT_EQ(answer.get_header_value("Retry-After"), answer.status == 503 ? "1" : "");
}

// What is not described must not be taken, or clients cannot be made from the description.
void hold_request_against_description(const std::string& path, const std::string& body) {
    const Json& operation = api()["paths"][described_path(path)]["post"];
    const Json& content = resolved(api(), operation.at("requestBody")).at("content");
    if (!content.contains("application/json")) return;
    for (const std::string& fault : schema_faults(api(), content["application/json"]["schema"], Json::parse(body))) {
        ADD_FAILURE() << path << " takes " << body.substr(0, 1000) << ": " << fault;
    }
}

httplib::Response checked(const std::string& method, const std::string& path, const httplib::Result& result) {
    EXPECT_TRUE(result) << method << ' ' << path << ": " << httplib::to_string(result.error());
    if (!result) return {};
    hold_against_description(method, path, *result);
    return *result;
}

}  // namespace

std::set<std::string>& seen() {
    static std::set<std::string> answers;
    return answers;
}

LiveServer::LiveServer() {
    std::filesystem::create_directories(path("maps"));
    // The only way around the house in the middle is a long detour.
    put(
        "maps/house.map", "type octile\nheight 7\nwidth 11\nmap\n" + [] {
            std::string rows;
            for (int y = 0; y < 7; ++y) rows += y < 6 ? ".....@.....\n" : "...........\n";
            return rows;
        }());
    put("maps/wall.map", "type octile\nheight 1\nwidth 3\nmap\n.@.\n");
    options_.maps = path("maps");
    options_.import_worker = {"/proc/self/exe", import_worker_word};  // main.cpp
    options_.log = [this](const std::string& line) {
        const std::scoped_lock lock(mutex_);
        log_.push_back(Json::parse(line));
    };
}

void LiveServer::begin() {
    service_ = std::make_unique<Service>(options_);
    thread_ = std::thread([this] { service_->run(); });
    while (log().empty()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

void LiveServer::end() {
    if (!thread_.joinable()) return;
    service_->stop();
    thread_.join();
    service_.reset();
}

httplib::Client LiveServer::client() const {
    httplib::Client client("127.0.0.1", port());
    client.set_read_timeout(60);
    return client;
}

std::vector<Json> LiveServer::log() const {
    const std::scoped_lock lock(mutex_);
    return log_;
}

httplib::Response LiveServer::get(const std::string& path, const httplib::Headers& headers) const {
    return checked("get", path, client().Get(path, headers));
}

httplib::Response LiveServer::post(const std::string& path, const std::string& body, const std::string& type,
                                   const httplib::Headers& headers) const {
    const httplib::Response answer = checked("post", path, client().Post(path, headers, body, type));
    if (answer.status == 200 || answer.status == 201) hold_request_against_description(path, body);
    return answer;
}

httplib::Response LiveServer::remove(const std::string& path, const httplib::Headers& headers) const {
    return checked("delete", path, client().Delete(path, headers));
}

Json LiveServer::get_json(const std::string& path, int status) const {
    const httplib::Response answer = get(path);
    EXPECT_EQ(answer.status, status) << answer.body;
    return Json::parse(answer.body);
}

Json LiveServer::post_json(const std::string& path, const Json& body, int status) const {
    const httplib::Response answer = post(path, body.dump());
    EXPECT_EQ(answer.status, status) << answer.body;
    return Json::parse(answer.body);
}

std::string thicket(int side) {
    std::mt19937 random(1);
    std::string text = "type octile\nheight " + std::to_string(side) + "\nwidth " + std::to_string(side) + "\nmap\n";
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const bool corner = (x < 2 && y < 2) || (x >= side - 2 && y >= side - 2);
            text += !corner && random() % 5 == 0 ? '@' : '.';
        }
        text += '\n';
    }
    return text;
}

}  // namespace waybreaker::service
