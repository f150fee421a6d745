// Trail: where an agent really was, and whether that was legal. By geometry of its own: bodies are held against cells
// and against each other one by one, piece by piece.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::rehearsal {

// What overlaps by less touches, in cells.
inline constexpr double touching = 1e-6;

// Straight and at one speed, or a stand.
struct Piece {
    Waypoint from;
    Waypoint to;
    Point at(double time) const;
};

struct Trail {
    std::string agent;
    AgentKind kind = AgentKind::ground;
    double radius = 0;               // of its disc, in cells; 0: a point
    std::vector<Piece> pieces = {};  // without gaps, in order
    // It goes on to there, or stands until then.
    void add(Point at, double time);
};

// The share of the way from a to b at which a body first comes to overlap the obstacle, a little before it; empty if it
// never does. Time O(length * radius).
std::optional<double> first_overlap(const Map& map, ObstacleId obstacle, Point a, Point b, double radius);

// Whether a body is nearer to a cell than it may be.
bool overlaps(Cell cell, Point at, double radius);

// What became of the map.
struct Events {
    std::vector<TimedOpening> opened = {};
    struct Rubble {
        std::vector<Cell> cells;
        double since;
    };
    std::vector<Rubble> rubble = {};
};

// What was illegal: vehicles in an obstacle that stands, and pairs of them that overlapped at some time, one line each.
// Those whose trail ends stand there for ever if they `stay`. Without a separation they may be anywhere at once.
std::vector<std::string> faults_of(const Map& map, const Events& events, std::span<const Trail> vehicles,
                                   const std::optional<double>& separation, bool stay);

}  // namespace waybreaker::rehearsal
