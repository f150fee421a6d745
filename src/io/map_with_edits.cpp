#include "io/map_with_edits.hpp"

#include <cstdint>

#include "io/digest_bytes.hpp"
#include "io/sha256.hpp"

namespace waybreaker::io {
namespace {

std::string edited_digest(const std::string& before, const MapEdit& edit) {
    std::string bytes = "waybreaker-edit/1\n" + before + '\n';
    append_number(bytes, std::uint32_t(edit.kind));
    append_number(bytes, edit.obstacle.value);
    append_number(bytes, std::uint32_t(edit.cells.size()));
    for (const Cell c : edit.cells) {
        append_number(bytes, std::uint32_t(c.x));
        append_number(bytes, std::uint32_t(c.y));
    }
    append_attributes(bytes, edit.attributes);
    return sha256_digest(bytes);
}

}  // namespace

MapFile with_edits(MapFile file, const std::vector<MapEdit>& edits) {
    file.map = file.map.with(edits);
    for (const MapEdit& edit : edits) file.digest = edited_digest(file.digest, edit);
    return file;
}

}  // namespace waybreaker::io
