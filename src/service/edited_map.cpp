#include "service/edited_map.hpp"

#include <utility>

#include "mapfile/map_reader.hpp"
#include "mapfile/map_writer.hpp"
#include "service/memory_account.hpp"

namespace waybreaker::service {
namespace {

std::string bytes_of(const request::EditedMap& edited) {
    const io::MapFile& file = edited.file;
    // MovingAI's format holds cells and nothing else.
    const bool cells_alone =
        edited.plain && !file.georeference && !file.origin && file.cell_size == 1 && file.annotations.notes.empty();
    return mapfile::write_map(file, cells_alone ? "edited.map" : "edited.tif").files.front().bytes;
}

}  // namespace

StoredMap edited_map(const StoredMap& map, const request::MapEdits& edits, const MapLimits& limits) {
    std::string bytes = bytes_of(request::edited_map(map.file, map.connectivity, edits));
    // Read back, so that it equals an upload of the file; then add what the file does not hold.
    const MemoryAccount::Scope none(nullptr);  // the limits count the map
    io::MapFile file = mapfile::parse_map(bytes, "the map", map.connectivity, {}, limits);
    file.task = map.file.task;
    file.origin = map.file.origin;
    file.annotations.title = map.file.annotations.title;
    file.annotations.attribution = map.file.annotations.attribution;
    return {.file = std::move(file), .connectivity = map.connectivity, .bytes = std::move(bytes)};
}

}  // namespace waybreaker::service
