#include "maps.hpp"

#include <cstdlib>
#include <fstream>

#include "waybreaker/error.hpp"
#include "waybreaker/movingai.hpp"

namespace waybreaker::bench {

std::filesystem::path shared_folder() {
    if (const char* folder = std::getenv("WAYBREAKER_SHARED")) return folder;
    return std::filesystem::path(WAYBREAKER_SOURCE_DIR) / ".." / "shared";
}

std::filesystem::path city_in_data(const std::string& name) {
    return std::filesystem::path(WAYBREAKER_SOURCE_DIR) / "data" / (name + ".tif");
}

Grid read_city(const std::string& name) {
    const std::filesystem::path path = shared_folder() / "data" / "cities" / (name + ".map");
    std::ifstream in(path, std::ios::binary);
    if (!in) throw InputError(path.string(), 0, "is not there: set WAYBREAKER_SHARED to the folder of shared data");
    return read_movingai_map(in, path.string());
}

Grid mosaic(const Grid& tile, int side) {
    Grid grid(side, side);
    for (Cell c; c.y < side; ++c.y) {
        for (c.x = 0; c.x < side; ++c.x) {
            if (tile.blocked({c.x % tile.width(), c.y % tile.height()})) grid.set_blocked(c, true);
        }
    }
    return grid;
}

}  // namespace waybreaker::bench
