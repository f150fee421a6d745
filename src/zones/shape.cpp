#include "zones/shape.hpp"

#include <algorithm>

namespace waybreaker::zones {
namespace {

Ring ring_of(const std::vector<Point>& corners) {
    Ring ring;
    for (const Point p : corners) {
        const Spot spot = spot_of(p);
        if (ring.empty() || ring.back() != spot) ring.push_back(spot);
    }
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring;
}

// Which way round a ring goes: above 0 with its inside on the left. Its least corner is one of its convex ones.
int direction(const Ring& ring) {
    const std::size_t count = ring.size();
    const std::size_t least = std::size_t(std::ranges::min_element(ring) - ring.begin());
    return sign(turn(ring[(least + count - 1) % count], ring[least], ring[(least + 1) % count]));
}

}  // namespace

const Edge* Shape::edge_at(Spot at) const {
    const auto found = std::ranges::find_if(edges, [at](const Edge& edge) { return is_on(edge.from, edge.to, at); });
    return found == edges.end() ? nullptr : &*found;
}

// Whether a ray from it to the right crosses an odd number of edges.
bool Shape::holds(Spot at) const {
    bool odd = false;
    for (const Edge& edge : edges) {
        const bool rises = edge.from.y <= at.y && at.y < edge.to.y;
        const bool falls = edge.to.y <= at.y && at.y < edge.from.y;
        if (!rises && !falls) continue;
        if ((turn(edge.from, edge.to, at) > 0) == rises) odd = !odd;
    }
    return odd;
}

Shape shape_of(const Zone& zone) {
    Shape shape;
    for (const std::vector<Point>& corners : zone.polygon) {
        Ring ring = ring_of(corners);
        const int wanted = shape.rings.empty() ? 1 : -1;
        if (ring.size() > 2 && direction(ring) == -wanted) std::ranges::reverse(ring);
        shape.rings.push_back(std::move(ring));
    }
    if (shape.rings.empty() || shape.rings.front().empty()) return shape;
    shape.least = shape.most = shape.rings.front().front();
    for (const Ring& ring : shape.rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            shape.edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
            shape.least = {std::min(shape.least.x, ring[i].x), std::min(shape.least.y, ring[i].y)};
            shape.most = {std::max(shape.most.x, ring[i].x), std::max(shape.most.y, ring[i].y)};
        }
    }
    return shape;
}

}  // namespace waybreaker::zones
