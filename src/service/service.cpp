#include "service/service.hpp"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

#include "core/in_quotes.hpp"
#include "http/exchange.hpp"
#include "http/guard.hpp"
#include "http/listener.hpp"
#include "http/log_line.hpp"
#include "http/problem.hpp"
#include "http/request_body.hpp"
#include "service/executor.hpp"
#include "service/failure.hpp"
#include "service/import_routes.hpp"
#include "service/importer.hpp"
#include "service/live_missions.hpp"
#include "service/map_store.hpp"
#include "service/memory_budget.hpp"
#include "service/metrics.hpp"
#include "service/metrics_route.hpp"
#include "service/mission_routes.hpp"
#include "service/mission_store.hpp"
#include "service/overlay_route.hpp"
#include "service/page.hpp"
#include "service/plan_events.hpp"
#include "service/planner_pool.hpp"
#include "service/problem_kind.hpp"
#include "service/routes.hpp"
#include "service/source_store.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::service {
namespace {

using Clock = std::chrono::steady_clock;

// For requests that match no route.
constexpr auto other_route = "other";

class WrongMethod : public http::Problem {
  public:
    explicit WrongMethod(const std::string& allowed)
        : http::Problem(http::method_not_allowed, "this can only be asked with " + allowed), allowed_(allowed) {}
    const std::string& allowed() const { return allowed_; }

  private:
    std::string allowed_;
};

const http::Fields safe_headers{
    {"Content-Security-Policy", "default-src 'none'; frame-ancestors 'none'; base-uri 'none'; form-action 'none'"},
    {"X-Content-Type-Options", "nosniff"},
    {"X-Frame-Options", "DENY"},
    {"Referrer-Policy", "no-referrer"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Cache-Control", "no-store"}};

void require_safe(const ServiceOptions& options) {
    for (const std::string& name : options.names) {
        if (!http::is_host_name(name))
            throw InputError("--name takes the name of a host, without a port, not " + in_quotes(name));
    }
    if (!options.token.empty() && !http::is_bearer_token(options.token)) {
        throw InputError("--token has blanks at an end, or control characters: no client can send it; give a word");
    }
    if (http::is_loopback(options.host) || !options.token.empty() || options.insecure) return;
    throw InputError("other machines can reach " + options.host +
                     ": give a --token that they must bring, or say --insecure");
}

http::Response problem_response(int status, const std::string& detail, std::string_view kind = "") {
    http::Response response{
        .status = status, .type = "application/problem+json", .body = problem_json(status, detail, kind)};
    if (status == http::unavailable) response.headers.add("Retry-After", "1");
    if (status == http::unsupported_type) response.headers.add("Accept-Encoding", "gzip");
    if (status == http::unauthorized) response.headers.add("WWW-Authenticate", "Bearer");
    return response;
}

const std::string& log_text(const Failure& failure) {
    return failure.cause.empty() ? failure.detail : failure.cause;
}

std::chrono::milliseconds rounded(double seconds) {
    return std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::duration<double>(seconds));
}

// What is logged of a request.
struct AccessRecord {
    std::string route = other_route;
    std::string method = {};
    std::string path = {};
    std::string client = {};
    Clock::time_point began = Clock::now();
    std::atomic<bool> closed = false;

    AccessRecord() = default;
    AccessRecord(std::string name, const http::Request& request)
        : route(std::move(name)),
          method(request.method),
          path(request.path),
          client(request.client),
          began(request.began) {}
};

}  // namespace

class Service::Impl : public http::RequestHandler {
  public:
    explicit Impl(ServiceOptions options);

    int port() const { return listener_.port(); }
    std::string url() const;
    void run();
    void stop();

    http::Admission admit(const http::Request& head, std::optional<std::uint64_t> length) override;
    void serve(http::Request request, std::shared_ptr<http::Exchange> exchange) override;
    http::Response refuse(const http::Problem& problem, const std::string& client) override;

  private:
    using SharedRecord = std::shared_ptr<AccessRecord>;

    http::ListenerOptions listener_options();
    // Throws Problem if no route has that path and method.
    const Route& route_of(const http::Request& request) const;
    void guard(const Route& route, const http::Request& request) const;
    bool is_mine(const std::string& host) const;
    void wait(Deferred deferred, const std::shared_ptr<http::Exchange>& exchange, const SharedRecord& record);
    // Counts and logs the response, once.
    void close(AccessRecord& record, int status, const std::string& detail = "");

    // Lets the bodies being received count so many bytes in the budget; false if there is no room for more.
    bool hold(std::size_t bytes);
    // The response, whose memory counts until it is sent; or that there is none.
    http::Response counted(http::Response response);
    // From time to time gives back what nobody has used for a while.
    void tidy(const std::stop_token& stop);

    ServiceOptions options_;
    Metrics metrics_;
    MemoryBudget budget_;
    MemoryBudget::Share bodies_{budget_, MemoryBudget::Use::request};
    std::unique_ptr<MissionStore> mission_store_;
    PlannerPool planners_;  // gives back memory before the maps do
    MapStore store_;
    LiveMissions missions_;
    Importer importer_;
    SourceStore sources_;
    http::Listener listener_;  // outlives the executor, whose jobs answer through it
    Executor executor_;
    std::vector<Route> routes_;
    std::jthread tidying_;
};

Service::Impl::Impl(ServiceOptions options)
    : options_((require_safe(options), std::move(options))),
      budget_(options_.limits.memory),
      mission_store_(open_store(options_.store, options_.limits, options_.log)),
      planners_(budget_),
      store_(options_.maps, options_.limits, budget_, mission_store_.get()),
      missions_(*mission_store_, store_, planners_, options_.limits, budget_),
      importer_(options_.import_worker, options_.limits, budget_),
      sources_(importer_, budget_),
      listener_(listener_options(), *this),
      executor_(options_.limits, metrics_, budget_),
      routes_(routes(store_, planners_, options_.limits)) {
    routes_.push_back(metrics_route(metrics_, store_, executor_, missions_, budget_));
    for (Route& route : mission_routes(missions_, store_)) routes_.push_back(std::move(route));
    for (Route& route : import_routes(importer_, sources_, store_)) routes_.push_back(std::move(route));
    routes_.push_back(overlay_route(importer_, store_));
    for (Route& route : page_routes()) routes_.push_back(std::move(route));
    tidying_ = std::jthread([this](const std::stop_token& stop) { tidy(stop); });
}

void Service::Impl::tidy(const std::stop_token& stop) {
    constexpr std::chrono::seconds pause(1);
    constexpr std::chrono::seconds rest(10);
    std::mutex mutex;
    std::condition_variable_any stopped;
    std::unique_lock lock(mutex);
    while (!stopped.wait_for(lock, stop, pause, [] { return false; }) && !stop.stop_requested()) {
        planners_.release_rested(rest);
        sources_.forget_expired();
        budget_.trim();
    }
}

bool Service::Impl::hold(std::size_t bytes) {
    if (bytes > bodies_.bytes()) return bodies_.grow(bytes - bodies_.bytes());
    bodies_.shrink_to(bytes);
    return true;
}

http::Response Service::Impl::counted(http::Response response) {
    constexpr std::size_t small = 65536;  // as of requests
    const std::size_t bytes = response.body.bytes().size();
    if (!response.body.is_own() || bytes <= small) return response;
    const auto share = std::make_shared<MemoryBudget::Share>(budget_, MemoryBudget::Use::answer);
    if (!share->grow(bytes)) {
        throw http::Problem(http::unavailable,
                            "answers on their way to slow clients leave no memory for this one; ask again",
                            "no-memory");
    }
    response.body.keep(share);
    return response;
}

// Whether a Host may be asked for: any, if neither is said what the server is called nor that it is for this machine.
bool Service::Impl::is_mine(const std::string& host) const {
    if (http::names_loopback(host) || http::names_one_of(host, options_.names)) return true;
    return !http::is_loopback(options_.host) && (options_.names.empty() || http::is_address(host));
}

std::string Service::Impl::url() const {
    const bool has_colons = options_.host.find(':') != std::string::npos;  // IPv6
    return fmt::format("http://{}:{}", has_colons ? "[" + options_.host + "]" : options_.host, port());
}

http::ListenerOptions Service::Impl::listener_options() {
    const ServiceLimits& limits = options_.limits;
    return {.host = options_.host,
            .port = options_.port,
            .timeouts = {.reading = rounded(limits.timeout),
                         .writing = rounded(limits.timeout),
                         .idle = rounded(limits.idle)},
            .connections = limits.connections,
            .connections_of_client = limits.connections_of_client,
            .body_bytes = limits.upload_bytes,
            .headers = safe_headers,
            .hold = [this](std::size_t bytes) { return hold(bytes); }};
}

void Service::Impl::guard(const Route& route, const http::Request& request) const {
    const std::string host = request.headers.get("Host");
    if (!is_mine(host)) {
        throw http::Problem(http::misdirected,
                            "this server is not called that; --name tells it what it is called beside localhost");
    }
    if (const auto origin = request.headers.find("Origin"); origin && !http::same_site(*origin, host)) {
        throw http::Problem(http::forbidden, "pages of other sites may not ask");
    }
    if (options_.token.empty() || route.open) return;
    if (!http::brings_token(request.headers.get("Authorization"), options_.token)) {
        throw http::Problem(http::unauthorized, "a token is needed: Authorization: Bearer TOKEN");
    }
}

const Route& Service::Impl::route_of(const http::Request& request) const {
    std::string methods;
    for (const Route& route : routes_) {
        if (!route.id_in(request.path)) continue;
        if (route.method == request.method || (route.method == "GET" && request.method == "HEAD")) return route;
        methods += (methods.empty() ? "" : ", ") + route.method;
    }
    if (methods.empty())
        throw http::Problem(http::not_found, "there is nothing here; GET /api/v1/openapi.json describes it all");
    throw WrongMethod(methods);
}

http::Admission Service::Impl::admit(const http::Request& head, std::optional<std::uint64_t> length) {
    AccessRecord record(other_route, head);
    http::Response refusal;
    std::string detail;
    try {
        const Route& route = route_of(head);
        record.route = route.path;
        guard(route, head);
        http::require_body(head, length, route.body, options_.limits.upload_bytes);
        return {.body = route.body != http::BodyType::none, .quick = route.quick};
    } catch (const WrongMethod& problem) {
        refusal = problem_response(problem.status(), detail = problem.what(), problem.kind());
        refusal.headers.add("Allow", problem.allowed());
    } catch (const http::Problem& problem) {
        refusal = problem_response(problem.status(), detail = problem.what(), problem.kind());
    }
    close(record, refusal.status, detail);
    return {.refusal = std::move(refusal)};
}

http::Response Service::Impl::refuse(const http::Problem& problem, const std::string& client) {
    AccessRecord record;
    record.client = client;
    close(record, problem.status(), problem.what());
    return problem_response(problem.status(), problem.what(), problem.kind());
}

void Service::Impl::serve(http::Request request, std::shared_ptr<http::Exchange> exchange) {
    const Route& route = route_of(request);
    const auto record = std::make_shared<AccessRecord>(route.path, request);
    try {
        if (route.body != http::BodyType::none) http::unpack(request, options_.limits.upload_bytes);
        std::string id = route.id_in(request.path).value_or("");
        Answer answer = route.answer({std::move(request), std::move(id)});
        if (auto* deferred = std::get_if<Deferred>(&answer)) return wait(std::move(*deferred), exchange, record);
        if (auto* stream = std::get_if<Stream>(&answer)) {
            close(*record, http::ok);  // what comes may take days
            if (record->method == "HEAD") return exchange->answer({.type = "text/event-stream"});
            return exchange->wait({.events = true, .tick = stream->next, .over = stream->over});
        }
        http::Response response = counted(std::move(std::get<http::Response>(answer)));
        close(*record, response.status);
        exchange->answer(std::move(response));
    } catch (...) {
        const Failure failure = current_failure();
        close(*record, failure.status, log_text(failure));
        exchange->answer(problem_response(failure.status, failure.detail, failure.kind));
    }
}

// Responds when the work is done, and stops it when the client disconnects.
void Service::Impl::wait(Deferred deferred, const std::shared_ptr<http::Exchange>& exchange,
                         const SharedRecord& record) {
    const auto progress = std::move(deferred.progress);
    const bool events = bool(progress);
    const std::shared_ptr<http::Job> job = executor_.submit(std::move(deferred.work), deferred.lane, record->client);
    const auto tick = [this, job, progress] {
        executor_.enforce_time_limit(*job);
        return progress ? progress(*job) : std::string();
    };
    const auto gone = [this, job, record] {
        executor_.cancel(*job);
        close(*record, http::client_gone, "the client went away");
    };
    exchange->wait({.events = events, .tick = tick, .gone = gone});
    job->when_done([this, job = job.get(), record, events, waiting = std::weak_ptr(exchange)] {
        http::Response response;
        try {
            response = job->result();
            if (events) response.body = plan_event(response);
            response = counted(std::move(response));
            close(*record, response.status);
        } catch (...) {
            const Failure failure = current_failure();
            close(*record, failure.status, log_text(failure));
            response = problem_response(failure.status, failure.detail, failure.kind);
            if (events) response.body = problem_event(failure);
        }
        if (const auto there = waiting.lock()) there->answer(std::move(response));
    });
}

void Service::Impl::close(AccessRecord& record, int status, const std::string& detail) {
    if (record.closed.exchange(true)) return;
    const double seconds = std::chrono::duration<double>(Clock::now() - record.began).count();
    const bool known = record.route != other_route;
    metrics_.count_request(known ? record.method : other_route, record.route, status, seconds);
    options_.log(http::log_line({record.client, record.method, record.path, status, seconds, detail}));
}

void Service::Impl::run() {
    options_.log(http::log_line("listening", url()));
    listener_.run();
    options_.log(http::log_line("stopped", "all requests are answered"));
}

void Service::Impl::stop() {
    options_.log(http::log_line("stopping", "what has begun is finished"));
    missions_.end_streams();
    listener_.stop();
}

Service::Service(ServiceOptions options) : impl_(std::make_unique<Impl>(std::move(options))) {}
Service::~Service() = default;
int Service::port() const {
    return impl_->port();
}
std::string Service::url() const {
    return impl_->url();
}
void Service::run() {
    impl_->run();
}
void Service::stop() {
    impl_->stop();
}

}  // namespace waybreaker::service
