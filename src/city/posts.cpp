#include "city/posts.hpp"

#include <algorithm>
#include <map>
#include <memory>

#include "city/bridge_sides.hpp"
#include "city/places.hpp"

namespace waybreaker::city {
namespace {

bool is_post(const GroundPiece& piece) {
    const bool stands = piece.use.layer == GroundLayer::barrier || piece.use.layer == GroundLayer::shut;
    return stands && wkbFlatten(piece.shape->getGeometryType()) == wkbPoint;
}

bool is_way(const GroundPiece& piece) {
    const bool leads = piece.use.layer == GroundLayer::way || piece.use.layer == GroundLayer::underpass;
    return leads && wkbFlatten(piece.shape->getGeometryType()) == wkbLineString;
}

}  // namespace

void widen_posts(std::vector<GroundPiece>& pieces, double cell) {
    std::map<Place, double> reach;  // by post: how far to either side its ways open cells; 0 without any
    for (const GroundPiece& piece : pieces) {
        if (is_post(piece)) reach.emplace(place_at(*piece.shape->toPoint()), 0);
    }
    if (reach.empty()) return;
    for (const GroundPiece& piece : pieces) {
        if (!is_way(piece)) continue;
        const double half = std::max(piece.use.breadth / 2, opened_reach(piece.use.width, cell));
        for (const OGRPoint& point : *piece.shape->toLineString()) {
            const auto post = reach.find(place_at(point));
            if (post != reach.end()) post->second = std::max(post->second, half);
        }
    }
    for (GroundPiece& piece : pieces) {
        if (!is_post(piece)) continue;
        const double half = reach.at(place_at(*piece.shape->toPoint()));
        piece.shape.reset(half > 0 ? piece.shape->Buffer(half, quarter_circle) : nullptr);
    }
    std::erase_if(pieces, [](const GroundPiece& piece) { return !piece.shape; });
}

}  // namespace waybreaker::city
