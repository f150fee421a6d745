// Errors of JSON from outside say where they are: line and column of the text as it came.
#include "io/json_field.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "input_error.hpp"
#include "io/json_position.hpp"

namespace waybreaker::io {
namespace {

constexpr int max_depth = 4;

template <class Read>
std::string refusal(const std::string& text, Read read) {
    return input_error([&] {
        const JsonDocument document = parse_json(text, "f.json", max_depth);
        read(JsonField(document));
    });
}
std::string refusal(const std::string& text) {
    return refusal(text, [](const JsonField&) {});
}

TEST(JsonField, TextThatIsNoJsonIsRefusedWhereItStopsBeingSo) {
    EXPECT_EQ(refusal(""), "f.json:1:1: this is not JSON: it ends too early");
    EXPECT_EQ(refusal("{\"a\": \n [1,"), "f.json:2:5: this is not JSON: it ends too early");
    EXPECT_EQ(refusal("{\n\"format\": \n\n }"), "f.json:4:2: this is not JSON");
    EXPECT_EQ(refusal("{\"é\": !}"), "f.json:1:7: this is not JSON") << "columns are characters";
    EXPECT_EQ(refusal(std::string("1\n\0,}", 5)), "f.json:2:1: this is not JSON: it has a null byte");
    EXPECT_EQ(refusal({"\xFF\xFE{\0}\0", 6}), "f.json:1:1: this is not JSON: it is in UTF-16; save it in UTF-8");
    EXPECT_EQ(refusal({"\0{\0}", 4}), "f.json:1:1: this is not JSON: it is in UTF-16; save it in UTF-8");
    EXPECT_EQ(refusal("[\n\"Stra\xDF\"]"), "f.json:2:6: this is not JSON: it is not in UTF-8; save it so");
    EXPECT_EQ(refusal("[\"1e999\",\n  1e99, -1e999]"), "f.json:2:10: this number is too large");
    EXPECT_EQ(refusal("[1e-999, 1e308]"), "");
    EXPECT_EQ(refusal("{\"[[[[[\": [[[\n[1]]]]}"), "f.json:2:1: its values are nested too deep");
    EXPECT_EQ(refusal(std::string(1000, '[')), "f.json:1:5: its values are nested too deep");
}

TEST(JsonField, MayFollowAByteOrderMark) {
    const std::string mark = "\xEF\xBB\xBF";
    EXPECT_EQ(refusal(mark + "{\"a\": [1]}"), "");
    EXPECT_EQ(refusal(mark + "{\"a\": 1, \"a\": 2}"), "f.json:1:10: the member 'a' is there twice");
    EXPECT_EQ(refusal(mark + "{\"a\": {}}", [](const JsonField& root) { root["a"].number(); }),
              "f.json:1:7: a is not a number");
    EXPECT_EQ(refusal(mark + "[!]"), "f.json:1:2: this is not JSON");
}

TEST(JsonField, SaysWhereItStands) {
    const std::string text =
        "\n{\"a\": {\"]\\\"}\": [{}], \"b.c\": 1,\n\t\"b\" : [7, [8, \"x,y\"],\n {\"d\": true} ]}}";
    const auto at = [&](auto read) { return refusal(text, read); };
    EXPECT_EQ(at([](const JsonField& root) { root.number(); }), "f.json:2:1: the document is not a number");
    EXPECT_EQ(at([](const JsonField& root) { (void)root["a"].items(); }), "f.json:2:7: a is not an array");
    EXPECT_EQ(at([](const JsonField& root) { (void)root["a"]["b"].number(); }), "f.json:3:8: a.b is not a number");
    EXPECT_EQ(at([](const JsonField& root) { root["a"]["b"].items()[1].items()[1].number(); }),
              "f.json:3:16: a.b[1][1] is not a number");
    EXPECT_EQ(at([](const JsonField& root) { root["a"]["b"].items()[2]["d"].text(); }),
              "f.json:4:8: a.b[2].d is not a text");
    EXPECT_EQ(at([](const JsonField& root) { (void)root["a"]["c"]; }), "f.json:2:7: a has no member c");
    EXPECT_EQ(at([](const JsonField& root) {
                  root["a"].allow({"]\"}", "b"});
              }),
              "f.json:2:22: a has a member 'b.c', which is none of ]\"}, b")
        << "the member's name";
}

TEST(JsonField, TextHoldsNoControlCharacters) {
    const auto text = [](const std::string& value) {
        return refusal("[" + nlohmann::json(value).dump() + "]", [](const JsonField& root) { root.items()[0].text(); });
    };
    for (const std::string value : {"\n", "a\x1b[31m", "\x7f", "\u0085", "a\u202eb", "\u2066", "\u2028"}) {
        EXPECT_EQ(text(value), "f.json:1:2: [0] holds control characters") << value;
    }
    for (const std::string value : {"", "é", "\u05d0\u200f", "日本", "\u2027\u202f\u2065\u206a"})
        EXPECT_EQ(text(value), "");
}

TEST(JsonField, AMemberTwiceIsRefused) {
    EXPECT_EQ(refusal("{\"a\": 1,\n \"\\u0061\": 2}"), "f.json:2:2: the member 'a' is there twice");
    EXPECT_EQ(refusal("[{\"b\": [{\"b\": 1}, \"b\"], \"c\": {\"b\": \"b\"},\n\"b\": 2}]"),
              "f.json:2:1: the member 'b' is there twice");
    EXPECT_EQ(refusal("{\"a\": {\"b\": \"a\", \"c\": [\"c\", \"c\"]}, \"b\": [{\"b\": 1}, {\"b\": 2}]}"), "");
}

// A document of objects in arrays, written with any spaces, and the place of a value in it.
RC_GTEST_PROP(JsonField, FindsEveryValueWhateverStandsAroundIt, ()) {
    const auto texts = *rc::gen::container<std::vector<std::string>>(4, rc::gen::arbitrary<std::string>());
    const auto name = [&](std::size_t i) {
        return nlohmann::json(texts[i]).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    };
    const std::string gap = *rc::gen::container<std::string>(rc::gen::elementOf(std::string(" \t\r\n")));
    std::string text = gap + "{" + gap + name(0) + gap + ":" + gap + "[" + name(1) + ",{}, 5" + gap + "]," + gap +
                       "\"wanted\":[" + name(2) + "," + gap + "{" + name(3) + ":[{}]," + gap + "\"it\":" + gap;
    RC_PRE(std::find(texts.begin(), texts.end(), "wanted") == texts.end());
    const std::size_t expected = text.size();
    text += "null" + gap + "}]}";
    RC_ASSERT(value_at(text, "wanted[1].it") == expected);
}

}  // namespace
}  // namespace waybreaker::io
