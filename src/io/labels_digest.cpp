#include "io/labels_digest.hpp"

#include <bit>
#include <concepts>
#include <span>

#include "io/sha256.hpp"

namespace waybreaker::io {
namespace {

template <std::unsigned_integral Number>
void append(std::string& bytes, Number number) {
    for (std::size_t i = 0; i < sizeof number; ++i) bytes += char(number >> (8 * i) & 0xFF);
}

}  // namespace

std::string labels_digest(const Map& map) {
    std::string bytes = "waybreaker-labels/1\n";
    append(bytes, std::uint32_t(map.width()));
    append(bytes, std::uint32_t(map.height()));
    const std::span<const std::uint32_t> labels = map.labels();
    for (std::size_t first = 0, end = 0; first < labels.size(); first = end) {
        while (end < labels.size() && labels[end] == labels[first]) ++end;
        append(bytes, labels[first]);
        append(bytes, std::uint32_t(end - first));
    }
    for (const Obstacle& obstacle : map.obstacles()) {
        append(bytes, std::uint64_t(obstacle.source_id));
        append(bytes, std::bit_cast<std::uint64_t>(obstacle.weight));
        append(bytes, std::bit_cast<std::uint64_t>(obstacle.breach_time));
        bytes += obstacle.destructible ? '\1' : '\0';
    }
    return sha256_digest(bytes);
}

}  // namespace waybreaker::io
