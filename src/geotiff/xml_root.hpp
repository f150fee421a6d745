// Where the root of an XML document begins, and what it is.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace waybreaker::geotiff {

struct XmlRoot {
    std::size_t at;         // of its '<'
    std::string_view name;  // with its prefix
};

// Past declarations and comments of any length; empty if there is none among these first bytes.
std::optional<XmlRoot> xml_root(std::string_view head);

}  // namespace waybreaker::geotiff
