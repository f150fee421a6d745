// Where OpenStreetMap's XML begins.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace waybreaker::geo {

// The position of the root of an XML document in its first bytes, past declarations and comments of any length; empty
// if that is not <osm>, or not among these bytes.
std::optional<std::size_t> osm_root(std::string_view head);

}  // namespace waybreaker::geo
