#include "laws.hpp"
#include "mapfile/map_reader.hpp"
#include "service/edited_map.hpp"

// What is read makes a map of the same size, whose freed cells are free unless they are drawn, or is refused in one
// line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace waybreaker;
    static const service::StoredMap map{
        .file = mapfile::parse_map("type octile\nheight 2\nwidth 5\nmap\n.@.@@\n.....\n", "map")};
    read_or_refuse(data, size, [](std::string_view bytes) {
        const request::MapEdits edits = request::parse_map_edits(bytes, "input");
        law(edits.block.size() + edits.free.size() <= bytes.size());
        try {
            const Map drawn = service::edited_map(map, edits).file.map;
            law(drawn.width() == 5 && drawn.height() == 2);
            for (const request::CellRun& run : edits.block) law(drawn.obstacle_at(run.first).value != 0);
            for (const request::CellRun& run : edits.free) {
                if (edits.block.empty()) law(drawn.obstacle_at(run.first).value == 0);
            }
        } catch (const InputError& error) {
            for (const char c : std::string_view(error.what())) law(static_cast<unsigned char>(c) >= ' ');
        }
    });
    return 0;
}
