#include "server/service.hpp"

#include <sys/socket.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <utility>
#include <vector>

#include "server/desk.hpp"
#include "server/framing.hpp"
#include "server/guard.hpp"
#include "server/header_list.hpp"
#include "server/listener.hpp"
#include "server/log_line.hpp"
#include "server/map_shelf.hpp"
#include "server/metrics.hpp"
#include "server/page.hpp"
#include "server/problem.hpp"
#include "server/routes.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::server {
namespace {

using Clock = std::chrono::steady_clock;

// What is asked for where there is nothing, or in a way that no route knows.
constexpr auto other_route = "other";

class WrongMethod : public Problem {
  public:
    explicit WrongMethod(const std::string& allowed)
        : Problem(method_not_allowed, "this can only be asked with " + allowed), allowed_(allowed) {}
    const std::string& allowed() const { return allowed_; }

  private:
    std::string allowed_;
};

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

Response problem(int status, const std::string& detail, std::string_view kind = "") {
    Response response{.status = status, .type = "application/problem+json", .body = problem_json(status, detail, kind)};
    if (status == unavailable) response.headers.add("Retry-After", "1");
    if (status == unauthorized) response.headers.add("WWW-Authenticate", "Bearer");
    return response;
}

Request request_of(const httplib::Request& asked) {
    Request request{.method = asked.method, .path = asked.path, .client = asked.remote_addr};
    for (const auto& [name, value] : asked.params) request.query.add(name, value);
    for (const auto& [name, value] : asked.headers) request.headers.add(name, value);
    return request;
}

void give(const Response& response, httplib::Response& target) {
    target.status = response.status;
    for (const auto& [name, value] : response.headers) {
        target.headers.erase(name);
        target.set_header(name, value);
    }
    if (!response.type.empty()) target.set_content(std::string(response.body.bytes()), response.type);
}

// The type must be one that pages of other sites cannot send here without being asked for leave first.
void require_body(const Route& route, const httplib::Request& request, std::size_t limit) {
    const std::string wanted = route.body == Route::Body::json ? "application/json" : "application/octet-stream";
    const std::string given = request.get_header_value("Content-Type");
    if (route.body == Route::Body::none) return;
    if (trimmed(given.substr(0, given.find(';'))) != wanted) {
        throw Problem(unsupported_type, "the body must be sent as " + wanted);
    }
    if (body_length(request) > limit) {
        throw Problem(too_large, "the body has more than " + std::to_string(limit) + " bytes");
    }
}

const std::string& told_to_log(const Failure& failure) {
    return failure.cause.empty() ? failure.detail : failure.cause;
}

std::chrono::milliseconds milliseconds(double seconds) {
    return std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::duration<double>(seconds));
}

httplib::Server::HandlerResponse unless(bool admitted) {
    return admitted ? httplib::Server::HandlerResponse::Unhandled : httplib::Server::HandlerResponse::Handled;
}

}  // namespace

class Service::House {
  public:
    explicit House(ServiceOptions options);

    int port() const { return port_; }
    void run();
    void stop();

  private:
    void add_handlers();
    void bind();
    // The route that is asked for. Throws Problem if there is none, or it must not be asked like this.
    const Route& route_of(const httplib::Request& request) const;
    void guard(const Route& route, const httplib::Request& request) const;
    // Whether the request may go on; else it is answered. Before anything of its body is read.
    bool admit(const httplib::Request& request, httplib::Response& response);
    void serve(const httplib::Request& request, httplib::Response& response, const httplib::ContentReader& reader);
    // Plans meanwhile told as events.
    void stream(const std::shared_ptr<Job>& job, const Route& route, const Request& request, Clock::time_point began,
                httplib::Response& response);
    std::string read_body(const Route& route, const httplib::ContentReader& reader) const;
    // Counts and logs an answer.
    void finish(const std::string& route, const Request& request, int status, Clock::time_point began,
                const std::string& detail);

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
      listener_({.reading = milliseconds(options_.limits.patience),
                 .writing = milliseconds(options_.limits.patience),
                 .idle = milliseconds(options_.limits.idle),
                 .bytes = options_.limits.upload_bytes + (std::size_t{1} << 16)},
                options_.limits.connections) {
    require_safe(options_);
    for (Route& route : page_routes()) routes_.push_back(std::move(route));
    listener_.set_payload_max_length(options_.limits.upload_bytes);
    listener_.set_default_headers(safe_headers);
    listener_.set_tcp_nodelay(true);
    // httplib's own choice would let two servers share a port.
    listener_.set_socket_options([](socket_t socket) {
        const int yes = 1;
        ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    add_handlers();
    bind();
}

void Service::House::add_handlers() {
    listener_.set_expect_100_continue_handler([this](const httplib::Request& request, httplib::Response& response) {
        constexpr int go_on = 100;
        return admit(request, response) ? go_on : response.status;
    });
    listener_.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
        return unless(admit(request, response));
    });
    const auto answer = [this](const httplib::Request& request, httplib::Response& response,
                               const httplib::ContentReader& reader) { serve(request, response, reader); };
    // Which path is whose, we say: httplib would try one regular expression after the other.
    listener_.Get(".*", [answer](const httplib::Request& request, httplib::Response& response) {
        answer(request, response, {nullptr, nullptr});
    });
    listener_.Post(".*", answer);
    listener_.Delete(".*", answer);
    // What httplib refuses by itself: requests that are no HTTP.
    listener_.set_error_handler(httplib::Server::Handler([](const httplib::Request&, httplib::Response& response) {
        if (!response.body.empty()) return;
        give(problem(response.status, "the request cannot be taken as it is"), response);
        response.set_header("Connection", "close");
    }));
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

const Route& Service::House::route_of(const httplib::Request& request) const {
    std::string methods;
    for (const Route& route : routes_) {
        if (!route.id_in(request.path)) continue;
        if (route.method == request.method || (route.method == "GET" && request.method == "HEAD")) return route;
        methods += (methods.empty() ? "" : ", ") + route.method;
    }
    if (methods.empty()) throw Problem(not_found, "there is nothing here; GET /api/v1/openapi.json describes it all");
    throw WrongMethod(methods);
}

bool Service::House::admit(const httplib::Request& request, httplib::Response& response) {
    const Clock::time_point began = Clock::now();
    std::string name = other_route;
    std::string detail;
    try {
        check_framing(request);
        const Route& route = route_of(request);
        name = route.path;
        guard(route, request);
        require_body(route, request, options_.limits.upload_bytes);
        return true;
    } catch (const WrongMethod& problem) {
        response.set_header("Allow", problem.allowed());
        give(server::problem(problem.status(), detail = problem.what()), response);
    } catch (const Problem& problem) {
        give(server::problem(problem.status(), detail = problem.what()), response);
    }
    finish(name, request_of(request), response.status, began, detail);
    return false;
}

std::string Service::House::read_body(const Route& route, const httplib::ContentReader& reader) const {
    if (route.body == Route::Body::none) return "";
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

void Service::House::serve(const httplib::Request& request, httplib::Response& response,
                           const httplib::ContentReader& reader) {
    const Clock::time_point began = Clock::now();
    const Route& route = route_of(request);
    const Request head = request_of(request);
    std::string detail;
    try {
        Call call{head, route.id_in(request.path).value_or("")};
        call.request.body = read_body(route, reader);
        Answer answer = route.answer(std::move(call));
        if (auto* later = std::get_if<Later>(&answer)) {
            const std::shared_ptr<Job> job = desk_.submit(std::move(later->work));
            if (later->events) return stream(job, route, head, began, response);
            answer = desk_.wait_for(*job, [&request] { return client_is_there(request); });
        }
        give(std::get<Response>(answer), response);
    } catch (...) {
        const Failure failure = current_failure();
        detail = told_to_log(failure);
        give(problem(failure.status, failure.detail, failure.kind), response);
    }
    finish(route.path, head, response.status, began, detail);
}

void Service::House::stream(const std::shared_ptr<Job>& job, const Route& route, const Request& request,
                            Clock::time_point began, httplib::Response& response) {
    const auto tell = [this, job, name = route.path, request, began](std::size_t, httplib::DataSink& sink) {
        const Failure outcome = desk_.tell(*job, [&sink](const std::string& text) {
            return sink.is_writable() && sink.write(text.data(), text.size());
        });
        finish(name, request, outcome.status, began, told_to_log(outcome));
        if (outcome.status != client_gone) sink.done();
        return outcome.status != client_gone;
    };
    response.set_chunked_content_provider("text/event-stream", tell);
}

void Service::House::finish(const std::string& route, const Request& request, int status, Clock::time_point began,
                            const std::string& detail) {
    const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
    const bool known = route != other_route;
    metrics_.count_request(known ? request.method : other_route, route, status, seconds);
    options_.log(log_line({request.client, request.method, request.path, status, seconds, detail}));
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
