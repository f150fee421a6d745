#include "http/job_queue.hpp"

#include <algorithm>
#include <utility>

#include "http/problem.hpp"

namespace waybreaker::http {

Job::State Job::state() const {
    const std::scoped_lock lock(mutex_);
    return state_;
}

double Job::seconds() const {
    const std::scoped_lock lock(mutex_);
    if (state_ == State::queued) return 0;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
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
    const auto set_time_limit = [this](double seconds) {
        const std::scoped_lock lock(mutex_);
        time_limit_ = seconds;
    };
    Response result;
    std::exception_ptr failure;
    try {
        if (!stop_.stop_requested()) result = work_({stop_.get_token(), set_time_limit});
    } catch (...) {
        failure = std::current_exception();
    }
    work_ = nullptr;  // releases its map
    const std::scoped_lock lock(mutex_);
    result_ = std::move(result);
    failure_ = failure;
}

// The job never starts, as others need its room.
void Job::displace() {
    work_ = nullptr;
    {
        const std::scoped_lock lock(mutex_);
        failure_ = std::make_exception_ptr(
            Problem(unavailable,
                    "many requests of this client are waiting, and others have their turn; ask again in a moment"));
    }
    finish();
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
        for (const Line& line : lines_) {
            for (const auto& job : line.jobs) job->stop();
        }
        for (const auto& job : running_) job->stop();
    }
    workers_.clear();  // joins while the other members still exist
}

void JobQueue::forget_stopped() {
    for (Line& line : lines_) {
        std::erase_if(line.jobs, [](const auto& job) { return job->stop_.stop_requested(); });
    }
    std::erase_if(lines_, [](const Line& line) { return line.jobs.empty(); });
}

std::size_t JobQueue::waiting_jobs() const {
    std::size_t jobs = 0;
    for (const Line& line : lines_) jobs += line.jobs.size();
    return jobs;
}

// The job that leaves the queue for one of the client's; null if no client has more than that one has with it.
std::shared_ptr<Job> JobQueue::make_room(const std::string& client) {
    const auto own = std::ranges::find(lines_, client, &Line::client);
    const auto longest = std::ranges::max_element(lines_, {}, [](const Line& line) { return line.jobs.size(); });
    const std::size_t wanted = own == lines_.end() ? 1 : own->jobs.size() + 1;
    if (longest == lines_.end() || longest->jobs.size() <= wanted) return nullptr;
    std::shared_ptr<Job> job = std::move(longest->jobs.back());
    longest->jobs.pop_back();
    return job;
}

std::shared_ptr<Job> JobQueue::submit(Work work, const std::string& client) {
    auto job = std::make_shared<Job>(std::move(work));
    std::shared_ptr<Job> displaced;
    {
        const std::scoped_lock lock(mutex_);
        forget_stopped();
        // Jobs that an idle worker is about to take do not count.
        const std::size_t idle = workers_.size() - std::min(workers_.size(), running_.size());
        if (waiting_jobs() >= waiting_limit_ + idle) {
            ++refused_;
            displaced = make_room(client);
            if (!displaced) return nullptr;
        }
        const auto line = std::ranges::find(lines_, client, &Line::client);
        (line == lines_.end() ? lines_.emplace_back(client) : *line).jobs.push_back(job);
    }
    if (displaced) displaced->displace();
    ready_.notify_one();
    return job;
}

// The client whose turn it was goes to the end.
std::shared_ptr<Job> JobQueue::take_next() {
    Line line = std::move(lines_.front());
    lines_.pop_front();
    std::shared_ptr<Job> job = std::move(line.jobs.front());
    line.jobs.pop_front();
    if (!line.jobs.empty()) lines_.push_back(std::move(line));
    return job;
}

std::size_t JobQueue::waiting() const {
    const std::scoped_lock lock(mutex_);
    return waiting_jobs();
}

std::size_t JobQueue::refused() const {
    const std::scoped_lock lock(mutex_);
    return refused_;
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
            const auto has_work = [this] {
                forget_stopped();
                return !lines_.empty();
            };
            if (!ready_.wait(lock, stop, has_work)) return;
            job = take_next();
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

}  // namespace waybreaker::http
