// Occupancy: the sites taken at each time, and the earliest route of one vehicle past all others.
//
// A search looks at all vehicles' sites as sets of bits: what can be reached at the next time is what can be reached
// now and all that is beside it, 64 sites at once.
#pragma once

#include <optional>
#include <vector>

#include "core/random.hpp"
#include "lockstep/configurations.hpp"

namespace waybreaker::lockstep {

// The site at each time, from 0 on; stands at the last one for ever. Arrives when it comes to the last one.
using Route = std::vector<Site>;
inline std::size_t arrival(const Route& route) {
    return route.size() - 1;
}

// Moves that vehicles must not make in the same step, beside ending at the same site: swap places, and if they are too
// wide for it, turn into where another leaves, or out of where another comes.
struct Meeting {
    bool at_turns = false;

    // Whether one that goes from a site to another meets one that goes so as well.
    bool operator()(Site from_a, Site to_a, Site from_b, Site to_b) const {
        if (from_a == to_a || from_b == to_b) return false;
        if (!at_turns) return to_a == from_b && to_b == from_a;
        return (to_a == from_b || to_b == from_a) && to_a - from_a != to_b - from_b;
    }
};

class Occupancy {
  public:
    // Limited to so many words and times together: routes that end later are not found.
    Occupancy(const Lattice& lattice, Meeting meeting, std::size_t most_words);

    // REQUIRES: the route meets none of those that are there.
    void add(const Route& route) { mark(route, true); }
    void remove(const Route& route) { mark(route, false); }

    // A route that arrives as early as can be, past all others; of several a random one. None if it would arrive later
    // than that. Time O(sites / 64 * arrival).
    std::optional<Route> find(Site start, Site goal, std::size_t latest, Random& random);

  private:
    void mark(const Route& route, bool there);
    void grow(std::size_t times);
    // At a time, past the last one as then.
    const Word* taken(std::size_t t) const { return &taken_[std::min(t, times_ - 1) * lattice_.words()]; }
    // Where steps in that direction, from that time on to the next, can end.
    Word free(std::size_t t, Direction d, std::size_t word) const {
        Word ends = lattice_.ends(d)[word];
        if (t + 1 >= times_) return ends;
        const std::size_t at = t * lattice_.words() + word;
        return ends & ~(behind_[d][at] | aside_[d][at]);
    }
    void expand(std::size_t t);
    Route way_to(Site goal, std::size_t arrival, Random& random) const;

    const Lattice& lattice_;
    Meeting meeting_;
    std::size_t most_times_;
    std::size_t times_ = 0;
    SiteSet taken_;                           // for each time
    std::array<SiteSet, directions> behind_;  // likewise: somebody leaves, from this time on to the next
    std::array<SiteSet, directions> aside_;   // beside where somebody comes to
    SiteSet reached_;                         // of the last search, for each time
};

}  // namespace waybreaker::lockstep
