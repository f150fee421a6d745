// A plan as a page of its own: one file that needs no server and no network.
#pragma once

#include <string>
#include <string_view>

namespace waybreaker::studio {

// The viewer of studio/ with `data` in it: JSON with what it shows (`PlanDocument` of studio/src/mission/viewer.ts).
std::string plan_page(std::string_view title, std::string_view data);

}  // namespace waybreaker::studio
