#include "exports/xml_document.hpp"

#include <cstdint>
#include <optional>
#include <sstream>

#include "core/utf8.hpp"

namespace waybreaker::exports {
namespace {

// XML 1.0, section 2.2; tabs and line ends are none of a name's.
bool is_character(std::uint32_t code) {
    return code >= 0x20 && code != 0x7F && code != 0xFFFE && code != 0xFFFF;
}

}  // namespace

std::string characters_of_xml(std::string_view bytes) {
    std::string text;
    while (!bytes.empty()) {
        const std::optional<Utf8Character> character = first_character(bytes);
        const std::size_t length = character ? character->length : 1;
        text += character && is_character(character->code) ? bytes.substr(0, length) : "\xEF\xBF\xBD";
        bytes.remove_prefix(length);
    }
    return text;
}

pugi::xml_node append_text(pugi::xml_node parent, const char* name, std::string_view text) {
    pugi::xml_node node = parent.append_child(name);
    node.text().set(characters_of_xml(text).c_str());
    return node;
}

std::string document_text(const pugi::xml_document& document) {
    std::ostringstream text;
    document.save(text, "  ", pugi::format_default, pugi::encoding_utf8);
    return std::move(text).str();
}

}  // namespace waybreaker::exports
