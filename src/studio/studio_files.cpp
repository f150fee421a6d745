#include "studio/studio_files.hpp"

#include <array>

#include "studio/bundle.hpp"

namespace waybreaker::studio {
namespace {

std::span<const File> all() {
    static const std::array<File, 4> files{{{"/", "text/html; charset=utf-8", index_html()},
                                            {"/studio.js", "text/javascript; charset=utf-8", studio_js()},
                                            {"/studio.css", "text/css; charset=utf-8", studio_css()},
                                            {"/worker.js", "text/javascript; charset=utf-8", worker_js()}}};
    return files;
}

}  // namespace

std::span<const File> files() {
    return all().first(3);
}

std::span<const File> site_page() {
    return all();
}

std::string_view service_worker() {
    return service_worker_js();
}

std::string_view planner() {
    return planner_wasm();
}

}  // namespace waybreaker::studio
