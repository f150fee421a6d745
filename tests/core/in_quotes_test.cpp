// Words from outside as errors quote them.
#include "core/in_quotes.hpp"

#include <gtest/gtest.h>

namespace waybreaker {
namespace {

TEST(InQuotes, ShowsLettersOfAllLanguages) {
    EXPECT_EQ(in_quotes("Zelen\u00E1 ulice"), "'Zelen\u00E1 ulice'");
    EXPECT_EQ(in_quotes(""), "''");
}

TEST(InQuotes, HidesWhatIsNoText) {
    EXPECT_EQ(in_quotes("a\nb\x7F\u202E"),
              "'a?b?"
              "?'");
    EXPECT_EQ(in_quotes("Stra\xDF"
                        "e"),
              "'Stra?e'");
}

TEST(InQuotes, CutsAfter32BytesButNoCharacter) {
    EXPECT_EQ(in_quotes(std::string(32, 'a')), "'" + std::string(32, 'a') + "'");
    EXPECT_EQ(in_quotes(std::string(33, 'a')), "'" + std::string(32, 'a') + "...'");
    EXPECT_EQ(in_quotes(std::string(31, 'a') + "\u00E1b"), "'" + std::string(31, 'a') + "\u00E1...'");
}

}  // namespace
}  // namespace waybreaker
