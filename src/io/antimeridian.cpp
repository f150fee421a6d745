#include "io/antimeridian.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace waybreaker::io {
namespace {

constexpr double seam = 180;
constexpr double full_turn = 360;

bool crosses(const LonLat& a, const LonLat& b) {
    return std::abs(a[0] - b[0]) > seam;
}

// Longitudes from 0 to 360, in which the seam is no seam.
double continuous(double longitude) {
    return longitude < 0 ? longitude + full_turn : longitude;
}

// How far along a step it meets the seam.
double share_at_seam(const LonLat& from, const LonLat& to) {
    const double begin = continuous(from[0]);
    const double end = continuous(to[0]);
    return begin == end ? 0 : std::clamp((seam - begin) / (end - begin), 0.0, 1.0);
}

double between(double a, double b, double share) {
    return a + (b - a) * share;
}

using Ring = std::vector<LonLat>;

// What a ring does on one side of the seam, from where it comes over it to where it leaves.
using Chain = std::vector<LonLat>;

// One side of the seam, in longitudes of that side.
class Side {
  public:
    explicit Side(bool east) : east_(east) {}

    // A ring that lies on this side alone is whole, and one on the other side leaves nothing.
    void add(const Ring& ring) {
        const std::size_t steps = ring.size() - 1;
        const auto inside = [&](std::size_t i) { return holds(ring[i % steps]); };
        std::optional<std::size_t> entry;
        for (std::size_t i = 0; i < steps && !entry; ++i) {
            if (!inside(i) && inside(i + 1)) entry = i;
        }
        if (!entry) {
            if (inside(0)) whole_.push_back(ring);
            return;
        }
        for (std::size_t k = *entry; k < *entry + steps; ++k) {
            const LonLat& from = ring[k % steps];
            const LonLat& to = ring[(k + 1) % steps];
            const bool was = inside(k);
            const bool is = inside(k + 1);
            if (was != is) {
                if (is) chains_.emplace_back();
                const LonLat cut{east_ ? -seam : seam, between(from[1], to[1], share_at_seam(from, to))};
                chains_.back().push_back(cut);
            }
            if (is) chains_.back().push_back(on_this_side(to));
        }
    }

    // The areas that the chains bound together with the seam, with the holes that lie in them. Empty if chains do not
    // fit, which is so where rings meet each other.
    std::optional<std::vector<LonLatPolygon>> polygons() const {
        const std::optional<std::vector<std::size_t>> next = successors();
        if (!next) return std::nullopt;
        std::vector<LonLatPolygon> found;
        std::vector<bool> done(chains_.size(), false);
        for (std::size_t first = 0; first < chains_.size(); ++first) {
            Ring ring;
            for (std::size_t i = first; !done[i]; i = (*next)[i]) {
                done[i] = true;
                ring.insert(ring.end(), chains_[i].begin(), chains_[i].end());
            }
            if (ring.empty()) continue;
            ring.push_back(ring.front());
            found.push_back({std::move(ring)});
        }
        for (const Ring& hole : whole_) {
            const auto around = std::ranges::find_if(
                found, [&](const LonLatPolygon& polygon) { return contains(polygon.front(), hole.front()); });
            if (around != found.end()) around->push_back(hole);
        }
        return found;
    }

  private:
    bool holds(const LonLat& place) const { return (continuous(place[0]) > seam) == east_; }

    LonLat on_this_side(const LonLat& place) const {
        return {east_ ? continuous(place[0]) - full_turn : continuous(place[0]), place[1]};
    }

    // Along the seam the area lies between the first and the second place where a ring meets it, the third and the
    // fourth, ...: each chain goes on with the one that begins at the other end of such a piece.
    std::optional<std::vector<std::size_t>> successors() const {
        struct End {
            double latitude;
            std::size_t chain;
            bool begins;
        };
        std::vector<End> ends;
        for (std::size_t i = 0; i < chains_.size(); ++i) {
            ends.push_back({chains_[i].front()[1], i, true});
            ends.push_back({chains_[i].back()[1], i, false});
        }
        std::ranges::stable_sort(ends, {}, &End::latitude);
        std::vector<std::size_t> next(chains_.size());
        for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
            const End& a = ends[i];
            const End& b = ends[i + 1];
            if (a.begins == b.begins) return std::nullopt;
            next[a.begins ? b.chain : a.chain] = a.begins ? a.chain : b.chain;
        }
        return next;
    }

    static bool contains(const Ring& ring, const LonLat& place) {
        bool inside = false;
        for (std::size_t i = 1; i < ring.size(); ++i) {
            const LonLat& a = ring[i - 1];
            const LonLat& b = ring[i];
            if ((a[1] > place[1]) == (b[1] > place[1])) continue;
            if (place[0] < between(a[0], b[0], (place[1] - a[1]) / (b[1] - a[1]))) inside = !inside;
        }
        return inside;
    }

    bool east_;
    std::vector<Chain> chains_;
    std::vector<Ring> whole_;
};

}  // namespace

std::vector<TimedLine> cut_line(const TimedLine& line) {
    std::vector<TimedLine> parts(1);
    const auto add = [&](const LonLat& place, double time) {
        parts.back().places.push_back(place);
        parts.back().times.push_back(time);
    };
    for (std::size_t i = 0; i < line.places.size(); ++i) {
        const LonLat& to = line.places[i];
        if (i > 0 && crosses(line.places[i - 1], to)) {
            const LonLat& from = line.places[i - 1];
            const double share = share_at_seam(from, to);
            const double latitude = between(from[1], to[1], share);
            const double time = between(line.times[i - 1], line.times[i], share);
            add({std::copysign(seam, from[0]), latitude}, time);
            parts.emplace_back();
            add({std::copysign(seam, to[0]), latitude}, time);
        }
        add(to, line.times[i]);
    }
    return parts;
}

std::vector<LonLatPolygon> cut_polygon(const LonLatPolygon& polygon) {
    const Ring& outer = polygon.front();
    const auto crossing = std::ranges::adjacent_find(outer, crosses);
    if (crossing == outer.end()) return {polygon};
    std::vector<LonLatPolygon> parts;
    for (const bool east : {false, true}) {
        Side side(east);
        for (const Ring& ring : polygon) side.add(ring);
        const auto found = side.polygons();
        if (!found) return {polygon};
        parts.insert(parts.end(), found->begin(), found->end());
    }
    return parts;
}

}  // namespace waybreaker::io
