#include "lockstep/lattice.hpp"

namespace waybreaker::lockstep {

Lattice::Lattice(const OpenedMap& map, const Body& body)
    : stride_((Site(map.width()) + 63) / 64 * 64), size_(stride_ * Site(map.height())), steps_(size_, 0) {
    const LineOfSight sight(map, body);
    for (SiteSet& ends : ends_) ends.assign(words(), 0);
    for (Cell c; c.y < map.height(); ++c.y) {
        for (c.x = 0; c.x < map.width(); ++c.x) {
            if (!sight.fits(c)) continue;
            for (Direction d = 0; d < directions; ++d) {
                const Cell to{c.x + ahead[d].x, c.y + ahead[d].y};
                if (to.x < 0 || to.y < 0 || to.x >= map.width() || to.y >= map.height()) continue;
                if (!sight.fits(to) || !sight.clear(c, to)) continue;
                steps_[site(c)] = std::uint8_t(steps_[site(c)] | 1U << d);
                insert(ends_[d].data(), site(to));
            }
        }
    }
}

std::vector<std::uint32_t> Lattice::distances_to(Site goal) const {
    std::vector<std::uint32_t> left(size_, unreachable);
    std::vector<Site> queue{goal};
    left[goal] = 0;
    for (std::size_t i = 0; i < queue.size(); ++i) {
        for (Direction d = 0; d < directions; ++d) {
            if (!open(queue[i], d)) continue;
            const Site to = next(queue[i], d);
            if (left[to] != unreachable) continue;
            left[to] = left[queue[i]] + 1;
            queue.push_back(to);
        }
    }
    return left;
}

}  // namespace waybreaker::lockstep
