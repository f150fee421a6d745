// Query: what a crossing search is asked, and how far it has come, as its parts need it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <span>
#include <vector>

#include "core/interrupt.hpp"
#include "crossing/access.hpp"
#include "crossing/geometry/lattice.hpp"
#include "crossing/geometry/regions.hpp"
#include "waybreaker/advanced/crossing.hpp"

namespace waybreaker::crossing {

struct CrossingQuery {
    const Map* map = nullptr;
    const CrossingOptions* options = nullptr;
    const Opener* opener = nullptr;
    std::shared_ptr<const Regions> regions;
    Vertex start;
    Vertex goal;
    std::vector<ObstacleId> removed;  // sorted
    bool enumerates = false;          // more than one path is asked for
    bool waits = false;               // obstacles open in time
    bool by_count = true;             // of what is crossed and left, only the number matters
    bool pinched = false;             // cells that touch at a corner leave no room between them
    double early = 0;                 // half cells: how much sooner than at a lattice point a path may be at its gate

    // Whether paths may cost more than their length, for what they cross.
    bool in_time() const { return waits || opener->done_after; }
    // How many obstacles a set may hold, the removed ones included.
    std::size_t capacity() const { return std::size_t(options->crossings) + removed.size(); }
    // Length of the longest paths that matter, half cells: a path may wait half a cell from the place of its gate.
    double longest() const { return 2 * options->length_limit + (waits ? 2 * early : 0); }
    // The obstacles of a set that were not removed from the start.
    std::vector<ObstacleId> without_removed(std::span<const ObstacleId> set) const {
        std::vector<ObstacleId> ids;
        std::ranges::copy_if(set, std::back_inserter(ids),
                             [this](ObstacleId id) { return !std::ranges::binary_search(removed, id); });
        return ids;
    }
};

struct CrossingProgress {
    Interrupt interrupt;
    double limit = infinity;  // half cells; paths that cost more are left out
    std::uint64_t expanded = 0;
};

}  // namespace waybreaker::crossing
