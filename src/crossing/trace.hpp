// Trace: the path that a label stands for.
#pragma once

#include <cstdint>
#include <vector>

#include "crossing/geometry/ray.hpp"
#include "crossing/in_time/gates.hpp"
#include "crossing/labels/crossed_sets.hpp"
#include "crossing/labels/labels.hpp"
#include "crossing/labels/query.hpp"

namespace waybreaker::crossing {

// Follows a label back to the start. Casts rays again to tell in which order obstacles are entered.
CrossingPath trace(std::uint32_t label, const CrossingQuery& query, const Labels& labels, const CrossedSets& sets,
                   const std::vector<GateGroup>& groups, Ray& ray);

}  // namespace waybreaker::crossing
