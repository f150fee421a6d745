// Where an agent can stand.
#pragma once

#include <optional>

#include "waybreaker/body.hpp"
#include "waybreaker/cell.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker {

// The nearest cell, in rings around `at`, where the agent can stand: `at` itself if it can; empty if there is none.
std::optional<Cell> nearest_place(const OpenedMap& map, Cell at, const Body& body);

}  // namespace waybreaker
