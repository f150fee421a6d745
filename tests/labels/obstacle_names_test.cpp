#include "labels/obstacle_names.hpp"

#include <gtest/gtest.h>

#include <string>

namespace waybreaker::labels {
namespace {

TEST(CleanName, is_one_line_of_whole_characters) {
    EXPECT_EQ(clean_name(" a\r\nb\x1b[31m\x7f"), "a  b [31m");
    EXPECT_EQ(clean_name("Stra\xdf"
                         "e"),
              "Stra?e");
    EXPECT_EQ(clean_name("Caf\u202e\u00e9\u2066 \u05d0\u2028\u0085"), "Café א")
        << "what turns the direction of writing";
    EXPECT_EQ(clean_name("\u05d0\u200f 5, ‘é’ \u2027\u202f\u2065"), "\u05d0\u200f 5, ‘é’ \u2027\u202f\u2065");
    const auto long_name = [](std::size_t letters) { return std::string(letters, 'x').append("ß"); };
    EXPECT_EQ(clean_name(long_name(249)), std::string(249, 'x'));
    EXPECT_EQ(clean_name(long_name(248)), long_name(248));
}

}  // namespace
}  // namespace waybreaker::labels
