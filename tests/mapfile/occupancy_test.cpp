// What each mode makes of each pixel: the table of nav2's map_io, in both of its versions.
#include "mapfile/occupancy.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace waybreaker::mapfile {
namespace {

using io::Nav2;
using io::RosMode;

constexpr const char* unknown = "unknown";

std::string word(std::optional<int> percent) {
    return percent ? std::to_string(*percent) : unknown;
}

std::string of_grey(int grey, const io::RosYaml& yaml, Nav2 nav2 = Nav2::jazzy) {
    return word(occupancy(GreyImage::Pixel::of_grey(grey), false, yaml, nav2));
}

std::string of_transparent(int grey, int alpha, const io::RosYaml& yaml, Nav2 nav2 = Nav2::jazzy) {
    return word(occupancy(GreyImage::Pixel::of_grey(grey, alpha), true, yaml, nav2));
}

struct Row {
    int grey;
    const char* trinary;
    const char* scale;
    const char* raw;
    const char* negated;  // trinary with negate: 1
};

// Thresholds 0.65 and 0.196: occupied below a grey of 89.25, free above 205.02. No grey is at a threshold, and both
// versions say the same.
TEST(Occupancy, TableOfModes) {
    for (const Row& row : std::vector<Row>{
             {0, "100", "100", "0", "0"},
             {49, "100", "100", "49", "0"},
             {50, "100", "100", "50", unknown},
             {89, "100", "100", "89", unknown},
             {90, unknown, "99", "90", unknown},
             {100, unknown, "91", "100", unknown},
             {101, unknown, "90", unknown, unknown},
             {127, unknown, "67", unknown, unknown},
             {128, unknown, "67", unknown, unknown},
             {147, unknown, "50", unknown, unknown},
             {165, unknown, "35", unknown, unknown},
             {166, unknown, "34", unknown, "100"},
             {205, unknown, "0", unknown, "100"},
             {206, "0", "0", unknown, "100"},
             {254, "0", "0", unknown, "100"},
             {255, "0", "0", unknown, "100"},
         }) {
        for (const Nav2 nav2 : {Nav2::jazzy, Nav2::humble}) {
            SCOPED_TRACE(std::to_string(row.grey) + (nav2 == Nav2::humble ? " humble" : " jazzy"));
            EXPECT_EQ(of_grey(row.grey, {.mode = RosMode::trinary}, nav2), row.trinary);
            EXPECT_EQ(of_grey(row.grey, {.mode = RosMode::scale}, nav2), row.scale);
            EXPECT_EQ(of_grey(row.grey, {.mode = RosMode::raw}, nav2), row.raw);
            EXPECT_EQ(of_grey(row.grey, {.mode = RosMode::raw, .negate = true}, nav2), row.raw);
            EXPECT_EQ(of_grey(row.grey, {.mode = RosMode::trinary, .negate = true}, nav2), row.negated);
        }
    }
}

// A cell as occupied as a threshold says: 204 is 51 of 255 dark, a fifth.
TEST(Occupancy, ThresholdsBelongToWhatTheyBound) {
    const io::RosYaml fifths{.occupied_thresh = 0.6, .free_thresh = 0.2};
    EXPECT_EQ(of_grey(204, fifths), "0");
    EXPECT_EQ(of_grey(203, fifths), unknown);
    EXPECT_EQ(of_grey(102, fifths), "100");
    EXPECT_EQ(of_grey(103, fifths), unknown);
    const io::RosYaml extremes{.occupied_thresh = 1, .free_thresh = 0};
    EXPECT_EQ(of_grey(255, extremes), "0");
    EXPECT_EQ(of_grey(254, extremes), unknown);
    EXPECT_EQ(of_grey(1, extremes), unknown);
    EXPECT_EQ(of_grey(0, extremes), "100");
    // Where one value is both, free counts.
    EXPECT_EQ(of_grey(102, {.occupied_thresh = 0.6, .free_thresh = 0.6}), "0");
    EXPECT_EQ(of_grey(101, {.mode = RosMode::scale, .occupied_thresh = 0.6, .free_thresh = 0.6}), "100");
}

TEST(Occupancy, ThresholdsWereStrictUpToHumble) {
    const io::RosYaml fifths{.occupied_thresh = 0.6, .free_thresh = 0.2};
    EXPECT_EQ(of_grey(204, fifths, Nav2::humble), unknown);
    EXPECT_EQ(of_grey(205, fifths, Nav2::humble), "0");
    EXPECT_EQ(of_grey(102, fifths, Nav2::humble), unknown);
    EXPECT_EQ(of_grey(101, fifths, Nav2::humble), "100");
    EXPECT_EQ(of_grey(255, {.free_thresh = 0}, Nav2::humble), unknown);
    EXPECT_EQ(of_grey(0, {.occupied_thresh = 1}, Nav2::humble), unknown);
}

TEST(Occupancy, TransparentPixelsAreUnknown) {
    for (const RosMode mode : {RosMode::trinary, RosMode::scale}) {
        EXPECT_EQ(of_transparent(0, 255, {.mode = mode}), "100");
        EXPECT_EQ(of_transparent(0, 254, {.mode = mode}), unknown);
        EXPECT_EQ(of_transparent(255, 255, {.mode = mode}), "0");
        EXPECT_EQ(of_transparent(255, 0, {.mode = mode}), unknown);
    }
    // The saver's grey for unknown stays what it is in an image with transparency.
    EXPECT_EQ(of_transparent(205, 255, {}), unknown);
    EXPECT_EQ(of_transparent(70, 0, {.mode = RosMode::raw}), "70");
}

TEST(Occupancy, TransparencyCountedAsAColourUpToHumble) {
    EXPECT_EQ(of_transparent(0, 255, {}, Nav2::humble), "100");
    EXPECT_EQ(of_transparent(205, 255, {}, Nav2::humble), "0");
    EXPECT_EQ(of_transparent(0, 0, {}, Nav2::humble), "100");
    EXPECT_EQ(of_transparent(255, 0, {}, Nav2::humble), unknown);
    EXPECT_EQ(of_transparent(0, 254, {.mode = RosMode::scale}, Nav2::humble), unknown);
    EXPECT_EQ(of_transparent(0, 255, {.mode = RosMode::scale}, Nav2::humble), "100");
    EXPECT_EQ(of_transparent(70, 0, {.mode = RosMode::raw}, Nav2::humble), "70");
}

// The grey of a colour is how light it looks, cut to a whole number; up to Humble it was the mean.
TEST(Occupancy, ColoursBecomeGrey) {
    const auto raw = [](int red, int green, int blue, Nav2 nav2) {
        return word(occupancy(GreyImage::Pixel::of_colour(red, green, blue), false, {.mode = RosMode::raw}, nav2));
    };
    // By GraphicsMagick 1.3.40: 39,28,43 weighs 32.999, which its 16 bits round up.
    EXPECT_EQ(raw(39, 28, 43, Nav2::jazzy), "33");
    EXPECT_EQ(raw(255, 0, 0, Nav2::jazzy), "76");
    EXPECT_EQ(raw(0, 0, 255, Nav2::jazzy), "29");
    EXPECT_EQ(raw(50, 80, 90, Nav2::jazzy), "72");
    EXPECT_EQ(raw(255, 0, 0, Nav2::humble), "85");
    EXPECT_EQ(raw(50, 80, 90, Nav2::humble), "73");
    for (int grey = 0; grey < 256; ++grey) {
        EXPECT_EQ(GreyImage::Pixel::of_colour(grey, grey, grey).luma, grey);
    }
}

}  // namespace
}  // namespace waybreaker::mapfile
