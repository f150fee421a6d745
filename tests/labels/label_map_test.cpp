// Label maps of cells and items alone, and names that any bytes become.
#include "labels/label_map.hpp"

#include <gtest/gtest.h>

#include <map>

#include "core/utf8.hpp"
#include "input_error.hpp"
#include "labels/obstacle_names.hpp"

namespace waybreaker::labels {
namespace {

using Texts = std::map<std::string, std::string>;

// Nothing is deflated here.
std::vector<std::uint8_t> inflate_nothing(std::string_view, std::size_t) {
    return {};
}

LabelMap map_of(const Texts& texts, std::vector<std::uint32_t> labels, int width, int height) {
    const auto item = [&](const char* name) {
        const auto found = texts.find(name);
        return found == texts.end() ? std::string() : found->second;
    };
    const std::array<double, 6> transform{100, 2, 0, 50, 0, -2};
    LabelRaster raster = read_items(item, width, height, transform, inflate_nothing, "city.tif");
    raster.layer.labels = std::move(labels);
    return label_map(std::move(raster));
}

TEST(LabelMap, is_what_its_items_say) {
    const Texts texts{{"TIFFTAG_IMAGEDESCRIPTION", "Town"},  {"WAYBREAKER_PROFILE", "truck"},
                      {"WAYBREAKER_OBSTACLES", "17,!18"},    {"WAYBREAKER_WEIGHTS", "2.5,1"},
                      {"WAYBREAKER_NAMES", "2 The moat"},    {"WAYBREAKER_TAGS", "amenity=school\t1"},
                      {"WAYBREAKER_WAYS", "100 50 2\n1 0 2"}};
    const LabelMap read = map_of(texts, {2, 0, 0, 0, 0, 1}, 3, 2);
    EXPECT_FALSE(read.mask);
    const auto [moat, school] = std::array{read.described.map.obstacle({1}), read.described.map.obstacle({2})};
    EXPECT_EQ(moat.source_id, 18);
    EXPECT_FALSE(moat.destructible);
    EXPECT_EQ(school.weight, 2.5);
    const site::Annotations& known = read.described.annotations;
    EXPECT_EQ(known.title, "Town");
    EXPECT_EQ(known.profile, site::Profile::truck);
    EXPECT_EQ(known.name_of({1}), "The moat");
    EXPECT_EQ(known.tags.at("amenity=school"), std::vector{ObstacleId{2}});
    EXPECT_EQ(known.ways, (std::vector<site::CellRun>{{{1, 0}, 2}}));
}

TEST(LabelMap, without_items_is_a_mask_where_it_has_one_value) {
    EXPECT_TRUE(map_of({}, {7, 0, 7}, 3, 1).mask);
    EXPECT_EQ(map_of({}, {7, 0, 7}, 3, 1).described.map.obstacles().size(), 2U);
    EXPECT_FALSE(map_of({}, {7, 0, 8}, 3, 1).mask);
    EXPECT_EQ(map_of({{"WAYBREAKER_OBSTACLES", "0"}}, {1, 0, 1}, 3, 1).described.map.obstacles().size(), 1U);
}

TEST(LabelMap, names_the_item_that_cannot_be_understood) {
    for (const char* item : {"WAYBREAKER_OBSTACLES", "WAYBREAKER_NAMES", "WAYBREAKER_TAGS", "WAYBREAKER_WAYS"}) {
        const std::string error = input_error([&] { map_of({{item, "?"}}, {1, 0, 2}, 3, 1); });
        EXPECT_NE(error.find(item), std::string::npos) << error;
        EXPECT_TRUE(error.starts_with("city.tif: ")) << error;
    }
}

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

TEST(Utf8, differs_from_other_bytes) {
    for (const char* text : {"", "a", "\u00e9", "\u20ac", "\U0001f600", "\U0010ffff"})
        EXPECT_TRUE(is_utf8(text)) << text;
    for (const char* bytes : {"\x80", "\xc3", "\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xff",
                              "\xf8\x88\x80\x80\x80", "a\xe2\x82"}) {
        EXPECT_FALSE(is_utf8(bytes)) << bytes;
    }
}

}  // namespace
}  // namespace waybreaker::labels
