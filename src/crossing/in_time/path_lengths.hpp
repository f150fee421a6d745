// Path lengths: how long shortest paths are between two places with some obstacles open, each searched for once.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "crossing/geometry/lattice.hpp"
#include "crossing/tuning.hpp"
#include "waybreaker/advanced/crossing.hpp"

namespace waybreaker::crossing {

class PathLengths {
  public:
    void start_query(const Map& map, const CrossingOptions& options) {
        const bool same =
            identity_ == map.identity() && options_.body == options.body && options_.relaxed == options.relaxed;
        if (!same || lengths_.size() > tuning::most_lengths) lengths_.clear();
        identity_ = map.identity();
        options_.body = options.body;
        options_.relaxed = options.relaxed;
        options_.limits = options.limits;
        options_.limits.expansions = tuning::most_expanded_for_length;
    }

    // In half cells, or less where the search takes long; infinity where there is no path. `search` finds those that
    // are not known.
    template <class Search>
    double length(Vertex from, Vertex to, const std::vector<ObstacleId>& open, Search search) {
        const auto [known, added] = lengths_.try_emplace({from.x, from.y, to.x, to.y, open}, 0);
        if (!added) return known->second;
        CrossingOptions options = options_;
        options.removed = open;
        const CrossingResult result = search(options);
        known->second = 2 * result.lower_bound;
        const double length = known->second;
        const bool out_of_time =
            result.status == SearchStatus::stopped ||
            (result.status == SearchStatus::limit_reached && result.expanded < tuning::most_expanded_for_length);
        if (out_of_time) lengths_.erase(known);
        return length;
    }

  private:
    std::shared_ptr<const void> identity_;
    CrossingOptions options_;
    std::map<std::tuple<int, int, int, int, std::vector<ObstacleId>>, double> lengths_;
};

}  // namespace waybreaker::crossing
