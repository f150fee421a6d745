// A plan as a page of its own: one file that needs no server and no network.
#pragma once

#include <string>
#include <string_view>

namespace waybreaker::studio {

// What the page shows where no script runs: in previews of mail programs, and of phones.
struct StillPlan {
    std::string title = {};     // any bytes
    std::string sentence = {};  // text of HTML
    std::string picture = {};   // an SVG element
};

// What a page carries that plans by itself (`Carried` of studio/src/api/carried.ts).
struct CarriedPlanner {
    std::string map = {};      // a map document ("waybreaker-map/1")
    std::string plan = {};     // a plan file; its mission is planned when the page is opened
    std::string planner = {};  // studio.wasm, by gzip
};

// The viewer of studio/ with `data` in it: JSON with what it shows (`PlanDocument` of studio/src/mission/viewer.ts).
std::string plan_page(const StillPlan& still, std::string_view data);

// The page of studio/ itself, with a planner in it.
std::string plan_page(const StillPlan& still, const CarriedPlanner& carried);

}  // namespace waybreaker::studio
