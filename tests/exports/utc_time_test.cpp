#include "exports/utc_time.hpp"

#include <gtest/gtest.h>

#include "input_error.hpp"

namespace waybreaker::exports {
namespace {

TEST(UtcTimes, AreRead) {
    EXPECT_EQ(parse_utc("1970-01-01T00:00:00Z"), 0);
    EXPECT_EQ(parse_utc("1969-12-31T23:59:59Z"), -1);
    EXPECT_EQ(parse_utc("2000-02-29T12:00:00Z"), 951825600);
    EXPECT_EQ(parse_utc("2026-05-01T08:00:00Z"), 1777622400);
    for (const char* const none :
         {"", "now", "2026-05-01", "2026-05-01T08:00Z", "2026-05-01T08:00:00", "2026-05-01T08:00:00+02:00",
          "2026-05-01T08:00:00Z ", " 2026-05-01T08:00:00Z", "2026-02-29T08:00:00Z", "2026-13-01T08:00:00Z",
          "2026-05-01T24:00:00Z", "2026-05-01T08:60:00Z", "2026-05-01T08:00:60Z", "26-05-01T08:00:00Z",
          "2026-5-01T08:00:00Z", "-026-05-01T08:00:00Z"}) {
        EXPECT_EQ(parse_utc(none), std::nullopt) << none;
    }
}

TEST(UtcTimes, AreWrittenToAMillisecond) {
    EXPECT_EQ(utc_text(0, 0), "1970-01-01T00:00:00.000Z");
    EXPECT_EQ(utc_text(0, 0.0004), "1970-01-01T00:00:00.000Z");
    EXPECT_EQ(utc_text(0, 59.9996), "1970-01-01T00:01:00.000Z");
    EXPECT_EQ(utc_text(-1, 0.25), "1969-12-31T23:59:59.250Z");
    EXPECT_EQ(utc_text(1777622400, 86400.5), "2026-05-02T08:00:00.500Z");
    EXPECT_NE(input_error([] { utc_text(0, 1e12); }).find("after the year 9999"), std::string::npos);
}

}  // namespace
}  // namespace waybreaker::exports
