// The memory budget, and what counts in it.
#include <gtest/gtest.h>

#include <memory>
#include <thread>
#include <vector>

#include "server/memory_account.hpp"
#include "server/memory_budget.hpp"

namespace waybreaker::server {
namespace {

using Use = MemoryBudget::Use;

constexpr std::size_t megabyte = std::size_t{1} << 20;

TEST(MemoryBudget, SharesAreWithinIt) {
    MemoryBudget budget(100);
    MemoryBudget::Share maps(budget, Use::maps);
    MemoryBudget::Share plans(budget, Use::planners);
    EXPECT_TRUE(maps.grow(60));
    EXPECT_FALSE(plans.grow(41));
    EXPECT_TRUE(plans.grow(40));
    EXPECT_EQ(budget.used(), 100U);
    maps.shrink_to(10);
    EXPECT_EQ(budget.used(Use::maps), 10U);
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
    for (const Use use : {Use::answers, Use::sources}) {
        MemoryBudget::Share share(budget, use);
        EXPECT_TRUE(share.grow(25));
        EXPECT_FALSE(share.grow(1));
    }
}

TEST(MemoryBudget, WhatNobodyUsesMakesRoom) {
    MemoryBudget budget(100);
    std::vector<MemoryBudget::Share> kept;
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(kept.emplace_back(budget, Use::maps).grow(25));
    budget.when_short([&kept] {
        if (kept.empty()) return false;
        kept.pop_back();
        return true;
    });
    MemoryBudget::Share share(budget, Use::planners);
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
        MemoryAccount account(budget, Use::planners);
        std::thread other;
        {
            const MemoryAccount::Scope scope(&account);
            kept.resize(5 * megabyte);
            const std::vector<char> gone(20 * megabyte);
            EXPECT_GE(account.bytes(), 25 * megabyte);
            EXPECT_GE(budget.used(Use::planners), account.bytes());
            const MemoryAccount::Scope none(nullptr);
            const std::vector<char> not_counted(50 * megabyte);
            other = std::thread([] { const std::vector<char> not_counted(50 * megabyte); });
        }
        other.join();
        EXPECT_GE(account.bytes(), 5 * megabyte);
        EXPECT_LT(budget.used(Use::planners), 10 * megabyte);
        EXPECT_EQ(account.needed(), 0U);
    }
    EXPECT_EQ(budget.used(), 0U);
}

TEST(MemoryAccount, AllocatesNoMoreThanThereIs) {
    MemoryBudget budget(10 * megabyte);
    MemoryAccount account(budget, Use::planners);
    const MemoryAccount::Scope scope(&account);
    std::vector<char> first(6 * megabyte);
    EXPECT_THROW(std::vector<char>(5 * megabyte), std::bad_alloc);
    EXPECT_GE(account.needed(), 11 * megabyte);
    EXPECT_NO_THROW(std::vector<char>(3 * megabyte));
    first = {};
    EXPECT_NO_THROW(std::vector<char>(8 * megabyte));
}

}  // namespace
}  // namespace waybreaker::server
