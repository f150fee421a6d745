#include "experiment/run.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <filesystem>
#include <iterator>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "core/parallel.hpp"
#include "experiment/crash_note.hpp"
#include "experiment/evaluate.hpp"
#include "experiment/map_cache.hpp"

namespace waybreaker::experiment {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr auto tick = std::chrono::milliseconds(50);          // how exactly time limits are kept
constexpr auto store_every = std::chrono::milliseconds(500);  // at most this much work is lost by kill -9

Evaluate usual_evaluator() {
    return [evaluator = std::make_shared<Evaluator>()](const Map& map, const ExperimentMission& mission,
                                                       const Configuration& configuration, const StopToken& stop) {
        return evaluator->evaluate(map, mission, configuration, stop);
    };
}

// Watches the job of one thread, and stops it if it takes too long.
class Watchdog {
  public:
    StopToken begin() {
        const std::scoped_lock lock(mutex_);
        since_ = Clock::now();
        stop_ = StopSource();
        return stop_.get_token();
    }
    void stop_if_longer(double seconds) {
        const std::scoped_lock lock(mutex_);
        if (Seconds(Clock::now() - since_).count() > seconds) stop_.request_stop();
    }

  private:
    std::mutex mutex_;
    Clock::time_point since_;
    StopSource stop_;
};

// The threads and their results; the caller of run() waits, enforces time limits and stores results.
class Work {
  public:
    Work(const Experiment& experiment, std::vector<std::uint64_t> jobs, const RunOptions& options)
        : experiment_(experiment),
          jobs_(std::move(jobs)),
          maps_(experiment.maps),
          watchdogs_(std::clamp<std::size_t>(jobs_.size(), 1, thread_count(options.threads))) {
        for (Watchdog& watchdog : watchdogs_) {
            watchdog.begin();
            threads_.emplace_back(
                [this, &watchdog, evaluate = options.evaluators ? options.evaluators() : usual_evaluator()] {
                    work(watchdog, evaluate);
                });
        }
    }
    ~Work() { end(); }
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;

    unsigned threads() const { return unsigned(threads_.size()); }

    // Results since the last call, after a while or when all is done.
    std::vector<Row> wait() {
        std::unique_lock lock(mutex_);
        idle_.wait_for(lock, tick, [&] { return working_ == 0; });
        return std::exchange(rows_, {});
    }
    bool done() {
        const std::scoped_lock lock(mutex_);
        return working_ == 0 && rows_.empty();
    }
    void keep_time_limit() {
        for (Watchdog& watchdog : watchdogs_) watchdog.stop_if_longer(experiment_.time_limit);
    }
    // Starts no more jobs; running ones are stopped and leave no result.
    void end() {
        ending_ = true;
        while (true) {
            for (Watchdog& watchdog : watchdogs_) watchdog.stop_if_longer(0);
            std::unique_lock lock(mutex_);
            if (idle_.wait_for(lock, tick, [&] { return working_ == 0; })) return;
        }
    }
    void rethrow() {
        const std::scoped_lock lock(mutex_);
        if (error_) std::rethrow_exception(error_);
    }

  private:
    void work(Watchdog& watchdog, const Evaluate& evaluate) {
        try {
            std::shared_ptr<const Map> map;
            std::size_t map_index = SIZE_MAX;
            for (std::size_t i = next_++; i < jobs_.size() && !ending_; i = next_++) {
                const std::size_t configurations = experiment_.configurations.size();
                const ExperimentMission& mission = experiment_.missions[jobs_[i] / configurations];
                if (mission.map != map_index) map = maps_.load(map_index = mission.map);
                const StopToken stop = watchdog.begin();
                const CurrentJob current(jobs_[i]);
                Row row{jobs_[i], evaluate(*map, mission, experiment_.configurations[jobs_[i] % configurations], stop)};
                const std::scoped_lock lock(mutex_);
                if (!ending_) rows_.push_back(std::move(row));
            }
        } catch (...) {
            const std::scoped_lock lock(mutex_);
            error_ = std::current_exception();
            ending_ = true;
        }
        const std::scoped_lock lock(mutex_);
        if (--working_ == 0) idle_.notify_all();
    }

    const Experiment& experiment_;
    const std::vector<std::uint64_t> jobs_;
    MapCache maps_;
    std::vector<Watchdog> watchdogs_;
    std::atomic<std::size_t> next_ = 0;
    std::atomic<bool> ending_ = false;
    std::mutex mutex_;
    std::condition_variable idle_;
    std::vector<Row> rows_;
    std::exception_ptr error_;
    std::size_t working_ = watchdogs_.size();
    std::vector<std::jthread> threads_;  // last: joined before the rest goes
};

bool went_wrong(const Row& row) {
    return row.result.status != ResultStatus::solved && row.result.status != ResultStatus::no_plan;
}

// Results of jobs that crashed twice.
std::vector<Row> crashed_rows(const std::string& note, const std::vector<std::uint64_t>& open) {
    std::vector<Row> rows;
    for (const auto& [job, times] : noted_crashes(note)) {
        if (times < 2 || !std::ranges::binary_search(open, job)) continue;
        rows.push_back({job, {.status = ResultStatus::crashed, .message = "took the program down twice"}});
    }
    return rows;
}

}  // namespace

RunProgress run(const Experiment& experiment, Store& store, const RunOptions& options) {
    const std::string note = store.path() + ".crashes";
    RunProgress progress;
    progress.jobs = store.job_count();
    const auto keep = [&](std::vector<Row>& rows) {
        store.add(rows);
        progress.stored += rows.size();
        progress.unsolved += std::size_t(std::ranges::count_if(rows, went_wrong));
        for (const Row& row : rows) progress.planning += row.result.seconds;
        rows.clear();
    };

    std::vector<std::uint64_t> open = store.open_jobs();
    progress.begun_with = progress.stored = progress.jobs - open.size();
    if (std::vector<Row> crashed = crashed_rows(note, open); !crashed.empty()) {
        keep(crashed);
        open = store.open_jobs();
    }

    const CrashNote noting(note);
    const Clock::time_point begin = Clock::now();
    Work work(experiment, std::move(open), options);
    progress.threads = work.threads();
    std::vector<Row> rows;
    Clock::time_point stored = begin;
    while (!work.done() && !options.stop.stop_requested()) {
        std::ranges::move(work.wait(), std::back_inserter(rows));
        work.keep_time_limit();
        if (Clock::now() - stored < store_every && !work.done()) continue;
        keep(rows);
        stored = Clock::now();
        progress.seconds = Seconds(stored - begin).count();
        if (options.progress) options.progress(progress);
    }
    keep(rows);
    progress.seconds = Seconds(Clock::now() - begin).count();
    work.rethrow();
    if (progress.stored == progress.jobs) std::filesystem::remove(note);
    return progress;
}

}  // namespace waybreaker::experiment
