// Untrusted text (file names, say) as text of an XML document.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace waybreaker::render {

// Any bytes in, well-formed XML text out, for elements and quoted attributes: markup is escaped; what is not UTF-8 or
// no character of XML 1.0 shows as U+FFFD. Texts longer than `most` characters end in an ellipsis.
std::string xml_text(std::string_view bytes, std::size_t most);

// How many characters that shows.
std::size_t letter_count(std::string_view bytes);

}  // namespace waybreaker::render
