// Message: a request as routes see it, and the answer to it. Plain values: how they travel is the transport's business.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace waybreaker::server {

// Header fields in their order, or a query's parameters.
class Fields {
  public:
    using Field = std::pair<std::string, std::string>;

    Fields() = default;
    Fields(std::initializer_list<Field> fields) : fields_(fields) {}

    // The first value of that name, in any case; "" if there is none.
    std::string get(std::string_view name) const;
    std::optional<std::string> find(std::string_view name) const;
    std::size_t count(std::string_view name) const;

    void add(std::string name, std::string value);
    void set(std::string name, std::string value);  // the only one of its name
    void remove(std::string_view name);

    auto begin() const { return fields_.begin(); }
    auto end() const { return fields_.end(); }

  private:
    std::vector<Field> fields_;
};

struct Request {
    std::string method = {};
    std::string path = {};  // decoded, without the query
    Fields query = {};      // decoded
    Fields headers = {};
    std::string body = {};
    std::string client = {};                           // its address
    std::chrono::steady_clock::time_point began = {};  // when its first bytes had come
};

// Bytes that several answers may share: a page's file is sent to everybody, a map's to who asks.
class Body {
  public:
    Body() = default;
    Body(std::string bytes);  // NOLINT(google-explicit-constructor): an answer made for one request
    Body(const char* bytes) : Body(std::string(bytes)) {}  // NOLINT(google-explicit-constructor)
    // `bytes` live as long as `owner` does.
    Body(std::shared_ptr<const void> owner, std::string_view bytes) : owner_(std::move(owner)), bytes_(bytes) {}

    std::string_view bytes() const { return bytes_; }

  private:
    std::shared_ptr<const void> owner_;
    std::string_view bytes_;
};

struct Response {
    int status = 200;
    Fields headers = {};    // beside those that every answer has
    std::string type = {};  // of the body
    Body body = {};
};

}  // namespace waybreaker::server
