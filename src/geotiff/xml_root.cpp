#include "geotiff/xml_root.hpp"

#include <algorithm>

#include "core/byte_order_mark.hpp"

namespace waybreaker::geotiff {
namespace {

constexpr std::string_view blanks = " \t\r\n";

// Past a document type declaration, which may hold others in square brackets.
std::size_t end_of_doctype(std::string_view head, std::size_t at) {
    const std::size_t end = head.find_first_of(">[", at);
    if (end == std::string_view::npos || head[end] == '>') return end;
    const std::size_t bracket = head.find(']', end);
    return head.find('>', std::min(bracket, head.size()));
}

}  // namespace

std::optional<XmlRoot> xml_root(std::string_view head) {
    std::size_t at = head.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
    while ((at = head.find_first_not_of(blanks, at)) != std::string_view::npos) {
        const std::string_view rest = head.substr(at);
        std::size_t end = std::string_view::npos;
        if (rest.starts_with("<?")) {
            end = head.find("?>", at);
            if (end != std::string_view::npos) ++end;
        } else if (rest.starts_with("<!--")) {
            end = head.find("-->", at + 4);
            if (end != std::string_view::npos) end += 2;
        } else if (rest.starts_with("<!")) {
            end = end_of_doctype(head, at);
        } else {
            const std::size_t behind = rest.find_first_of(" \t\r\n>/", 1);
            const bool tag = rest.front() == '<' && behind != std::string_view::npos && behind > 1;
            return tag ? std::optional(XmlRoot{at, rest.substr(1, behind - 1)}) : std::nullopt;
        }
        if (end == std::string_view::npos) break;
        at = end + 1;
    }
    return std::nullopt;
}

}  // namespace waybreaker::geotiff
