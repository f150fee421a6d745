#include "drive/fitted.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <unordered_set>

#include "drive/shortened.hpp"
#include "map/line_of_sight.hpp"
#include "model/timeline.hpp"

namespace waybreaker {
namespace {

// Cells that a bend may lie beside the guide: at its bends, and along it. Where the guide runs between two rows of
// cells, only a long slanted piece passes a narrow door, so bends far from the guide's may be needed as well.
struct Beside {
    int bend;
    int line;  // 0: none
};
constexpr Beside quickly{2, 0};
constexpr Beside thoroughly{4, 3};
constexpr double few = 4;               // cells
constexpr double first_along = 1;       // cells from a bend; then twice as far each time
constexpr std::size_t most_passed = 3;  // bends of the guide, on one piece
constexpr int most_checked = 1500;      // pieces; ten times as many thoroughly

// A* over the cells near the guide. Whether a piece is clear is looked at when its turn comes (Lazy Theta*, Nash,
// Koenig, Tovey, 2010).
class Fitting {
  public:
    Fitting(const OpenedMap& map, const Body& body, std::span<const Point> guide, Beside beside)
        : map_(map), sight_(map, body), goal_(cell_of(guide.back())), beside_(beside) {
        double left = path_length(guide);
        for (std::size_t i = 0; i + 1 < guide.size(); ++i) {
            add_spots(guide, i, left);
            left -= distance(guide[i], guide[i + 1]);
        }
        add_around(guide.back(), guide.size() - 1, 0, 0);
        from_start_ = !spots_.empty() && spots_.front().at == cell_of(guide.front());
    }

    std::vector<Point> run(double shorter_than) {
        if (!from_start_) return {};
        push(0, 0, 0, shorter_than);
        for (int checked = 0; !open_.empty() && checked < most_checked_;) {
            const Piece piece = open_.top();
            open_.pop();
            Spot& spot = spots_[piece.to];
            if (spot.settled) continue;
            ++checked;
            if (piece.to != piece.from && !sight_.clear(spots_[piece.from].at, spot.at)) continue;
            spot.settled = true;
            spot.parent = piece.from;
            spot.length = piece.length;
            if (spot.at == goal_) return path_to(piece.to);
            for (std::uint32_t to = first_of_[spot.bend]; to < end_of(spot.bend + most_passed); ++to) {
                push(piece.to, to, spot.length + distance(spot.at, spots_[to].at), shorter_than);
            }
        }
        return {};
    }

  private:
    struct Spot {
        Cell at;
        std::size_t bend = 0;  // of the guide, the last one before it
        double left = 0;       // to the goal, at least
        bool settled = false;
        std::uint32_t parent = 0;
        double length = 0;
    };
    struct Piece {
        double estimate;
        double length;  // of the path that ends with it
        std::uint32_t from;
        std::uint32_t to;
        bool operator<(const Piece& other) const {
            if (estimate != other.estimate) return estimate > other.estimate;
            return to != other.to ? to > other.to : from > other.from;
        }
    };

    void add_spots(std::span<const Point> guide, std::size_t bend, double left) {
        const Point a = guide[bend];
        const Point b = guide[bend + 1];
        const double length = distance(a, b);
        first_of_.push_back(std::uint32_t(spots_.size()));
        // The start itself comes first; no other place is as near to it.
        add_around(a, bend, bend == 0 ? 0 : beside_.bend, left);
        const auto at = [&](double along) {
            const double share = along / length;
            return Point{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
        };
        for (double along = first_along; beside_.line > 0 && along <= length / 2; along *= 2) {
            const int beside = along < few ? beside_.bend : beside_.line;
            add_around(at(along), bend, beside, left - along);
            add_around(at(length - along), bend, beside, left - length + along);
        }
    }

    // `left`: of the guide, from there on.
    void add_around(Point p, std::size_t bend, int beside, double left) {
        if (first_of_.size() <= bend) first_of_.push_back(std::uint32_t(spots_.size()));
        const Cell middle = cell_of(p);
        for (int dy = -beside; dy <= beside; ++dy) {
            for (int dx = -beside; dx <= beside; ++dx) {
                const Cell c{middle.x + dx, middle.y + dy};
                if (!map_.map().grid().contains(c) || !sight_.fits(c)) continue;
                const std::uint64_t key = std::uint64_t(std::uint32_t(c.x)) << 32U | std::uint32_t(c.y);
                if (!known_.insert(key).second) continue;
                // The guide is a shortest path of the point.
                const double least = std::max(distance(c, goal_), left - distance(Point(c), p));
                spots_.push_back({.at = c, .bend = bend, .left = least});
            }
        }
    }

    std::uint32_t end_of(std::size_t bend) const {
        return bend + 1 < first_of_.size() ? first_of_[bend + 1] : std::uint32_t(spots_.size());
    }

    void push(std::uint32_t from, std::uint32_t to, double length, double shorter_than) {
        if (spots_[to].settled) return;
        const double estimate = length + spots_[to].left;
        if (estimate < shorter_than) open_.push({estimate, length, from, to});
    }

    std::vector<Point> path_to(std::uint32_t spot) const {
        std::vector<Point> path{Point(spots_[spot].at)};
        for (; spot != 0; spot = spots_[spot].parent) path.emplace_back(spots_[spots_[spot].parent].at);
        std::ranges::reverse(path);
        return path;
    }

    const OpenedMap& map_;
    LineOfSight sight_;
    Cell goal_;
    Beside beside_;
    int most_checked_ = most_checked * (beside_.line > 0 ? 10 : 1);
    std::vector<Spot> spots_;                  // in the order of the guide
    std::vector<std::uint32_t> first_of_;      // spots, by bend of the guide
    std::unordered_set<std::uint64_t> known_;  // cells
    std::priority_queue<Piece> open_;
    bool from_start_ = false;
};

}  // namespace

std::vector<Point> fitted(const OpenedMap& map, const Body& body, std::span<const Point> guide, double shorter_than,
                          bool thorough) {
    if (guide.size() < 2) return {};
    std::vector<Point> path = Fitting(map, body, guide, quickly).run(shorter_than);
    if (path.empty() && thorough) path = Fitting(map, body, guide, thoroughly).run(shorter_than);
    return path;
}

}  // namespace waybreaker
