#include "http/job_queue.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <stdexcept>

#include "http/problem.hpp"

namespace waybreaker::http {
namespace {

using namespace std::chrono_literals;

// Work that lasts until it is stopped, or `end` is set.
Work endless(std::atomic<bool>& end) {
    return [&end](const Worker& worker) -> Response {
        while (!worker.stop.stop_requested() && !end) std::this_thread::sleep_for(1ms);
        return {.body = worker.stop.stop_requested() ? "stopped" : "ended"};
    };
}

Work quick(const std::string& answer) {
    return [answer](const Worker&) { return Response{.body = answer}; };
}

void wait_for(Job& job) {
    std::promise<void> done;
    job.when_done([&done] { done.set_value(); });
    done.get_future().wait();
}

void wait_for_state(const Job& job, Job::State state) {
    while (job.state() != state) std::this_thread::sleep_for(1ms);
}

TEST(JobQueue, GivesResultsAndFailures) {
    JobQueue queue(2, 4);
    const auto good = queue.submit(quick("done"));
    const auto bad = queue.submit([](const Worker&) -> Response { throw std::runtime_error("no"); });
    wait_for(*good);
    wait_for(*bad);
    EXPECT_EQ(good->result().body.bytes(), "done");
    EXPECT_THROW(bad->result(), std::runtime_error);
}

TEST(JobQueue, LetsSoManyWaitAndNoMore) {
    std::atomic<bool> end = false;
    JobQueue queue(1, 2);
    const auto first = queue.submit(endless(end));
    wait_for_state(*first, Job::State::running);
    const auto second = queue.submit(quick("second"));
    const auto third = queue.submit(quick("third"));
    ASSERT_TRUE(second && third);
    EXPECT_EQ(queue.waiting(), 2U);
    EXPECT_EQ(queue.submit(quick("fourth")), nullptr);
    // Who gave up makes room.
    EXPECT_TRUE(second->stop());
    EXPECT_FALSE(second->stop());
    EXPECT_NE(queue.submit(quick("fourth")), nullptr);
    end = true;
    wait_for(*third);
    EXPECT_EQ(third->result().body.bytes(), "third");
    EXPECT_EQ(first->result().body.bytes(), "ended");
    EXPECT_EQ(second->result().body.bytes(), "");
}

// Work that notes that it was done.
Work noted(std::string& order, char letter) {
    return [&order, letter](const Worker&) {
        order += letter;
        return Response();
    };
}

TEST(JobQueue, ClientsTakeTurns) {
    std::atomic<bool> end = false;
    std::string order;  // one worker writes it
    JobQueue queue(1, 16);
    const auto first = queue.submit(endless(end), "busy");
    wait_for_state(*first, Job::State::running);
    std::vector<std::shared_ptr<Job>> jobs;
    for (int i = 0; i < 4; ++i) jobs.push_back(queue.submit(noted(order, 'a'), "busy"));
    for (int i = 0; i < 2; ++i) jobs.push_back(queue.submit(noted(order, 'b'), "other"));
    jobs.push_back(queue.submit(noted(order, 'c'), "third"));
    // What was given up takes no turn.
    EXPECT_TRUE(jobs[0]->stop());
    end = true;
    for (const std::size_t i : {1U, 2U, 3U, 4U, 5U, 6U}) wait_for(*jobs[i]);
    EXPECT_EQ(order, "abcaba");
}

TEST(JobQueue, AClientThatFillsTheQueueMakesRoomForOthers) {
    std::atomic<bool> end = false;
    std::string order;
    JobQueue queue(1, 4);
    const auto first = queue.submit(endless(end), "busy");
    wait_for_state(*first, Job::State::running);
    std::vector<std::shared_ptr<Job>> busy;
    for (int i = 0; i < 4; ++i) busy.push_back(queue.submit(noted(order, 'a'), "busy"));
    EXPECT_EQ(queue.submit(noted(order, 'a'), "busy"), nullptr) << "no room for itself";
    EXPECT_EQ(queue.refused(), 1U);
    std::vector<std::shared_ptr<Job>> others;
    for (int i = 0; i < 2; ++i) others.push_back(queue.submit(noted(order, 'b'), "other"));
    ASSERT_TRUE(others[0] && others[1]);
    EXPECT_EQ(queue.submit(noted(order, 'b'), "other"), nullptr) << "as many as the other has";
    EXPECT_EQ(queue.waiting(), 4U);
    EXPECT_EQ(queue.refused(), 4U);
    // The last of them are refused.
    for (const std::size_t i : {2U, 3U}) {
        wait_for(*busy[i]);
        EXPECT_THROW(busy[i]->result(), Problem);
    }
    const auto third = queue.submit(noted(order, 'c'), "third");
    EXPECT_TRUE(third);
    end = true;
    for (const auto& job : {busy[0], others[0], third, others[1]}) wait_for(*job);
    EXPECT_EQ(order, "abcb");
    EXPECT_EQ(queue.refused(), 5U);
}

TEST(JobQueue, HasAWorkerFreeAsSoonAsTheAnswerIsThere) {
    JobQueue queue(1, 0);
    for (int i = 0; i < 2000; ++i) {
        const auto job = queue.submit(quick("done"));
        ASSERT_TRUE(job) << i;
        wait_for(*job);
    }
}

TEST(JobQueue, EndsWithWorkersAtWork) {
    std::atomic<bool> never = false;
    std::shared_ptr<Job> running;
    {
        JobQueue queue(1, 1);
        running = queue.submit(endless(never));
        wait_for_state(*running, Job::State::running);
        queue.submit(quick("waits"));
    }
    EXPECT_EQ(running->result().body.bytes(), "stopped");
}

}  // namespace
}  // namespace waybreaker::http
