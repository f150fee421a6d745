#include "io/sha256.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

#include "mapfile/digest.hpp"

namespace waybreaker::io {
namespace {

// The examples of NIST (FIPS 180-4, "Examples with Intermediate Values") and of its test vectors.
TEST(Sha256, GivesWhatTheStandardSays) {
    EXPECT_EQ(sha256_digest("abc"), "sha256:ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256_digest(""), "sha256:e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256_digest("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "sha256:248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(sha256_digest("abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmn"
                            "hijklmnoijklmnopjklmnopqklmnopqrlmnopqrsmnopqrstnopqrstu"),
              "sha256:cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1");
    EXPECT_EQ(sha256_digest(std::string(1000000, 'a')),
              "sha256:cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, EqualsThatOfMapFilesAtEveryLength) {
    std::string bytes;
    for (int i = 0; i < 300; ++i) {
        ASSERT_EQ(sha256_digest(bytes), mapfile::sha256_digest(bytes)) << bytes.size() << " bytes";
        bytes += char(i * 37 + 201);
    }
}

RC_GTEST_PROP(Sha256, EqualsThatOfMapFiles, (const std::string& bytes)) {
    RC_ASSERT(sha256_digest(bytes) == mapfile::sha256_digest(bytes));
}

}  // namespace
}  // namespace waybreaker::io
