// The index of discs in motion: squares of cells, and in each the pieces of paths that lie there, by time.
//
// A leg is cut where its centre leaves a square, so every piece lies in one square and is met once. Who asks looks at
// the squares within reach of where it goes: the cost does not depend on what is elsewhere.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "safe_interval/motion.hpp"
#include "waybreaker/advanced/safe_interval.hpp"

namespace waybreaker::safe_interval {

class TrafficIndex {
  public:
    static constexpr double planning_slack = clearance_slack / 2;

    struct Piece {
        Leg leg;
        double radius = 0;
        std::uint32_t who = 0;
    };

    TrafficIndex(int width, int height, double separation);

    void add(std::uint32_t who, std::span<const Waypoint> path, double radius, bool stays);
    void remove(std::uint32_t who);

    int width() const { return width_; }
    int height() const { return height_; }
    // How near a disc of that radius may come to the piece; a path that is searched for, not quite so near.
    double reach(const Piece& piece, double radius, double slack = planning_slack) const {
        return radius + piece.radius + separation_ - slack;
    }

    // As Traffic::met.
    std::vector<std::uint32_t> met(std::span<const Waypoint> path, double radius, bool stays,
                                   double slack = planning_slack) const;

    // Calls visit(piece) for the pieces that a disc of that radius may meet on the leg, until visit returns false.
    // Looks at each square only while the disc is within reach of it.
    template <class Visit>
    void near(const Leg& leg, double radius, Visit visit) const {
        const double margin = radius + widest_ + separation_;
        const bool moves = leg.velocity.x != 0 || leg.velocity.y != 0;
        const Vector end = moves ? leg.at(leg.to) : leg.start;
        const int top = square(std::min(leg.start.y, end.y) - margin, rows_);
        const int bottom = square(std::max(leg.start.y, end.y) + margin, rows_);
        for (int row = top; row <= bottom; ++row) {
            const Span in_row = within(row, leg.start.y, leg.velocity.y, margin, {leg.from, leg.to}, leg.from);
            if (in_row.to < in_row.from) continue;
            const double a = moves ? leg.at(in_row.from).x : leg.start.x;
            const double b = moves ? leg.at(in_row.to).x : leg.start.x;
            const int left = square(std::min(a, b) - margin, columns_);
            const int right = square(std::max(a, b) + margin, columns_);
            for (int column = left; column <= right; ++column) {
                const Span when = within(column, leg.start.x, leg.velocity.x, margin, in_row, leg.from);
                for (const Piece& piece : squares_[std::size_t(row) * std::size_t(columns_) + std::size_t(column)]) {
                    if (piece.leg.from >= when.to) break;
                    if (piece.leg.to > when.from && !visit(piece)) return;
                }
            }
        }
    }

    // The legs of a path, waits included; the last one for ever if it stays.
    static std::vector<Leg> legs(std::span<const Waypoint> path, bool stays);

  private:
    struct Span {
        double from;
        double to;
    };

    int square(double coordinate, int count) const {
        return std::clamp(int((coordinate + 0.5) * per_cell_), 0, count - 1);
    }
    // The part of a time in which a coordinate that moves since `since` is within the margin of a line of squares.
    Span within(int line, double start, double velocity, double margin, Span time, double since) const {
        if (velocity == 0) return time;
        const double least = line * double(side_) - 0.5 - margin;
        const double one = since + (least - start) / velocity;
        const double other = since + (least + side_ + 2 * margin - start) / velocity;
        return {std::max(time.from, std::min(one, other)), std::min(time.to, std::max(one, other))};
    }
    void add_leg(std::uint32_t who, const Leg& leg, double radius, std::vector<std::uint32_t>& squares);
    void add_piece(const Piece& piece, std::vector<std::uint32_t>& squares);

    int width_;
    int height_;
    int side_;  // of a square, in cells
    double per_cell_;
    int columns_;
    int rows_;
    double separation_;
    double widest_ = 0;  // radius of all that were ever added
    std::vector<std::vector<Piece>> squares_;
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> squares_of_;  // by who, each once
};

}  // namespace waybreaker::safe_interval
