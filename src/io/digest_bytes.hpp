// Numbers as the bytes that digests are taken of.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>

namespace waybreaker::io {

// Little-endian.
template <std::unsigned_integral Number>
void append_number(std::string& bytes, Number number) {
    for (std::size_t i = 0; i < sizeof number; ++i) bytes += char(number >> (8 * i) & 0xFF);
}

// What is known of an obstacle, by an Obstacle or by ObstacleAttributes.
template <class Attributes>
void append_attributes(std::string& bytes, const Attributes& attributes) {
    append_number(bytes, std::uint64_t(attributes.source_id));
    append_number(bytes, std::bit_cast<std::uint64_t>(attributes.weight));
    append_number(bytes, std::bit_cast<std::uint64_t>(attributes.breach_time));
    bytes += attributes.destructible ? '\1' : '\0';
}

}  // namespace waybreaker::io
