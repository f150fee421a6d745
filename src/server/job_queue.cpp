#include "server/job_queue.hpp"

#include <algorithm>
#include <utility>

namespace waybreaker::server {

Job::State Job::state() const {
    const std::scoped_lock lock(mutex_);
    return state_;
}

double Job::seconds() const {
    const std::scoped_lock lock(mutex_);
    if (state_ == State::queued) return 0;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
}

Progress Job::progress() const {
    const std::scoped_lock lock(mutex_);
    return progress_;
}

void Job::when_done(std::function<void()> call) {
    {
        const std::scoped_lock lock(mutex_);
        if (state_ != State::done) {
            when_done_ = std::move(call);
            return;
        }
    }
    call();
}

double Job::time_limit() const {
    const std::scoped_lock lock(mutex_);
    return time_limit_;
}

Response Job::result() {
    const std::scoped_lock lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
    return std::move(result_);
}

void Job::run() {
    {
        const std::scoped_lock lock(mutex_);
        state_ = State::running;
        began_ = std::chrono::steady_clock::now();
    }
    const auto report = [this](const Progress& progress) {
        const std::scoped_lock lock(mutex_);
        progress_ = progress;
    };
    const auto set_time_limit = [this](double seconds) {
        const std::scoped_lock lock(mutex_);
        time_limit_ = seconds;
    };
    Response result;
    std::exception_ptr failure;
    try {
        if (!stop_.stop_requested()) result = work_({stop_.get_token(), report, set_time_limit});
    } catch (...) {
        failure = std::current_exception();
    }
    work_ = nullptr;  // releases its map
    const std::scoped_lock lock(mutex_);
    result_ = std::move(result);
    failure_ = failure;
}

void Job::finish() {
    std::function<void()> call;
    {
        const std::scoped_lock lock(mutex_);
        state_ = State::done;
        call = std::exchange(when_done_, nullptr);
    }
    if (call) call();
}

JobQueue::JobQueue(unsigned workers, std::size_t waiting_limit) : waiting_limit_(waiting_limit) {
    for (unsigned i = 0; i < std::max(workers, 1U); ++i) {
        workers_.emplace_back([this](const std::stop_token& stop) { serve(stop); });
    }
}

JobQueue::~JobQueue() {
    for (std::jthread& worker : workers_) worker.request_stop();
    {
        const std::scoped_lock lock(mutex_);
        for (const auto& job : queue_) job->stop();
        for (const auto& job : running_) job->stop();
    }
    workers_.clear();  // joins while the other members still exist
}

std::shared_ptr<Job> JobQueue::submit(Work work) {
    auto job = std::make_shared<Job>(std::move(work));
    {
        const std::scoped_lock lock(mutex_);
        // Cancelled jobs do not count, nor do jobs that an idle worker is about to take.
        const auto waits = [](const auto& other) { return !other->stop_.stop_requested(); };
        const auto waiting = std::size_t(std::count_if(queue_.begin(), queue_.end(), waits));
        const std::size_t idle = workers_.size() - std::min(workers_.size(), running_.size());
        if (waiting >= waiting_limit_ + idle) return nullptr;
        queue_.push_back(job);
    }
    ready_.notify_one();
    return job;
}

std::size_t JobQueue::waiting() const {
    const std::scoped_lock lock(mutex_);
    return queue_.size();
}

std::size_t JobQueue::running() const {
    const std::scoped_lock lock(mutex_);
    return running_.size();
}

void JobQueue::serve(const std::stop_token& stop) {
    while (true) {
        std::shared_ptr<Job> job;
        {
            std::unique_lock lock(mutex_);
            if (!ready_.wait(lock, stop, [this] { return !queue_.empty(); })) return;
            job = std::move(queue_.front());
            queue_.pop_front();
            running_.push_back(job);
        }
        job->run();
        {
            const std::scoped_lock lock(mutex_);
            std::erase(running_, job);
        }
        // Last: a client that asks again as soon as it has the response must find the worker idle.
        job->finish();
    }
}

}  // namespace waybreaker::server
