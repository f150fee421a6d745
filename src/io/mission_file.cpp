#include <filesystem>

#include "io/mission_json.hpp"
#include "io/output_file.hpp"

namespace waybreaker::io {

MissionDocument read_mission_file(const std::string& path, const Limits& limits) {
    MissionDocument document = parse_mission(read_whole(path, max_mission_bytes), path, limits);
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    for (site::OverlaySource& overlay : document.overlays) overlay.file = (folder / overlay.file).string();
    return document;
}

}  // namespace waybreaker::io
