// Files are read whole, and written whole or not at all; digests are those of sha256sum.
#include "io/output_file.hpp"

#include <sys/resource.h>
#include <sys/stat.h>

#include <array>
#include <csignal>
#include <cstdio>

#include "input_error.hpp"
#include "io/excerpt.hpp"
#include "mapfile/digest.hpp"
#include "temporary_folder.hpp"

namespace waybreaker::io {
namespace {

namespace fs = std::filesystem;
using namespace std::string_literals;

class Files : public TemporaryFolder {};

// No file of this process may grow over `bytes`: what a full disk looks like.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) {
        std::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }

  private:
    rlimit before_{};
};

TEST_F(Files, AreReadAsTheyWereWritten) {
    for (const std::string& bytes : {""s, "a"s, "\0\n\xff"s, std::string(1 << 17, 'x')}) {
        write_whole(path("file"), bytes);
        EXPECT_EQ(bytes_of("file"), bytes);
        EXPECT_EQ(read_whole(path("file")), bytes);
        EXPECT_EQ(file_count(), 1);
    }
}

TEST_F(Files, AreRefusedAfterTheirFirstBytes) {
    const HeadCheck refuse = [](std::string_view head) {
        throw InputError("begins with " + std::to_string(head.size()) + " bytes");
    };
    put("short", "abc");
    EXPECT_EQ(input_error([&] { read_whole(path("short"), 100, refuse); }), "begins with 3 bytes");
    put("long", std::string(1 << 17, 'x'));
    EXPECT_EQ(input_error([&] { read_whole(path("long"), 1 << 20, refuse); }), "begins with 65536 bytes");
    // Without end, and larger than any memory: neither is read on, nor is room made for it.
    EXPECT_EQ(input_error([&] { read_whole("/dev/zero", std::size_t{1} << 60, refuse); }), "begins with 65536 bytes");
    fs::resize_file(path("long"), std::uintmax_t{1} << 40);
    EXPECT_EQ(input_error([&] { read_whole(path("long"), std::size_t{1} << 60, refuse); }), "begins with 65536 bytes");
}

TEST_F(Files, EndAtALimit) {
    const std::string bytes(100'000, 'x');
    put("file", bytes);
    EXPECT_EQ(read_whole(path("file"), bytes.size()), bytes);
    for (const std::size_t limit : {std::size_t{0}, std::size_t{5}, bytes.size() - 1}) {
        const std::string text = "cannot read " + path("file") + ": it has over " + std::to_string(limit) + " bytes";
        EXPECT_EQ(input_error([&] { read_whole(path("file"), limit); }), text);
    }
    EXPECT_EQ(input_error([] { read_whole("/dev/zero", 300'000); }), "cannot read /dev/zero: it has over 300000 bytes");
}

TEST_F(Files, OverTheLimitAreRefusedBeforeTheyAreRead) {
    const std::size_t head = 65536;
    put("file", std::string(head, 'x'));
    fs::resize_file(path("file"), 3 * head);
    // Were it read on, it would not be over the limit any more.
    const auto shorten = [&](std::string_view) { fs::resize_file(path("file"), head); };
    EXPECT_EQ(input_error([&] { read_whole(path("file"), 2 * head, shorten); }),
              "cannot read " + path("file") + ": it has over 131072 bytes");
}

TEST_F(Files, OfLongNamesAreNamedByTheirBeginning) {
    const std::string message = input_error([] { read_whole(std::string(5000, 'n')); });
    EXPECT_EQ(message, "cannot read " + std::string(200, 'n') + "...: File name too long");
    EXPECT_EQ(excerpt("\u00E4\u00E4\u00E4", 3), "\u00E4...") << "no half of a character";
    EXPECT_EQ(excerpt("abc", 3), "abc");
}

TEST_F(Files, KeepTheirOldContentWhenWritingFails) {
    put("file", "old");
    std::string message;
    {
        const FileSizeLimit limit(4096);
        message = input_error([&] { write_whole(path("file"), std::string(8192, 'x')); });
    }
    EXPECT_EQ(message, "cannot write " + path("file") + ": File too large");
    EXPECT_EQ(bytes_of("file"), "old");
    EXPECT_EQ(file_count(), 1) << "the temporary file is still there";
}

TEST_F(Files, AreNotWrittenOverAFolderOrIntoOneThatIsNotThere) {
    EXPECT_EQ(input_error([&] { write_whole(path("."), "x"); }),
              "cannot write " + path(".") + ": it is a folder; give a file name");
    EXPECT_EQ(input_error([&] { write_whole(path("no/file"), "x"); }),
              "cannot write " + path("no/file") + ": No such file or directory");
    EXPECT_EQ(input_error([&] { write_whole("", "x"); }), "cannot write : No such file or directory");
    EXPECT_EQ(file_count(), 0);
}

TEST_F(Files, ThatALinkPointsToAreReplacedNotTheLink) {
    put("file", "old");
    fs::create_symlink("file", path("link"));
    write_whole(path("link"), "new");
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(bytes_of("file"), "new");
}

TEST_F(Files, ThatAreDevicesStayDevices) {
    fs::create_symlink("/dev/null", path("null"));
    write_whole(path("null"), "x");
    EXPECT_TRUE(fs::is_character_file(path("null")));
    EXPECT_EQ(input_error([] { write_whole("/dev/full", "x"); }), "cannot write /dev/full: No space left on device");
}

TEST_F(Files, OverTheLimitAreRefused) {
    put("file", "12345");
    EXPECT_EQ(read_whole(path("file"), 5), "12345");
    EXPECT_EQ(input_error([&] { read_whole(path("file"), 4); }),
              "cannot read " + path("file") + ": it has over 4 bytes");
    EXPECT_EQ(input_error([&] { read_whole("/dev/zero", 1 << 20); }),
              "cannot read /dev/zero: it has over 1048576 bytes");
}

TEST_F(Files, ThatCannotBeReadAreNamedWithTheCause) {
    EXPECT_EQ(input_error([&] { read_whole(path("none")); }),
              "cannot read " + path("none") + ": No such file or directory");
    EXPECT_EQ(input_error([&] { read_whole(path(".")); }),
              "cannot read " + path(".") + ": it is a folder; give a file");
}

TEST_F(Files, HaveTheDigestThatSha256sumPrints) {
    for (const std::string& bytes : {""s, "a"s, "\0\n\xff"s, std::string(100000, 'x')}) {
        const std::string command = "sha256sum " + put("file", bytes);
        std::FILE* const pipe = ::popen(command.c_str(), "r");
        ASSERT_NE(pipe, nullptr);
        std::array<char, 64> hex{};
        const std::size_t got = std::fread(hex.data(), 1, hex.size(), pipe);
        ::pclose(pipe);
        ASSERT_EQ(got, hex.size()) << "sha256sum did not run";
        EXPECT_EQ(mapfile::sha256_digest(bytes), "sha256:" + std::string(hex.data(), hex.size()));
    }
}

}  // namespace
}  // namespace waybreaker::io
