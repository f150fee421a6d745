#include "http/guard.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace waybreaker::http {
namespace {

TEST(Guard, KnowsThisMachine) {
    for (const char* host :
         {"localhost", "localhost:80", "LOCALHOST", "LocalHost:80", "127.0.0.1:8080", "[::1]", "[::1]:80"}) {
        EXPECT_TRUE(names_loopback(host)) << host;
    }
    for (const char* host : {"", "evil.example", "localhost.evil.example:80", "127.0.0.1.evil.example", "[::2]", "["}) {
        EXPECT_FALSE(names_loopback(host)) << host;
    }
    EXPECT_TRUE(same_site("http://localhost:80", "localhost:80"));
    for (const char* origin : {"null", "http://localhost:81", "http://evil.example", ""}) {
        EXPECT_FALSE(same_site(origin, "localhost:80")) << origin;
    }
}

TEST(Guard, KnowsNamesAndAddresses) {
    const std::vector<std::string> names{"robots.example", "base"};
    for (const char* host : {"robots.example", "Robots.Example:8080", "base:80"})
        EXPECT_TRUE(names_one_of(host, names));
    for (const char* host : {"", "robots.example.evil", "evil.robots.example", "robots", "base.", "[base]"}) {
        EXPECT_FALSE(names_one_of(host, names)) << host;
    }
    for (const char* host : {"192.0.2.7", "192.0.2.7:80", "[2001:db8::7]", "[2001:db8::7]:80"}) {
        EXPECT_TRUE(is_address(host)) << host;
    }
    for (const char* host : {"", "192.0.2.7.evil.example", "evil.example", "192.0.2", "[evil]", "["}) {
        EXPECT_FALSE(is_address(host)) << host;
    }
}

TEST(Guard, TokenMustBeTheWholeToken) {
    for (const char* right : {"Bearer secret", "bearer secret", "BEARER  secret"}) {
        EXPECT_TRUE(brings_token(right, "secret")) << right;
    }
    for (const char* wrong : {"", "secret", "Bearer ", "Bearer secre", "Bearer secrets", "Bearer secretsecret",
                              "Bearersecret", "Basic secret"}) {
        EXPECT_FALSE(brings_token(wrong, "secret")) << wrong;
    }
    EXPECT_FALSE(brings_token("Bearer ", ""));
}

}  // namespace
}  // namespace waybreaker::http
