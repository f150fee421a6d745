#include "lockstep/occupancy.hpp"

#include <algorithm>

namespace waybreaker::lockstep {

Occupancy::Occupancy(const Lattice& lattice, Meeting meeting, std::size_t most_words)
    : lattice_(lattice), meeting_(meeting), most_times_(most_words / lattice.words()) {
    grow(1);
}

// All stand as at the last time that was known.
void Occupancy::grow(std::size_t times) {
    if (times <= times_) return;
    const std::size_t words = lattice_.words();
    taken_.resize(times * words);
    for (std::size_t t = times_; t > 0 && t < times; ++t) {
        std::copy_n(&taken_[(t - 1) * words], words, &taken_[t * words]);
    }
    for (SiteSet& sets : behind_) sets.resize(times * words);
    for (SiteSet& sets : aside_) sets.resize(times * words);
    times_ = times;
}

void Occupancy::mark(const Route& route, bool there) {
    grow(route.size());
    const std::size_t words = lattice_.words();
    const auto set = [there](Word* sites, Site site) { there ? insert(sites, site) : erase(sites, site); };
    for (std::size_t t = 0; t < times_; ++t) set(&taken_[t * words], route[std::min(t, route.size() - 1)]);
    for (std::size_t t = 0; t + 1 < route.size(); ++t) {
        const Site from = route[t];
        const Site to = route[t + 1];
        if (from == to) continue;
        for (Direction d = 0; d < directions; ++d) {
            const bool follows = lattice_.next(from, d) == to;
            const bool meets = meeting_.at_turns ? !follows : lattice_.next(to, d) == from;
            if (meets) set(&behind_[d][t * words], from);
            if (meeting_.at_turns && !follows && lattice_.open(to, d)) {
                set(&aside_[d][t * words], lattice_.next(to, d));
            }
        }
    }
}

// Sites reached at the next time.
void Occupancy::expand(std::size_t t) {
    const std::size_t words = lattice_.words();
    const std::size_t row = lattice_.row_words();
    reached_.resize((t + 2) * words);
    const Word* from = &reached_[t * words];
    Word* to = &reached_[(t + 1) * words];
    const Word* taken_then = taken(t + 1);
    const auto step = [&](Direction d, auto shifted) {
        const Word* ends = lattice_.ends(d);
        if (t + 1 >= times_) {
            for (std::size_t w = 0; w < words; ++w) to[w] |= shifted(w) & ends[w];
            return;
        }
        const Word* behind = &behind_[d][t * words];
        const Word* aside = &aside_[d][t * words];
        for (std::size_t w = 0; w < words; ++w) to[w] |= shifted(w) & ends[w] & ~(behind[w] | aside[w]);
    };
    std::copy_n(from, words, to);
    step(0, [&](std::size_t w) { return from[w] << 1U | (w > 0 ? from[w - 1] >> 63U : 0); });
    step(1, [&](std::size_t w) { return from[w] >> 1U | (w + 1 < words ? from[w + 1] << 63U : 0); });
    step(2, [&](std::size_t w) { return w >= row ? from[w - row] : 0; });
    step(3, [&](std::size_t w) { return w + row < words ? from[w + row] : 0; });
    for (std::size_t w = 0; w < words; ++w) to[w] &= ~taken_then[w];
}

std::optional<Route> Occupancy::find(Site start, Site goal, std::size_t latest, Random& random) {
    const std::size_t words = lattice_.words();
    if (contains(taken(times_ - 1), goal) || contains(taken(0), start)) return std::nullopt;
    std::size_t passed = times_ - 1;  // from then on nobody comes to the goal
    while (passed > 0 && !contains(taken(passed - 1), goal)) --passed;
    reached_.assign(words, 0);
    insert(reached_.data(), start);
    latest = std::min(latest, most_times_ - 1);
    for (std::size_t t = 0; t <= latest; ++t) {
        const Word* reached = &reached_[t * words];
        if (t >= passed && contains(reached, goal)) return way_to(goal, t, random);
        if (t == latest) break;
        expand(t);
        const Word* next = &reached_[(t + 1) * words];
        if (t >= times_ && std::equal(next, next + words, &reached_[t * words])) break;  // that is all
        if (std::all_of(next, next + words, [](Word word) { return word == 0; })) break;
    }
    return std::nullopt;
}

// Backwards from the goal, straight on where that can be.
Route Occupancy::way_to(Site goal, std::size_t arrival, Random& random) const {
    const std::size_t words = lattice_.words();
    Route route(arrival + 1, goal);
    Direction last = directions;
    for (std::size_t t = arrival; t > 0; --t) {
        const Site to = route[t];
        const auto came = [&](Direction d) {
            if (d == directions) return contains(&reached_[(t - 1) * words], to);
            if ((free(t - 1, d, to / 64) >> to % 64 & 1U) == 0) return false;
            return contains(&reached_[(t - 1) * words], lattice_.next(to, opposite(d)));
        };
        if (!came(last)) {
            last = Direction(random.below(int(directions) + 1));
            while (!came(last)) last = (last + 1) % (directions + 1);
        }
        route[t - 1] = last == directions ? to : lattice_.next(to, opposite(last));
    }
    return route;
}

}  // namespace waybreaker::lockstep
