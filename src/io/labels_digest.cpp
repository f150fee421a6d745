#include "io/labels_digest.hpp"

#include <cstdint>
#include <span>

#include "io/digest_bytes.hpp"
#include "io/sha256.hpp"

namespace waybreaker::io {

std::string labels_digest(const Map& map) {
    std::string bytes = "waybreaker-labels/1\n";
    append_number(bytes, std::uint32_t(map.width()));
    append_number(bytes, std::uint32_t(map.height()));
    const std::span<const std::uint32_t> labels = map.labels();
    for (std::size_t first = 0, end = 0; first < labels.size(); first = end) {
        while (end < labels.size() && labels[end] == labels[first]) ++end;
        append_number(bytes, labels[first]);
        append_number(bytes, std::uint32_t(end - first));
    }
    for (const Obstacle& obstacle : map.obstacles()) append_attributes(bytes, obstacle);
    return sha256_digest(bytes);
}

}  // namespace waybreaker::io
