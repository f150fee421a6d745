// Filters by tags, and patterns in them against every way to read them.
#include "site/tag_filter.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string_view>

#include "random_map.hpp"

namespace waybreaker::site {
namespace {

bool fits_by_trying(std::string_view text, std::string_view pattern) {
    if (pattern.empty()) return text.empty();
    if (pattern.front() != '*')
        return !text.empty() && text.front() == pattern.front() && fits_by_trying(text.substr(1), pattern.substr(1));
    for (std::size_t taken = 0; taken <= text.size(); ++taken) {
        if (fits_by_trying(text.substr(taken), pattern.substr(1))) return true;
    }
    return false;
}

RC_GTEST_PROP(TagFilter, HasAStarForAnyText, ()) {
    const auto some = [](std::string_view letters) {
        std::string text;
        for (int i = *number(0, 7); i > 0; --i) text += letters[std::size_t(*number(0, int(letters.size()) - 1))];
        return text;
    };
    const std::string text = some("ab");
    const std::string pattern = some("ab*");
    RC_PRE(!pattern.empty());
    RC_ASSERT((TagFilter{"name", {pattern}}.accepts(text)) == fits_by_trying(text, pattern));
}

TEST(TagFilter, TakesAnyOfItsValuesAndNoForNothing) {
    const TagFilter school{"amenity", {"school", "kinder*"}};
    EXPECT_TRUE(school.accepts("school"));
    EXPECT_TRUE(school.accepts("kindergarten"));
    EXPECT_FALSE(school.accepts("schools"));
    EXPECT_TRUE(TagFilter{"historic"}.accepts("ruins"));
    EXPECT_FALSE(TagFilter{"historic"}.accepts("no"));
    EXPECT_FALSE((TagFilter{"historic", {"*"}}.accepts("no")));
}

}  // namespace
}  // namespace waybreaker::site
