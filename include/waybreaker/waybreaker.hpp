// waybreaker: missions of ground agents whose way aircraft can open, planned and checked. Depends on the standard
// library alone. What plans are made of, search by search: advanced.hpp.
#pragma once

#include "waybreaker/airspace.hpp"        // IWYU pragma: export
#include "waybreaker/body.hpp"            // IWYU pragma: export
#include "waybreaker/cell.hpp"            // IWYU pragma: export
#include "waybreaker/check.hpp"           // IWYU pragma: export
#include "waybreaker/error.hpp"           // IWYU pragma: export
#include "waybreaker/expected.hpp"        // IWYU pragma: export
#include "waybreaker/grid.hpp"            // IWYU pragma: export
#include "waybreaker/limits.hpp"          // IWYU pragma: export
#include "waybreaker/map.hpp"             // IWYU pragma: export
#include "waybreaker/map_edit.hpp"        // IWYU pragma: export
#include "waybreaker/method.hpp"          // IWYU pragma: export
#include "waybreaker/mission.hpp"         // IWYU pragma: export
#include "waybreaker/movingai.hpp"        // IWYU pragma: export
#include "waybreaker/path_through.hpp"    // IWYU pragma: export
#include "waybreaker/place_error.hpp"     // IWYU pragma: export
#include "waybreaker/plan.hpp"            // IWYU pragma: export
#include "waybreaker/planner.hpp"         // IWYU pragma: export
#include "waybreaker/rehearse.hpp"        // IWYU pragma: export
#include "waybreaker/revise.hpp"          // IWYU pragma: export
#include "waybreaker/search_options.hpp"  // IWYU pragma: export
#include "waybreaker/state.hpp"           // IWYU pragma: export
#include "waybreaker/version.hpp"         // IWYU pragma: export
#include "waybreaker/words.hpp"           // IWYU pragma: export
#include "waybreaker/zone.hpp"            // IWYU pragma: export
