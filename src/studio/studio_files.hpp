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

// Those that the service serves.
std::span<const File> files();

// Of a page that plans by itself: the same, and its Worker.
std::span<const File> site_page();

// The script that keeps such a page for when there is no network. It needs `version` and `files` before it.
std::string_view service_worker();

// The WebAssembly that plans in such a page; empty in a program that was built without it.
std::string_view planner();

}  // namespace waybreaker::studio
