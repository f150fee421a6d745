#include "experiment/crash_note.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <csignal>
#include <fstream>
#include <iterator>

namespace waybreaker::experiment {
namespace {

constexpr std::array crash_signals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
constexpr std::uint64_t no_job = UINT64_MAX;
constexpr std::size_t longest_path = 4096;

// A signal handler takes no context argument, so what it needs must be global.
std::array<char, longest_path> note_path;
std::array<struct sigaction, crash_signals.size()> former_actions;
thread_local std::uint64_t current_job = no_job;

// Only what is allowed in a signal handler: no allocation, no locks. The signal strikes again after it, by default.
void note(int signal) {
    if (current_job != no_job) {
        std::array<char, 24> line{};
        char* at = line.data() + line.size();
        *--at = '\n';
        std::uint64_t rest = current_job;
        do {
            *--at = char('0' + rest % 10);
            rest /= 10;
        } while (rest > 0);
        const int file = ::open(note_path.data(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
        if (file >= 0) [[maybe_unused]]
            const ssize_t written = ::write(file, at, std::size_t(line.end() - at));
    }
    std::signal(signal, SIG_DFL);
    ::raise(signal);
}

}  // namespace

CrashNote::CrashNote(const std::string& path) {
    assert(path.size() < longest_path);
    std::copy_n(path.c_str(), std::min(path.size() + 1, longest_path - 1), note_path.begin());
    struct sigaction action {};
    action.sa_handler = note;
    for (std::size_t i = 0; i < crash_signals.size(); ++i) ::sigaction(crash_signals[i], &action, &former_actions[i]);
}

CrashNote::~CrashNote() {
    for (std::size_t i = 0; i < crash_signals.size(); ++i) ::sigaction(crash_signals[i], &former_actions[i], nullptr);
}

CurrentJob::CurrentJob(std::uint64_t job) {
    current_job = job;
}

CurrentJob::~CurrentJob() {
    current_job = no_job;
}

std::map<std::uint64_t, int> noted_crashes(const std::string& path) {
    std::map<std::uint64_t, int> times;
    std::ifstream file(path);
    for (std::istream_iterator<std::uint64_t> job(file), end; job != end; ++job) ++times[*job];
    return times;
}

}  // namespace waybreaker::experiment
