// The searches and schedules that plans are made of, for programs that put them together themselves: a frame of a game
// (docs/embedding.md), traces, research. Before 1.0 they may change in any minor version.
#pragma once

#include "waybreaker/advanced/crossing.hpp"       // IWYU pragma: export
#include "waybreaker/advanced/flight.hpp"         // IWYU pragma: export
#include "waybreaker/advanced/safe_interval.hpp"  // IWYU pragma: export
#include "waybreaker/advanced/schedule.hpp"       // IWYU pragma: export
#include "waybreaker/advanced/search.hpp"         // IWYU pragma: export
