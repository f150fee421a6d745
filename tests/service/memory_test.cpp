// The memory budget, and what counts in it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

#include "live_server.hpp"
#include "service/memory_account.hpp"
#include "service/memory_budget.hpp"
#include "wire.hpp"

namespace waybreaker::service {
namespace {

using Use = MemoryBudget::Use;

constexpr std::size_t megabyte = std::size_t{1} << 20;

TEST(MemoryBudget, SharesAreWithinIt) {
    MemoryBudget budget(100);
    MemoryBudget::Share maps(budget, Use::map);
    MemoryBudget::Share plans(budget, Use::planner);
    EXPECT_TRUE(maps.grow(60));
    EXPECT_FALSE(plans.grow(41));
    EXPECT_TRUE(plans.grow(40));
    EXPECT_EQ(budget.used(), 100U);
    maps.shrink_to(10);
    EXPECT_EQ(budget.used(Use::map), 10U);
    EXPECT_FALSE(plans.grow(SIZE_MAX));
    {
        const MemoryBudget::Share moved = std::move(plans);
        EXPECT_EQ(moved.bytes(), 40U);
        EXPECT_EQ(plans.bytes(), 0U);
        EXPECT_EQ(budget.used(), 50U);
    }
    EXPECT_EQ(budget.used(), 10U);
}

TEST(MemoryBudget, AnswersAndSourcesCannotTakeAll) {
    MemoryBudget budget(100);
    for (const Use use : {Use::answer, Use::source}) {
        MemoryBudget::Share share(budget, use);
        EXPECT_TRUE(share.grow(25));
        EXPECT_FALSE(share.grow(1));
    }
}

TEST(MemoryBudget, WhatNobodyUsesMakesRoom) {
    MemoryBudget budget(100);
    std::vector<MemoryBudget::Share> kept;
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(kept.emplace_back(budget, Use::map).grow(25));
    budget.when_short([&kept] {
        if (kept.empty()) return false;
        kept.pop_back();
        return true;
    });
    MemoryBudget::Share share(budget, Use::planner);
    EXPECT_FALSE(share.grow(101));
    EXPECT_EQ(kept.size(), 4U);  // nothing goes for what cannot fit
    EXPECT_TRUE(share.grow(30));
    EXPECT_EQ(kept.size(), 2U);
    EXPECT_FALSE(share.grow(71));
    EXPECT_EQ(share.bytes(), 30U);
}

TEST(MemoryAccount, CountsWhatItsThreadAllocates) {
    MemoryBudget budget(100 * megabyte);
    std::vector<char> kept;
    {
        MemoryAccount account(budget, Use::planner);
        std::thread other;
        {
            const MemoryAccount::Scope scope(&account);
            kept.resize(5 * megabyte);
            const std::vector<char> gone(20 * megabyte);
            EXPECT_GE(account.bytes(), 25 * megabyte);
            EXPECT_GE(budget.used(Use::planner), account.bytes());
            const MemoryAccount::Scope none(nullptr);
            const std::vector<char> not_counted(50 * megabyte);
            other = std::thread([] { const std::vector<char> neither(50 * megabyte); });
        }
        other.join();
        EXPECT_GE(account.bytes(), 5 * megabyte);
        EXPECT_LT(budget.used(Use::planner), 10 * megabyte);
        EXPECT_EQ(account.needed(), 0U);
    }
    EXPECT_EQ(budget.used(), 0U);
}

TEST(MemoryAccount, AllocatesNoMoreThanThereIs) {
    MemoryBudget budget(10 * megabyte);
    MemoryAccount account(budget, Use::planner);
    const MemoryAccount::Scope scope(&account);
    std::vector<char> first(6 * megabyte);
    EXPECT_THROW(std::vector<char>(5 * megabyte), std::bad_alloc);
    EXPECT_GE(account.needed(), 11 * megabyte);
    EXPECT_NO_THROW(std::vector<char>(3 * megabyte));
    first = std::vector<char>();
    EXPECT_NO_THROW(std::vector<char>(8 * megabyte));
}

TEST(MemoryAccount, CountsWhatSearchesTakePastOperatorNew) {
    MemoryBudget budget(10 * megabyte);
    MemoryAccount account(budget, Use::planner);
    const MemoryAccount::Scope scope(&account);
    // Volatile, or the compiler does without.
    void* volatile zeroes = std::calloc(3, megabyte);  // NOLINT(cppcoreguidelines-no-malloc)
    EXPECT_GE(account.bytes(), 3 * megabyte);
    EXPECT_EQ(std::calloc(8, megabyte), nullptr);  // NOLINT(cppcoreguidelines-no-malloc)
    std::free(zeroes);                             // NOLINT(cppcoreguidelines-no-malloc)
    EXPECT_LT(account.bytes(), 1000U);
}

class MemoryTest : public LiveServer {
  protected:
    // By waybreaker_memory_bytes.
    std::size_t used(const std::string& use) const {
        const std::string text = get("/metrics").body;
        const std::string name = "waybreaker_memory_bytes{use=\"" + use + "\"} ";
        const std::size_t at = text.find(name);
        EXPECT_NE(at, std::string::npos) << use;
        return std::stoull(text.substr(at + name.size()));
    }
};

TEST_F(MemoryTest, PlansAreRefusedThatNeedMoreThanThereIs) {
    options_.limits.memory = 6 * megabyte;
    begin();
    const Json map = Json::parse(post(maps, thicket(500), octets).body);
    const std::string plan = maps + "/" + map["id"].get<std::string>() + "/plan";
    const Json mission{{"mission", {{"start", {0, 0}}, {"goal", {499, 499}}}}, {"options", {{"removals", 3}}}};
    EXPECT_EQ(post_json(plan, mission, 413)["type"], "/problems/map-too-large");
    EXPECT_EQ(used("planners"), 0U);
    EXPECT_EQ(post_json(maps + "/house.map/plan", house_mission)["status"], "solved");
    EXPECT_NE(get("/metrics").body.find("waybreaker_memory_limit_bytes 6291456\n"), std::string::npos);
}

TEST_F(MemoryTest, IsGivenBack) {
    begin();
    const Json map = Json::parse(post(maps, thicket(300), octets).body);
    const std::string path = maps + "/" + map["id"].get<std::string>();
    const Json mission{{"mission", {{"start", {0, 0}}, {"goal", {299, 299}}}}, {"options", {{"time_limit", 0.1}}}};
    post_json(path + "/plan", mission);
    EXPECT_GT(used("planners"), 0U);
    EXPECT_GT(used("maps"), 300U * 300);
    EXPECT_EQ(remove(path).status, 204);
    while (used("planners") + used("maps") > 0) std::this_thread::yield();
    for (const char* use : {"sources", "jobs", "imports", "requests", "answers"}) EXPECT_EQ(used(use), 0U) << use;
}

// Two clients that ask for the same do not read it: there is memory for one of them.
TEST_F(MemoryTest, AnswersThatWaitForTheirClientsCount) {
    begin();
    const std::string obstacles =
        maps + "/" + Json::parse(post(maps, thicket(1200), octets).body)["id"].get<std::string>() + "/obstacles";
    const std::size_t size = get(obstacles).body.size();
    end();
    options_.limits.memory = 7 * size;
    begin();
    post(maps, thicket(1200), octets);
    const std::string request = "GET " + obstacles + " HTTP/1.1\r\nHost: localhost\r\n\r\n";
    const Wire first(port());
    first.send(request);
    while (used("answers") == 0) std::this_thread::yield();
    EXPECT_EQ(Json::parse(get(obstacles).body)["type"], "/problems/no-memory");
}

}  // namespace
}  // namespace waybreaker::service
