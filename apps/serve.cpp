// `waybreaker serve`: the service over HTTP, until a signal ends it.
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "commands.hpp"
#include "help.hpp"
#include "http/log_line.hpp"
#include "option.hpp"
#include "service/import_worker.hpp"
#include "service/service.hpp"

namespace waybreaker::apps {
namespace {

// One thread waits for SIGTERM and SIGINT, all others block them. Must be created before other threads.
class EndSignals {
  public:
    EndSignals() {
        sigemptyset(&signals_);
        sigaddset(&signals_, SIGTERM);
        sigaddset(&signals_, SIGINT);
        pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
    }

    void wait() const {
        int signal = 0;
        sigwait(&signals_, &signal);
    }

  private:
    sigset_t signals_{};
};

void log(const std::string& line) {
    std::fputs(line.c_str(), stderr);
}

void run(service::ServiceOptions options) {
    const EndSignals signals;
    options.log = log;
    options.import_worker = {"/proc/self/exe", service::import_worker_word};
    service::Service service(std::move(options));
    // For a person at a terminal; programs read the log.
    if (isatty(STDOUT_FILENO) == 1) {
        fmt::print("The page is at {}/ - Ctrl-C ends the server\n", service.url());
        std::fflush(stdout);
    }
    std::atomic<bool> ended = false;
    std::thread waiting([&] {
        signals.wait();
        service.stop();
        signals.wait();
        if (ended) return;
        log(http::log_line("stopped", "second signal: unfinished requests are lost"));
        std::_Exit(0);  // without waiting for work that cannot be stopped; it writes nothing
    });
    service.run();
    ended = true;
    pthread_kill(waiting.native_handle(), SIGTERM);  // NOLINT(bugprone-bad-signal-to-kill-thread): it waits for one
    waiting.join();
}

void add_limits(CLI::App& command, service::ServiceLimits& limits) {
    constexpr std::int64_t most = 1'000'000;
    constexpr std::size_t megabyte = std::size_t{1} << 20;
    add_count(
        command, "--max-upload", [&limits](std::int64_t n) { limits.upload_bytes = std::size_t(n) * megabyte; }, 1,
        2048, "Largest body of a request (default: 32)")
        ->type_name("MIB");
    add_count(
        command, "--max-cells", [&limits](std::int64_t n) { limits.map_cells = std::size_t(n); }, 1,
        std::int64_t(max_cells), "Largest uploaded map (default: 16777216)")
        ->type_name("CELLS");
    add_count(
        command, "--max-memory", [&limits](std::int64_t n) { limits.memory = std::size_t(n) * megabyte; }, 1, most,
        "Memory for maps, plans, imports and bodies together, in MiB; when it is full, maps that were sent go, those "
        "not used for longest first (default: half of the machine's)");
    add_count(
        command, "--max-maps", [&limits](std::int64_t n) { limits.maps = std::size_t(n); }, 1, most,
        "Maps held in memory; of more, the one not used for longest goes (default: 32)");
    add_count(
        command, "--live-missions", [&limits](std::int64_t n) { limits.live_missions = std::size_t(n); }, 0, most,
        "Live missions at a time; more are answered with 507 (default: 100)");
    add_number(
        command, "--time-limit", [&limits](double seconds) { limits.seconds = seconds; }, {0.001, 86400}, "SECONDS",
        "Longest time for a plan (default: 30)");
    add_count(
        command, "--workers", [&limits](std::int64_t n) { limits.workers = unsigned(n); }, 1, 1024,
        "Plans at a time (default: 2)");
    add_count(
        command, "--queue", [&limits](std::int64_t n) { limits.queue = std::size_t(n); }, 0, most,
        "Plans that may wait, and as many uploads and imports; more are answered with 503 (default: 16)");
    constexpr std::int64_t most_connections = 1000;  // by default a process may have 1024 files open
    add_count(
        command, "--connections", [&limits](std::int64_t n) { limits.connections = std::size_t(n); }, 1,
        most_connections,
        "Connections at a time; of more, those that ask nothing or are slow are closed (default: 256)");
    add_count(
        command, "--connections-per-client",
        [&limits](std::int64_t n) { limits.connections_of_client = std::size_t(n); }, 1, most_connections,
        "Connections of one address at a time (default: half of --connections, but all for this machine's own "
        "programs, a "
        "proxy among them)");
}

}  // namespace

void setup_serve(CLI::App& root, Run& run_chosen) {
    auto options = std::make_shared<service::ServiceOptions>();
    options->port = 8080;
    CLI::App* command = root.add_subcommand(
        "serve",
        "Serve maps and plans over HTTP, and a page to plan in\n\n"
        "Answers programs of this machine only by default; GET /api/v1/openapi.json describes what can be "
        "asked. Logs a line of JSON for each request to standard error. SIGTERM or Ctrl-C end it: what has begun is "
        "finished, unless a second signal follows.");
    add_file(*command, "--maps", options->maps,
             "A folder of maps to serve, beside those that are built in; no other map is read", "FOLDER");
    add_file(
        *command, "--store", options->store,
        "Where live missions are kept, so that they go on after a restart: a file, begun if there is none, for one "
        "server at a time; or the URL of a PostgreSQL database, postgresql://USER@HOST/DATABASE, which servers share "
        "(default: in memory, gone when the server ends)",
        "FILE|URL");
    add_text(*command, "--host", options->host, "ADDRESS", "Address to listen on (default: 127.0.0.1)");
    constexpr int last_port = 65535;
    add_count(
        *command, "--port", [options](std::int64_t n) { options->port = int(n); }, 0, last_port,
        "Port to listen on; 0 takes one that is free, which the log states (default: 8080)")
        ->type_name("PORT");
    command->option_defaults()->group("Safety");
    add_text(*command, "--token", options->token, "TOKEN",
             "What clients must send: Authorization: Bearer TOKEN (default: WAYBREAKER_TOKEN of the environment, which "
             "other "
             "users of the machine do not see)")
        ->envname("WAYBREAKER_TOKEN");
    command->add_flag("--insecure", options->insecure, "Let other machines ask without a token");
    command
        ->add_option_function<std::string>(
            "--name", [options](const std::string& given) { options->names = CLI::detail::split(given, ','); },
            "What clients call the server: then it answers to no other name but localhost and addresses, and a page of "
            "another site cannot reach it by a name of its own (default: localhost; with --host any name)")
        ->type_name("HOST,...");
    add_limits(*command, options->limits);
    set_examples(*command, {"waybreaker serve --maps data", "waybreaker serve --maps data --store missions.db",
                            "waybreaker serve --store postgresql://waybreaker@db.example/missions",
                            "waybreaker serve --maps data --host 0.0.0.0 --token \"$(openssl rand -hex 16)\""});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps
