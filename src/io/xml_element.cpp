#include "io/xml_element.hpp"

#include <algorithm>

#include "movingai/text_lines.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::io {
namespace {

bool same_tag(std::string_view in_file, std::string_view tag) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; };
    return std::equal(in_file.begin(), in_file.end(), tag.begin(), tag.end(),
                      [&](char a, char b) { return lower(a) == b; });
}

}  // namespace

XmlFile::XmlFile(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {
    // With the encoding fixed, offsets in the document are offsets in the file.
    const pugi::xml_parse_result result =
        document_.load_buffer(bytes.data(), bytes.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!result) fail(result.offset, std::string("not well-formed XML: ") + result.description());
}

XmlFile::Element XmlFile::root() const {
    return {*this, document_.document_element()};
}

void XmlFile::fail(std::ptrdiff_t offset, const std::string& message) const {
    const std::string_view before = bytes_.substr(0, std::size_t(std::max<std::ptrdiff_t>(offset, 0)));
    throw InputError(name_, 1 + std::size_t(std::count(before.begin(), before.end(), '\n')), message);
}

std::string_view XmlFile::Element::trimmed_text() const {
    constexpr std::string_view white_space = " \t\r\n";
    const std::string_view all = text();
    const std::size_t first = all.find_first_not_of(white_space);
    if (first == std::string_view::npos) return {};
    return all.substr(first, all.find_last_not_of(white_space) - first + 1);
}

std::optional<XmlFile::Element> XmlFile::Element::find(std::string_view tag) const {
    std::optional<Element> found;
    for_each_child([&](Element child) {
        if (!same_tag(child.tag(), tag)) return;
        if (found) child.fail("<" + std::string(tag) + "> is given twice");
        found = child;
    });
    return found;
}

XmlFile::Element XmlFile::Element::get(std::string_view tag) const {
    const std::optional<Element> found = find(tag);
    if (!found) fail("<" + std::string(tag) + "> is missing in " + quoted(node_.name()));
    return *found;
}

}  // namespace waybreaker::io
