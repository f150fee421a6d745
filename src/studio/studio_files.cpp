#include "studio/studio_files.hpp"

#include <array>

#include "studio/bundle.hpp"

namespace waybreaker::studio {

std::span<const File> files() {
    static const std::array<File, 3> all{{{"/", "text/html; charset=utf-8", index_html()},
                                          {"/studio.js", "text/javascript; charset=utf-8", studio_js()},
                                          {"/studio.css", "text/css; charset=utf-8", studio_css()}}};
    return all;
}

}  // namespace waybreaker::studio
