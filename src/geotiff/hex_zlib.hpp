// zlib streams in hexadecimal digits, as metadata items hold them (labels/cells_item.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace waybreaker::geotiff {

std::string deflated(const std::vector<std::uint8_t>& bytes);

// What was deflated; empty if it is no such text, or more than that many bytes.
std::vector<std::uint8_t> inflated(std::string_view digits, std::size_t most);

}  // namespace waybreaker::geotiff
