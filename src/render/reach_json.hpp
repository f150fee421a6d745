// The bands of a picture of many places as data, for who draws them itself: "waybreaker-reach/1".
//
//     {"format": "waybreaker-reach/1", "width": 8, "height": 1, "inbound": false, "hubs": [[0, 0]],
//      "bands": [2.5, 5], "sooner": 0.25, "before": [1, 2, 3, 6], "after": [1, 2, 2, 6], "gains": [0, 2, 2, 6]}
//
// Band k ends at the k-th time, in units of time. Runs of cells, row by row: what they show, and how many there are. 0
// is an obstacle, k ground reached in band k, one more than there are bands ground that is not reached. Gains: 1 is
// reached sooner by `sooner` or more, 2 only now.
#pragma once

#include <optional>
#include <string>

#include "io/map_file.hpp"
#include "io/plan_file.hpp"
#include "model/reach.hpp"

namespace waybreaker::render {

// Without reach there are no bands, and nothing else is said.
std::string reach_json(const io::MapFile& map, const io::PlanFile& plan, const std::optional<Reach>& reach);

}  // namespace waybreaker::render
