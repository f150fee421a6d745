#include "render/xml_text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <pugixml.hpp>

namespace waybreaker::render {
namespace {

using namespace std::string_literals;

TEST(XmlText, EscapesMarkup) {
    EXPECT_EQ(xml_text("<a b='\"'>&amp;", 99), "&lt;a b=&#39;&quot;&#39;&gt;&amp;amp;");
}

TEST(XmlText, KeepsUtf8) {
    EXPECT_EQ(xml_text("Köln 東京 🚁", 99), "Köln 東京 🚁");
}

TEST(XmlText, ReplacesWhatXmlCannotHold) {
    for (const std::string& bytes : {"\x01"s, "\0"s, "\x1B"s, "\x7F"s, "\xFF"s, "\x80"s, "\xC2"s}) {
        EXPECT_EQ(xml_text(bytes, 99), "\uFFFD") << "byte " << int(std::uint8_t(bytes[0]));
    }
    EXPECT_EQ(xml_text("\xC0\xAF", 99), "\uFFFD\uFFFD") << "an overlong slash";
    EXPECT_EQ(xml_text("\xED\xA0\x80", 99), "\uFFFD\uFFFD\uFFFD") << "a surrogate";
    EXPECT_EQ(xml_text("\xEF\xBF\xBF", 99), "\uFFFD\uFFFD\uFFFD") << "no character";
    EXPECT_EQ(xml_text("\xF4\x90\x80\x80", 99), "\uFFFD\uFFFD\uFFFD\uFFFD") << "beyond Unicode";
}

TEST(XmlText, CutsLongTextsBetweenCharacters) {
    EXPECT_EQ(xml_text("äöü", 3), "äöü");
    EXPECT_EQ(xml_text("äöüß", 3), "äöü…");
}

RC_GTEST_PROP(XmlText, AnyBytesMakeWellFormedXml, (const std::string& bytes)) {
    const std::string text = xml_text(bytes, 1000);
    const std::string document = "<t a=\"" + text + "\">" + text + "</t>";
    pugi::xml_document parsed;
    RC_ASSERT(parsed.load_buffer(document.data(), document.size(), pugi::parse_default | pugi::parse_ws_pcdata));
    RC_ASSERT(std::string(parsed.child("t").attribute("a").value()) == parsed.child("t").text().get());
    for (const char c : text) RC_ASSERT(std::uint8_t(c) >= 0x20);
}

}  // namespace
}  // namespace waybreaker::render
