#include "authors/xml_element.hpp"

#include <algorithm>

#include "core/byte_order_mark.hpp"
#include "movingai/text_lines.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/grid.hpp"

namespace waybreaker::authors {
namespace {

bool same_tag(std::string_view in_file, std::string_view tag) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; };
    return std::equal(in_file.begin(), in_file.end(), tag.begin(), tag.end(),
                      [&](char a, char b) { return lower(a) == b; });
}

// A parsed tag or attribute takes many times the bytes it has in the file. The largest map needs half of these.
constexpr std::ptrdiff_t most_marks = 4 * std::ptrdiff_t{max_side};

}  // namespace

XmlFile::XmlFile(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {
    if (std::count_if(bytes.begin(), bytes.end(), [](char c) { return c == '<' || c == '='; }) > most_marks) {
        throw InputError(name, 0, "has over " + std::to_string(most_marks) + " tags and attributes: is it a map?");
    }
    // With the encoding fixed, offsets in the document are offsets in the file.
    const pugi::xml_parse_result result =
        document_.load_buffer(bytes.data(), bytes.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!result) throw error(result.offset, std::string("not well-formed XML: ") + result.description());
}

XmlFile::Element XmlFile::root() const {
    return {*this, document_.document_element()};
}

InputError XmlFile::error(std::ptrdiff_t offset, const std::string& message) const {
    const std::string_view before = bytes_.substr(0, std::size_t(std::max<std::ptrdiff_t>(offset, 0)));
    return {name_, 1 + std::size_t(std::count(before.begin(), before.end(), '\n')), message};
}

std::string_view XmlFile::Element::trimmed_text() const {
    constexpr std::string_view white_space = " \t\r\n";
    const std::string_view all = text();
    const std::size_t first = all.find_first_not_of(white_space);
    if (first == std::string_view::npos) return {};
    return all.substr(first, all.find_last_not_of(white_space) - first + 1);
}

bool XmlFile::Element::is(std::string_view tag) const {
    return same_tag(node_.name(), tag);
}

std::optional<XmlFile::Attribute> XmlFile::Element::attribute(const char* name) const {
    const pugi::xml_attribute found = node_.attribute(name);
    return found ? std::optional(Attribute{*this, found.name(), found.value()}) : std::nullopt;
}

std::optional<XmlFile::Element> XmlFile::Element::find(std::string_view tag) const {
    std::optional<Element> found;
    for_each_child([&](Element child) {
        if (!child.is(tag)) return;
        if (found) throw child.error("<" + std::string(tag) + "> is given twice");
        found = child;
    });
    return found;
}

XmlFile::Element XmlFile::Element::get(std::string_view tag) const {
    const std::optional<Element> found = find(tag);
    if (!found) throw error("<" + std::string(tag) + "> is missing in " + in_quotes(node_.name()));
    return *found;
}

bool is_xml(std::string_view bytes) {
    bytes = without_byte_order_mark(bytes);
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && bytes[first] == '<';
}

}  // namespace waybreaker::authors
