// Bodies: how they are compressed, and what is said of those that are too large.
#include <gtest/gtest.h>

#include <string>

#include "http/gzip.hpp"
#include "http/problem.hpp"

namespace waybreaker::http {
namespace {

TEST(Gzip, IsSentToClientsThatAcceptIt) {
    for (const char* taken : {"gzip", "deflate, GZIP;q=0.5", "*", "br;q=1.0, *;q=0.1", "x-gzip", " gzip ; q=1"}) {
        EXPECT_TRUE(accepts_gzip(taken)) << taken;
    }
    for (const char* refused : {"", "br", "gzip;q=0", "gzip; q=0.000, *", "identity", "*;q=0", "gzippy"}) {
        EXPECT_FALSE(accepts_gzip(refused)) << refused;
    }
}

TEST(BodyTooLarge, IsMeasuredAsPeopleMeasureFiles) {
    const Problem problem = body_too_large(std::size_t{32} << 20);
    EXPECT_EQ(problem.status(), too_large);
    EXPECT_EQ(std::string(problem.what()),
              "the body has more than 32 MB, the most that this server takes (--max-upload)");
}

}  // namespace
}  // namespace waybreaker::http
