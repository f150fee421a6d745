// What Vite made of studio/, as bytes, and the planner of pages without a server (defined by the build).
#pragma once

#include <string_view>

namespace waybreaker::studio {

std::string_view index_html();
std::string_view studio_js();
std::string_view studio_css();
std::string_view worker_js();
std::string_view service_worker_js();
std::string_view planner_wasm();

}  // namespace waybreaker::studio
