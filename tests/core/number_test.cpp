// The reader of decimal numbers for other standard libraries reads what this one's does.
#include "core/number.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace waybreaker {
namespace {

void expect_read_alike(const std::string& word) {
    const std::optional<double> expected = number<double>(word);
    // Between zero and the least normal number, either may give up.
    if (expected && *expected != 0 && std::abs(*expected) < std::numeric_limits<double>::min()) return;
    RC_ASSERT(decimal_number(word) == expected);
}

RC_GTEST_PROP(Number, WordsAreReadAlike, ()) {
    expect_read_alike(*rc::gen::container<std::string>(
        rc::gen::weightedOneOf<char>({{6, rc::gen::inRange('0', char('9' + 1))},
                                      {2, rc::gen::element('.', 'e', '-')},
                                      {1, rc::gen::element('+', 'E', ' ', 'x', ',')}})));
}
RC_GTEST_PROP(Number, EveryDoubleIsReadAlike, ()) {
    std::array<char, 32> text{};
    const double value = *rc::gen::arbitrary<double>();
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    expect_read_alike({text.data(), end});
}

TEST(Number, IsReadFromEndToEnd) {
    for (const auto read : {number<double>, decimal_number}) {
        EXPECT_EQ(read("-12.5e1"), -125);
        EXPECT_EQ(read(".5"), 0.5);
        EXPECT_EQ(read("7."), 7);
        for (const char* word : {"", "+1", " 1", "1 ", "1e", "-", ".", "0x10", "1,5", "1.2.3", "1e400", "1e-400"}) {
            EXPECT_FALSE(read(word)) << word;
        }
    }
    EXPECT_EQ(number<int>("12"), 12);
    EXPECT_FALSE(number<int>("12.5"));
}

}  // namespace
}  // namespace waybreaker
