// PNG files made by hand: what their header says is all that is read of them.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <zlib.h>

#include <array>

#include "input_error.hpp"
#include "mapfile/grey_image.hpp"
#include "mapfile/map_reader.hpp"
#include "mapfile/sums.hpp"

namespace waybreaker::mapfile {
namespace {

std::string big_endian(std::uint32_t value) {
    return {char(value >> 24), char(value >> 16), char(value >> 8), char(value)};
}

std::string deflated(const std::string& bytes) {
    uLongf size = ::compressBound(bytes.size());
    std::string packed(size, '\0');
    ::compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                bytes.size(), Z_BEST_COMPRESSION);
    packed.resize(size);
    return packed;
}

std::string chunk(const std::string& type, const std::string& data) {
    const std::string body = type + data;
    return big_endian(std::uint32_t(data.size())) + body +
           big_endian(std::uint32_t(::crc32(0, reinterpret_cast<const Bytef*>(body.data()), uInt(body.size()))));
}

struct Header {
    int width = 1;
    int height = 1;
    int depth = 8;
    int colour = 0;  // grey
    bool interlaced = false;
};

// `rows` as they are before they are packed, each after a byte for its filter; `others` stands before them.
std::string png(const Header& header, const std::string& rows, const std::string& others = "") {
    const std::string start = big_endian(std::uint32_t(header.width)) + big_endian(std::uint32_t(header.height)) +
                              char(header.depth) + char(header.colour) + '\0' + '\0' + char(header.interlaced ? 1 : 0);
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", start) + others + chunk("IDAT", deflated(rows)) + chunk("IEND", "");
}

// What map savers write for unknown is free in mode scale, and to nav2 Humble where an image says how opaque its pixels
// are; the note says what helps.
TEST(PngImage, WithTransparencyFreesTheUnknownOfRosMaps) {
    constexpr int grey_and_alpha = 4;
    const std::string opaque = png({.width = 1, .height = 1}, std::string("\0\xCD", 2));
    const std::string clear = png({1, 1, 8, grey_and_alpha}, std::string("\0\xCD\xFF", 3));
    const auto note = [](const std::string& members, const std::string& image, io::Nav2 nav2) {
        const std::string yaml = "image: a.png\nresolution: 1\norigin: [0, 0, 0]\n" + members + "...\n";
        const io::MapFile file = parse_map(yaml + image, "m", Connectivity::four, {.nav2 = nav2});
        return file.notes.empty() ? "" : file.notes[0].substr(file.notes[0].find("for free"));
    };
    for (const io::Nav2 nav2 : {io::Nav2::jazzy, io::Nav2::humble}) {
        EXPECT_EQ(note("", opaque, nav2), "");
        EXPECT_EQ(note("free_thresh: 0.25\n", opaque, nav2), "for free; with 0.196 it is unknown");
        EXPECT_EQ(note("mode: scale\n", opaque, nav2), "for free; with mode trinary and 0.196 it is unknown");
    }
    EXPECT_EQ(note("", clear, io::Nav2::jazzy), "");
    EXPECT_EQ(note("mode: scale\n", clear, io::Nav2::jazzy), "for free; with mode trinary and 0.196 it is unknown");
    EXPECT_EQ(note("occupied_thresh: 0.2\nfree_thresh: 0.2\n", clear, io::Nav2::jazzy),
              "for free; with 0.196 it is unknown");
    EXPECT_EQ(note("occupied_thresh: 0.196\nfree_thresh: 0.196\nmode: scale\n", clear, io::Nav2::jazzy), "");
    EXPECT_EQ(note("", clear, io::Nav2::humble), "for free; with no transparency and 0.196 it is unknown");
    EXPECT_EQ(note("mode: scale\n", clear, io::Nav2::humble),
              "for free; with mode trinary and no transparency and 0.196 it is unknown");
    EXPECT_EQ(note("occupied_thresh: 0.15\nfree_thresh: 0.15\n", clear, io::Nav2::humble), "for free");
}

TEST(PngImage, WithMorePixelsThanItsHeaderSaysIsRefused) {
    const std::string enough(10 * 11, '\0');
    EXPECT_EQ(read_png(png({10, 10}, enough), "image").pixels.size(), 100U);
    for (const std::size_t surplus : {std::size_t{1}, std::size_t{11}, std::size_t{64} << 20}) {
        const std::string file = png({10, 10}, enough + std::string(surplus, '\0'));
        EXPECT_EQ(input_error([&] { read_png(file, "image"); }),
                  "image: cannot be read as PNG: it holds other pixels than its header says")
            << surplus;
    }
    const std::string interlaced = png({10, 10, 8, 0, true}, std::string(10000, '\0'));
    EXPECT_NE(input_error([&] { read_png(interlaced, "image"); }), "");
}

TEST(PngImage, IsReadWithoutItsTextsAndProfiles) {
    const std::string bomb = deflated(std::string(7'000'000, ' '));
    std::string texts;
    for (int i = 0; i < 900; ++i) texts += chunk("zTXt", std::string("Comment") + '\0' + '\0' + bomb);
    EXPECT_EQ(sums(read_png(png({2, 1}, std::string("\0\x0A\x14", 3), texts), "image")), (std::vector{30, 60}));
}

TEST(PngImage, OfSixteenBitsIsScaledAsItStands) {
    const std::string rows("\0\0\0\x80\x80\xCD\xCD\xFF\xFF", 9);
    EXPECT_EQ(sums(read_png(png({4, 1, 16}, rows), "image")), (std::vector{0, 3 * 0x80, 3 * 0xCD, 765}));
}

TEST(PngImage, ThatEndsTooEarlyIsRefused) {
    const std::string rows(9 * 10, '\0');
    EXPECT_NE(input_error([&] { read_png(png({9, 9}, rows.substr(0, 80)), "image"); }), "");
    const std::string whole = png({9, 9}, rows);
    for (std::size_t size = 8; size < whole.size(); ++size) {
        EXPECT_NE(input_error([&] { read_png(whole.substr(0, size), "image"); }), "") << size;
    }
}

// The seven passes of Adam7: first row and column of each, and how far apart.
constexpr std::array<std::array<int, 4>, 7> passes{
    {{0, 0, 8, 8}, {0, 4, 8, 8}, {4, 0, 8, 4}, {0, 2, 4, 4}, {2, 0, 4, 2}, {0, 1, 2, 2}, {1, 0, 2, 1}}};

RC_GTEST_PROP(PngImage, IsTheSameInterlaced, ()) {
    const int width = *rc::gen::inRange(1, 20);
    const int height = *rc::gen::inRange(1, 20);
    const auto grey = *rc::gen::container<std::string>(std::size_t(width * height), rc::gen::arbitrary<char>());
    const auto at = [&](int x, int y) { return grey[std::size_t(y * width + x)]; };
    std::string plain;
    for (int y = 0; y < height; ++y) plain += '\0' + grey.substr(std::size_t(y * width), std::size_t(width));
    std::string woven;
    for (const auto& [first_y, first_x, step_y, step_x] : passes) {
        for (int y = first_y; y < height && first_x < width; y += step_y) {
            woven += '\0';
            for (int x = first_x; x < width; x += step_x) woven += at(x, y);
        }
    }
    const auto expected = sums(read_png(png({width, height}, plain), "image"));
    RC_ASSERT(sums(read_png(png({width, height, 8, 0, true}, woven), "image")) == expected);
    for (std::size_t i = 0; i < grey.size(); ++i) RC_ASSERT(expected[i] == 3 * int(std::uint8_t(grey[i])));
}

}  // namespace
}  // namespace waybreaker::mapfile
