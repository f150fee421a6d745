#include "server/service.hpp"

#include <sys/socket.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <utility>
#include <vector>

#include "server/connections.hpp"
#include "server/desk.hpp"
#include "server/guard.hpp"
#include "server/listener.hpp"
#include "server/log_line.hpp"
#include "server/map_shelf.hpp"
#include "server/metrics.hpp"
#include "server/problem.hpp"
#include "server/routes.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::server {
namespace {

using Clock = std::chrono::steady_clock;

const httplib::Headers safe_headers{
    {"Content-Security-Policy", "default-src 'none'; frame-ancestors 'none'; base-uri 'none'; form-action 'none'"},
    {"X-Content-Type-Options", "nosniff"},
    {"X-Frame-Options", "DENY"},
    {"Referrer-Policy", "no-referrer"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Cache-Control", "no-store"}};

void require_safe(const ServiceOptions& options) {
    if (is_loopback(options.host) || !options.token.empty() || options.insecure) return;
    throw InputError("other machines can reach " + options.host +
                     ": give a --token that they must bring, or say --insecure");
}

void set_problem(httplib::Response& response, int status, const std::string& detail) {
    response.status = status;
    response.body.clear();
    response.set_content(problem_json(status, detail), "application/problem+json");
    if (status == unavailable) response.set_header("Retry-After", "1");
    if (status == unauthorized) response.set_header("WWW-Authenticate", "Bearer");
}

// A type that pages of other sites cannot send here without being asked for leave first.
void require_type(const Route& route, const httplib::Request& request) {
    const std::string wanted = route.body == Route::Body::json ? "application/json" : "application/octet-stream";
    const std::string given = request.get_header_value("Content-Type");
    if (route.body == Route::Body::none || given.substr(0, given.find(';')) == wanted) return;
    throw Problem(unsupported_type, "the body must be sent as " + wanted);
}

}  // namespace

class Service::House {
  public:
    explicit House(ServiceOptions options);

    int port() const { return port_; }
    void run();
    void stop();

  private:
    void add(const Route& route);
    void bind();
    void guard(const Route& route, const httplib::Request& request) const;
    std::string read_body(const Route& route, const httplib::Request& request,
                          const httplib::ContentReader& reader) const;
    void serve(const Route& route, const httplib::Request& request, httplib::Response& response,
               const httplib::ContentReader& reader);
    void finish(const Route& route, const httplib::Request& request, int status, Clock::time_point began,
                const std::string& detail);
    bool refuse_unknown(const httplib::Request& request, httplib::Response& response);

    ServiceOptions options_;
    Metrics metrics_;
    MapShelf shelf_;
    Desk desk_;
    std::vector<Route> routes_;
    Listener listener_;
    int port_ = 0;
    std::atomic<bool> over_ = false;
};

Service::House::House(ServiceOptions options)
    : options_(std::move(options)),
      shelf_(options_.maps, options_.limits),
      desk_(options_.limits, metrics_),
      routes_(routes(shelf_, desk_, metrics_, options_.limits)),
      listener_({.reading = std::chrono::milliseconds(std::int64_t(options_.limits.patience * 1000)),
                 .bytes = options_.limits.upload_bytes + (std::size_t{1} << 16)}) {
    require_safe(options_);
    listener_.new_task_queue = [this] { return new Connections(options_.limits.connections); };
    listener_.set_payload_max_length(options_.limits.upload_bytes);
    listener_.set_default_headers(safe_headers);
    listener_.set_tcp_nodelay(true);
    // httplib's own choice would let two servers share a port.
    listener_.set_socket_options([](socket_t socket) {
        const int yes = 1;
        ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    listener_.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
        return refuse_unknown(request, response) ? httplib::Server::HandlerResponse::Handled
                                                 : httplib::Server::HandlerResponse::Unhandled;
    });
    // What httplib refuses by itself: requests that are no HTTP, or too large.
    listener_.set_error_handler(httplib::Server::Handler([](const httplib::Request&, httplib::Response& response) {
        if (response.body.empty()) set_problem(response, response.status, "the request cannot be taken as it is");
    }));
    for (const Route& route : routes_) add(route);
    bind();
}

void Service::House::add(const Route& route) {
    const auto answer = [this, &route](const httplib::Request& request, httplib::Response& response,
                                       const httplib::ContentReader& reader) {
        serve(route, request, response, reader);
    };
    if (route.method == "POST") {
        listener_.Post(route.pattern(), answer);
    } else {
        listener_.Get(route.pattern(), [answer](const httplib::Request& request, httplib::Response& response) {
            answer(request, response, {nullptr, nullptr});
        });
    }
}

void Service::House::bind() {
    port_ = options_.port == 0                                     ? listener_.bind_to_any_port(options_.host)
            : listener_.bind_to_port(options_.host, options_.port) ? options_.port
                                                                   : -1;
    if (port_ <= 0) {
        throw InputError("cannot listen on " + options_.host + " port " + std::to_string(options_.port) +
                         ": it is taken, or no address of this machine");
    }
    listener_.lengthen_backlog();
}

void Service::House::guard(const Route& route, const httplib::Request& request) const {
    const std::string host = request.get_header_value("Host");
    if (is_loopback(options_.host) && !names_loopback(host)) {
        throw Problem(misdirected, "this server is called localhost");
    }
    if (request.has_header("Origin") && !same_site(request.get_header_value("Origin"), host)) {
        throw Problem(forbidden, "pages of other sites may not ask");
    }
    if (options_.token.empty() || route.open) return;
    if (!brings_token(request.get_header_value("Authorization"), options_.token)) {
        throw Problem(unauthorized, "a token is needed: Authorization: Bearer TOKEN");
    }
}

std::string Service::House::read_body(const Route& route, const httplib::Request& request,
                                      const httplib::ContentReader& reader) const {
    if (route.body == Route::Body::none) return "";
    require_type(route, request);
    std::string body;
    const std::size_t limit = options_.limits.upload_bytes;
    const bool whole = reader([&body, limit](const char* bytes, std::size_t size) {
        if (size > limit - body.size()) return false;
        body.append(bytes, size);
        return true;
    });
    if (!whole) throw Problem(too_large, "the body did not come whole within " + std::to_string(limit) + " bytes");
    return body;
}

void Service::House::serve(const Route& route, const httplib::Request& request, httplib::Response& response,
                           const httplib::ContentReader& reader) {
    const Clock::time_point began = Clock::now();
    std::string detail;
    try {
        guard(route, request);
        Call call{request, read_body(route, request, reader),
                  request.matches.size() > 1 ? request.matches[1].str() : "", nullptr};
        // What a streamed answer is counted by when it is over: the request itself is gone by then.
        const httplib::Request head = [&request] {
            httplib::Request copy;
            copy.method = request.method;
            copy.path = request.path;
            copy.remote_addr = request.remote_addr;
            return copy;
        }();
        call.ended = [this, &route, head, began](int status) { finish(route, head, status, began, ""); };
        route.answer(call, response);
        if (response.content_provider_) return;
    } catch (...) {
        const Failure failure = current_failure();
        detail = failure.detail;
        set_problem(response, failure.status, failure.detail);
    }
    finish(route, request, response.status, began, detail);
}

void Service::House::finish(const Route& route, const httplib::Request& request, int status, Clock::time_point began,
                            const std::string& detail) {
    const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
    metrics_.count_request(route.method, route.path, status, seconds);
    options_.log(log_line({request.remote_addr, request.method, request.path, status, seconds, detail}));
}

// Before anything of the body is read.
bool Service::House::refuse_unknown(const httplib::Request& request, httplib::Response& response) {
    std::string methods;
    for (const Route& route : routes_) {
        if (!route.fits(request.path)) continue;
        if (route.method == request.method || (route.method == "GET" && request.method == "HEAD")) return false;
        methods += (methods.empty() ? "" : ", ") + route.method;
    }
    const Status status = methods.empty() ? not_found : method_not_allowed;
    set_problem(response, status,
                methods.empty() ? "there is nothing here; GET /api/v1/openapi.json describes the service"
                                : "this can only be asked with " + methods);
    if (!methods.empty()) response.set_header("Allow", methods);
    metrics_.count_request("other", "other", status, 0);
    options_.log(log_line({request.remote_addr, request.method, request.path, status}));
    return true;
}

void Service::House::run() {
    options_.log(log_line("listening", "http://" + options_.host + ":" + std::to_string(port_)));
    listener_.listen_after_bind();
    over_ = true;
    options_.log(log_line("stopped", "all requests are answered"));
}

void Service::House::stop() {
    options_.log(log_line("stopping", "what has begun is finished"));
    // httplib takes no notice of a stop that comes before it listens.
    while (!listener_.is_running() && !over_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    listener_.stop();
}

Service::Service(ServiceOptions options) : house_(std::make_unique<House>(std::move(options))) {}
Service::~Service() = default;
int Service::port() const {
    return house_->port();
}
void Service::run() {
    house_->run();
}
void Service::stop() {
    house_->stop();
}

}  // namespace waybreaker::server
