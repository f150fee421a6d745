// The files of the page (studio/), built into the program.
#pragma once

#include <span>
#include <string_view>

namespace waybreaker::studio {

struct File {
    std::string_view path;  // as asked for: "/" is the page itself
    std::string_view type;  // media type
    std::string_view bytes;
};

std::span<const File> files();

}  // namespace waybreaker::studio
