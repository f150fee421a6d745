// What a client asks to import, as JSON: the options of `waybreaker import` under their names, with `_` for `-`.
//
//     {"source": "source-8a1f0c92be1d44f7", "center": [7.4197, 43.7311], "size": 600, "profile": "truck"}
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "city/city_import.hpp"
#include "city/extract.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::service {

struct ImportRequest {
    std::string source;
    std::string text;     // as it came
    bool placed = false;  // whether it says where; else the window is the source's densest
    bool sized = false;
    city::ImportOptions options;
};

// Throws InputError that says where and what is wrong.
ImportRequest parse_import_request(std::string_view bytes, const std::string& name = "import");

// What it asks for, in the densest window of the source if it does not say where.
city::ImportOptions window_of(const ImportRequest& request, const city::Extract& extract);

// Throws Problem if its window has more cells than that, or there is no such window.
std::size_t cells_of(const ImportRequest& request, const city::Extract& extract, std::size_t most);

// What is wrong, options under the names that requests give them.
std::string worded(const InputError& error);

}  // namespace waybreaker::service
