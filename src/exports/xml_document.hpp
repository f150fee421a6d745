// XML documents of people's words: names come from maps and may be any bytes.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace waybreaker::exports {

// Appends <name>text</name>. What XML 1.0 cannot hold, or is no UTF-8, becomes U+FFFD.
pugi::xml_node append_text(pugi::xml_node parent, const char* name, std::string_view text);

// The same rule for attributes.
std::string characters_of_xml(std::string_view bytes);

// In UTF-8, with a declaration.
std::string document_text(const pugi::xml_document& document);

}  // namespace waybreaker::exports
