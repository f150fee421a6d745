// Messages: a request as routes see it, and its response. Plain values, independent of the transport.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace waybreaker::http {

// Header fields or query parameters, in order.
class Fields {
  public:
    using Field = std::pair<std::string, std::string>;

    Fields() = default;
    Fields(std::initializer_list<Field> fields) : fields_(fields) {}

    // The values of that name (case-insensitive), joined with ", " where there are several, as lines of a header are
    // one list (RFC 9110, 5.3); "" if there is none.
    std::string get(std::string_view name) const;
    std::optional<std::string> find(std::string_view name) const;
    std::size_t count(std::string_view name) const;

    void add(std::string name, std::string value);
    void set(std::string name, std::string value);  // replaces others of that name
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
    std::string client = {};                           // address
    std::chrono::steady_clock::time_point began = {};  // when its first bytes arrived
};

// Bytes that several responses may share, such as a file of the page or of a map.
class Body {
  public:
    Body() = default;
    Body(std::string bytes);                               // NOLINT(google-explicit-constructor): made for one response
    Body(const char* bytes) : Body(std::string(bytes)) {}  // NOLINT(google-explicit-constructor)
    // `bytes` must live as long as `owner`.
    Body(std::shared_ptr<const void> owner, std::string_view bytes) : owner_(std::move(owner)), bytes_(bytes) {}

    std::string_view bytes() const { return bytes_; }
    // Whether it was made for one response.
    bool is_own() const { return own_; }
    // Something else that is kept as long as the bytes: what they count in.
    void keep(std::shared_ptr<const void> thing) { kept_ = std::move(thing); }
    const std::shared_ptr<const void>& kept() const { return kept_; }

  private:
    std::shared_ptr<const void> owner_;
    std::shared_ptr<const void> kept_;
    std::string_view bytes_;
    bool own_ = false;
};

struct Response {
    int status = 200;
    Fields headers = {};    // in addition to those of every response
    std::string type = {};  // of the body
    Body body = {};
};

}  // namespace waybreaker::http
