// Images: one picture in every format comes out the same, and what is none is refused in one line.
#include "mapfile/grey_image.hpp"

#include <gtest/gtest.h>
#include <png.h>
#include <rapidcheck/gtest.h>

#include "ascii_map.hpp"
#include "input_error.hpp"
#include "mapfile/sums.hpp"

namespace waybreaker::mapfile {
namespace {

using Bytes = std::vector<std::uint8_t>;

// A PNG with samples of that libpng format.
std::string png_of(int width, int height, png_uint_32 format, const std::vector<std::uint8_t>& samples) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = png_uint_32(width);
    image.height = png_uint_32(height);
    image.format = format;
    std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
    png_alloc_size_t size = bytes.size();
    EXPECT_NE(png_image_write_to_memory(&image, bytes.data(), &size, 0, samples.data(), 0, nullptr), 0);
    bytes.resize(size);
    return bytes;
}

TEST(Images, OfAllNetpbmFormatsAreRead) {
    const std::vector<int> black_white{0, 765, 0, 765, 765, 0};
    const std::vector<std::pair<std::string, std::vector<int>>> cases{
        {"P1\n# by hand\n3 2\n1 0 1\n001\n", black_white},
        {"P4 3 2\n\xA0\x20", black_white},
        {"P2\n3 2 # size\n255\n0 255 0 255 255 0", black_white},
        {std::string("P5 3 2 255\n\0\xFF\0\xFF\xFF\0", 17), black_white},
        {"P5\n# CREATOR: map_saver.cpp 0.050 m/pix\n3 1\n255\n\xCD\xFE\x64", {615, 762, 300}},
        {"P3 2 1 255  10 20 30  255 255 255", {60, 765}},
        {std::string("P6 2 1 255\n\x0A\x14\x1E\xFF\xFF\xFF", 17), {60, 765}},
        {std::string("P5 2 1 65535\n\x80\x00\xFF\xFF", 17), {3 * 128, 765}},
        {"P2 2 1 15 3 15", {3 * 51, 765}},
    };
    for (const auto& [bytes, expected] : cases) EXPECT_EQ(sums(read_image(bytes, "image")), expected) << bytes;
}

TEST(Images, OfManyKindsOfPngAreRead) {
    EXPECT_EQ(sums(read_image(png_of(3, 1, PNG_FORMAT_GRAY, {0, 205, 255}), "image")), (std::vector{0, 615, 765}));
    const GreyImage colour = read_image(png_of(2, 1, PNG_FORMAT_RGBA, {10, 20, 30, 255, 90, 80, 70, 128}), "image");
    EXPECT_EQ(sums(colour), (std::vector{60, 240}));
    EXPECT_TRUE(colour.transparency);
    EXPECT_EQ(colour.pixels[1].alpha, 128);
    EXPECT_FALSE(read_image(png_of(1, 1, PNG_FORMAT_RGB, {1, 2, 4}), "image").transparency);
}

RC_GTEST_PROP(Images, ComeBackFromTheirFormats, ()) {
    const int width = *rc::gen::inRange(1, 40);
    const int height = *rc::gen::inRange(1, 40);
    const auto grey = *rc::gen::container<Bytes>(std::size_t(width * height), rc::gen::arbitrary<std::uint8_t>());
    for (const std::string& bytes : {png_bytes(width, height, grey), pgm_bytes(width, height, grey)}) {
        const GreyImage image = read_image(bytes, "image");
        RC_ASSERT(image.width == width && image.height == height && !image.transparency);
        for (std::size_t i = 0; i < grey.size(); ++i) RC_ASSERT(image.pixels[i].sum == 3 * grey[i]);
    }
}

TEST(Images, BlockWhereTheyAreDark) {
    const GreyImage image =
        read_image(png_of(5, 1, PNG_FORMAT_GA, {0, 255, 127, 255, 128, 255, 255, 255, 0, 100}), "i");
    EXPECT_EQ(grid_of(image, 0.5), map_from_ascii("##...").grid());  // the last is black, but hardly there
    EXPECT_EQ(grid_of(image, 0.39), map_from_ascii("###.#").grid());
    EXPECT_EQ(grid_of(image, 1), map_from_ascii("#....").grid());
}

TEST(Images, ThatAreNoneAreRefused) {
    const std::string png = png_bytes(9, 9, Bytes(81, 100));
    std::string huge = png;
    huge.replace(16, 8, std::string("\0\0\x40\0\0\0\x40\0", 8));  // its header's check sum is wrong as well
    const std::vector<std::pair<std::string, std::string>> cases{
        {"", "is no image"},
        {"hello", "is no image"},
        {"P7\n1 1", "is no image"},
        {"P5", "is no image"},
        {"P5\n", "image:2: the width must be a number"},
        {"P5\n3", "image:2: the height must be a number"},
        {"P5\n-3 4 255\n", "the width must be"},
        {"P5\n99999999999 4 255\n", "the width must be"},
        {"P5\n32768 32768 255\n", "too large"},
        {"P5\n3 2 0\n", "the largest sample must be"},
        {"P5\n3 2 255\nabcde", "is the file cut off?"},
        {"P6\n3 2 255\nabcdefabcdefabcde", "is the file cut off?"},
        {"P4\n9 2\nabc", "is the file cut off?"},
        {"P2\n3 2\n255\n1 2 3\n4 5 x", "image:5: a sample must be"},
        {"P2\n3 2\n9\n1 2 3 4 5 10", "a sample must be a number from 0 to 9"},
        {"P1\n2 2\n1 0\n12", "image:4: a pixel is neither 0 nor 1"},
        {png.substr(0, 20), "cannot be read as PNG"},
        {png.substr(0, png.size() - 20), "cannot be read as PNG"},
        {huge, "image: "},
    };
    for (const auto& [bytes, message] : cases) {
        const std::string error = input_error([&] { read_image(bytes, "image"); });
        EXPECT_NE(error.find(message), std::string::npos) << error;
        EXPECT_EQ(error.find("image"), 0U) << error;
    }
}

}  // namespace
}  // namespace waybreaker::mapfile
