// Planning in slices: the thread that plans and the one that steps hand each other a baton, so that one of them runs at
// a time. The planner looks at its stop token often; there the baton goes back when the slice is over.
#include <chrono>
#include <exception>
#include <optional>
#include <utility>
#ifndef WAYBREAKER_NO_THREADS
#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>
#endif

#include "core/parallel.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {

using Clock = std::chrono::steady_clock;

class PlanningJob::Work {
  public:
    Work(Planner& planner, const Map& map, Mission mission, Method method, Limits limits)
        : planner_(planner),
          map_(map),
          mission_(std::move(mission)),
          method_(method),
          limits_(std::move(limits)),
          asked_(limits_.stop) {
        limits_.threads = 1;
        limits_.stop = stop_.get_token();
    }
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;
    ~Work() {
        stop_.request_stop();
        if (begun_) step(Clock::time_point::max());
    }

    bool done() const { return done_; }

    bool step(Clock::time_point end) {
        if (done_) return true;
        end_ = end;
        begun_ ? resume() : begin();
        return done_;
    }

    Plan take() {
        step(Clock::time_point::max());
        if (!plan_) std::rethrow_exception(error_);
        return std::move(*plan_);
    }

  private:
    void run() {
        try {
            plan_ = planner_.plan(map_, mission_, method_, limits_);
        } catch (...) {
            error_ = std::current_exception();
        }
    }

#ifdef WAYBREAKER_NO_THREADS
    void begin() {
        run();
        done_ = true;
    }
    void resume() {}
    void pause() {}
#else
    void begin() {
        begun_ = true;
        running_ = true;
        try {
            thread_.start([this] {
                run();
                const std::scoped_lock lock(mutex_);
                done_ = true;
                running_ = false;
                handed_.notify_all();
            });
        } catch (const std::system_error&) {  // there are no more threads
            end_ = Clock::time_point::max();
            run();
            done_ = true;
            return;
        }
        wait();
    }
    void resume() {
        {
            const std::scoped_lock lock(mutex_);
            running_ = true;
            handed_.notify_all();
        }
        wait();
    }
    void wait() {
        std::unique_lock lock(mutex_);
        handed_.wait(lock, [this] { return !running_; });
    }
    // Of the thread that plans.
    void pause() {
        if (Clock::now() < end_) return;
        std::unique_lock lock(mutex_);
        running_ = false;
        handed_.notify_all();
        handed_.wait(lock, [this] { return running_; });
    }
#endif

    Planner& planner_;
    const Map& map_;
    const Mission mission_;
    const Method method_;
    Limits limits_;
    const StopToken asked_;  // by whoever started the job
    StopSource stop_{[this] {
        pause();
        return asked_.stop_requested();
    }};
    // Each is the running thread's alone, as the mutex hands the baton on.
    Clock::time_point end_;  // of the slice
    bool begun_ = false;
    bool done_ = false;
    std::optional<Plan> plan_;
    std::exception_ptr error_;
#ifndef WAYBREAKER_NO_THREADS
    std::mutex mutex_;
    std::condition_variable handed_;
    bool running_ = false;
    Joined thread_;  // last: it uses all the others
#endif
};

PlanningJob::PlanningJob(std::unique_ptr<Work> work) : work_(std::move(work)) {}
PlanningJob::PlanningJob(PlanningJob&&) noexcept = default;
PlanningJob& PlanningJob::operator=(PlanningJob&&) noexcept = default;
PlanningJob::~PlanningJob() = default;

bool PlanningJob::step(std::chrono::nanoseconds time) {
    const Clock::time_point now = Clock::now();
    return work_->step(time < Clock::time_point::max() - now ? now + time : Clock::time_point::max());
}
bool PlanningJob::done() const {
    return work_->done();
}
Plan PlanningJob::plan() {
    return work_->take();
}

PlanningJob Planner::start(const Map& map, const Mission& mission, const Method& method, const Limits& limits) {
    validate(map, mission, method, limits);
    return PlanningJob(std::make_unique<PlanningJob::Work>(*this, map, mission, method, limits));
}

}  // namespace waybreaker
