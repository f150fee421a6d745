// What Vite made of studio/, as bytes (defined by the build).
#pragma once

#include <string_view>

namespace waybreaker::studio {

std::string_view index_html();
std::string_view studio_js();
std::string_view studio_css();

}  // namespace waybreaker::studio
