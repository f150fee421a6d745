// The maps that every server has, with or without a folder: the bytes of files in data/ (defined by the build).
#pragma once

#include <array>
#include <string_view>

namespace waybreaker::service {

std::string_view berlin_adlershof_tif();
std::string_view berlin_mitte_tif();

struct BuiltInMap {
    std::string_view name;
    std::string_view (*bytes)();
};

inline constexpr std::array built_in_maps{BuiltInMap{"berlin-adlershof.tif", berlin_adlershof_tif},
                                          BuiltInMap{"berlin-mitte.tif", berlin_mitte_tif}};

// Null where none is called so.
constexpr const BuiltInMap* built_in_map(std::string_view name) {
    for (const BuiltInMap& map : built_in_maps) {
        if (map.name == name) return &map;
    }
    return nullptr;
}

}  // namespace waybreaker::service
