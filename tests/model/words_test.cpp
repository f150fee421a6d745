#include "waybreaker/words.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

#include "waybreaker/advanced/search.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/method.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker {
namespace {

// Every value from 0 to `last` has a word of its own, that names it alone.
template <class Enum>
void expect_words(Enum last) {
    EXPECT_EQ(words_of<Enum>.size(), std::size_t(last) + 1);
    std::set<std::string_view> seen;
    for (int i = 0; i <= int(last); ++i) {
        const std::string_view word = to_string(Enum(i));
        EXPECT_FALSE(word.empty());
        EXPECT_TRUE(seen.insert(word).second) << word;
        EXPECT_EQ(from_string<Enum>(word), Enum(i)) << word;
    }
    EXPECT_EQ(to_string(Enum(int(last) + 1)), "");
    EXPECT_EQ(to_string(Enum(-1)), "");
    EXPECT_EQ(from_string<Enum>(""), std::nullopt);
    EXPECT_EQ(from_string<Enum>("Makespan"), std::nullopt);
}

TEST(Words, NameEachValueOfEachEnum) {
    expect_words(Corners::squeeze);
    expect_words(Connectivity::eight);
    expect_words(AgentKind::air);
    expect_words(Objective::ground_makespan);
    expect_words(Timing::ignore);
    expect_words(AtGoal::leave);
    expect_words(Selection::none);
    expect_words(FlightRule::nearest);
    expect_words(Algorithm::optimal);
    expect_words(Heuristic::zero);
    expect_words(TieBreak::g_min);
    expect_words(WaitReason::zone);
    expect_words(PlanStatus::stopped);
    expect_words(SearchStatus::stopped);
    expect_words(ErrorCode::option);
}

TEST(Words, AreTheOnesOfDocuments) {
    EXPECT_EQ(to_string(PlanStatus::limit_reached), "limit_reached");
    EXPECT_EQ(to_string(Algorithm::lazy_theta), "lazy-theta");
    EXPECT_EQ(from_string<Objective>("ground-makespan"), Objective::ground_makespan);
    static_assert(to_string(Timing::enforce) == "enforce");
}

}  // namespace
}  // namespace waybreaker
