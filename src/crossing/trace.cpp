#include "crossing/trace.hpp"

#include <algorithm>
#include <span>

namespace waybreaker::crossing {
namespace {

// The obstacles of a set that a straight move enters, the last one first.
std::vector<ObstacleId> entered_backwards(const Label& from, const Label& to, const CrossingQuery& query,
                                          const CrossedSets& sets, Ray& ray) {
    const std::span<const ObstacleId> set = sets[to.set];
    ray.set_open(sets[from.set]);
    ray.cast(from.at, to.at, int(set.size()), infinity);
    std::vector<Hit> hits;
    for (const Hit& hit : ray.hits()) {
        if (query.regions->within(hit.region, set)) hits.push_back(hit);
    }
    std::ranges::sort(hits, comes_first);
    std::vector<ObstacleId> entered;
    for (const Hit& hit : hits) ray.add_missing(hit.region, entered);
    std::ranges::reverse(entered);
    return entered;
}

}  // namespace

CrossingPath trace(std::uint32_t label, const CrossingQuery& query, const Labels& labels, const CrossedSets& sets,
                   const std::vector<GateGroup>& groups, Ray& ray) {
    CrossingPath path;
    path.cost = labels[label].estimate / 2;
    const auto append = [&](ObstacleId id) {
        if (std::ranges::find(path.crossed, id) == path.crossed.end()) path.crossed.push_back(id);
    };
    for (;; label = labels[label].parent) {
        const Label& here = labels[label];
        path.path.emplace_back(here.at.x / 2.0, here.at.y / 2.0);
        if (here.parent == no_label) break;
        const Label& before = labels[here.parent];
        path.length += length(here.at - before.at) / 2;
        if (here.gate != 0) {
            const auto& opened = groups[here.gate].terms().opened;
            path.gates.push_back({path.path.back(), query.without_removed(sets[here.set])});
            std::erase_if(path.gates.back().crossed,
                          [&](ObstacleId id) { return std::ranges::binary_search(opened, id); });
            std::ranges::for_each(query.without_removed(opened), append);
            std::ranges::for_each(path.gates.back().crossed, append);
        } else if (here.set != before.set) {
            std::ranges::for_each(entered_backwards(before, here, query, sets, ray), append);
        }
    }
    std::ranges::reverse(path.gates);
    std::ranges::reverse(path.path);
    std::ranges::reverse(path.crossed);
    return path;
}

}  // namespace waybreaker::crossing
