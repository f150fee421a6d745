// Alternates between better cells for the given order and a better order for the given cells (2-opt: Croes 1958;
// Or-opt: Or 1976) until neither helps.
#include "flight/local_search.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace waybreaker {
namespace {

class LocalSearch {
  public:
    LocalSearch(Point start, Tour tour, Point goal, std::span<const Target> targets, const Airspace& air)
        : start_(start), tour_(std::move(tour)), goal_(goal), air_(air) {
        // Only cells that a shorter tour could visit, were each its only stop.
        const double length = tour_length(start, tour_, goal, air);
        for (const Target& target : targets) {
            std::vector<Cell>& cells = cells_.emplace_back();
            std::ranges::copy_if(target.cells, std::back_inserter(cells),
                                 [&](Cell c) { return air_.length(start, c) + air_.length(c, goal) <= length; });
        }
    }

    Tour run() {
        while (better_cells() || reverse_parts() || move_parts()) {
        }
        return std::move(tour_);
    }

  private:
    // Where the air agent is at the i-th stop; start and goal are the stops before the first and after the last.
    Point at(std::size_t i) const { return i < tour_.size() ? Point(tour_[i].at) : goal_; }
    Point before(std::size_t i) const { return i > 0 ? Point(tour_[i - 1].at) : start_; }

    bool better_cells() {
        bool better = false;
        for (std::size_t i = 0; i < tour_.size(); ++i) {
            const Point from = before(i);
            const Point to = at(i + 1);
            double least = air_.length(from, at(i)) + air_.length(at(i), to) - least_gain;
            for (const Cell c : cells_[tour_[i].target]) {
                const double length = air_.length(from, c) + air_.length(c, to);
                if (length >= least) continue;
                least = length;
                tour_[i].at = c;
                better = true;
            }
        }
        return better;
    }

    // 2-opt: flies the stops first..last the other way round.
    bool reverse_parts() {
        bool better = false;
        for (std::size_t first = 0; first < tour_.size(); ++first) {
            for (std::size_t last = first + 1; last < tour_.size(); ++last) {
                const Point from = before(first);
                const Point to = at(last + 1);
                const double gain = air_.length(from, at(first)) + air_.length(at(last), to) -
                                    air_.length(from, at(last)) - air_.length(at(first), to);
                if (!(gain > least_gain)) continue;  // nor where both ways are none: no number
                std::reverse(stop(first), stop(last + 1));
                better = true;
            }
        }
        return better;
    }

    // Or-opt: takes one to three stops out and puts them between two others, either way round.
    bool move_parts() {
        bool better = false;
        for (std::size_t stops = 1; stops <= 3; ++stops) {
            for (std::size_t first = 0; first + stops < tour_.size() + 1; ++first) {
                for (std::size_t place = 0; place <= tour_.size(); ++place) {
                    if (place < first || place > first + stops) better = move_part(first, stops, place) || better;
                }
            }
        }
        return better;
    }
    // Moves the part before the stop that is now at `place`, if that gains.
    bool move_part(std::size_t first, std::size_t stops, std::size_t place) {
        const Point head = at(first);
        const Point tail = at(first + stops - 1);
        const Point from = before(place);
        const Point to = at(place);
        const double closed = air_.length(before(first), head) + air_.length(tail, at(first + stops)) -
                              air_.length(before(first), at(first + stops)) + air_.length(from, to);
        const double forward = air_.length(from, head) + air_.length(tail, to);
        const double backward = air_.length(from, tail) + air_.length(head, to);
        if (!(closed - std::min(forward, backward) > least_gain)) return false;
        if (backward < forward) std::reverse(stop(first), stop(first + stops));
        if (place < first) {
            std::rotate(stop(place), stop(first), stop(first + stops));
        } else {
            std::rotate(stop(first), stop(first + stops), stop(place));
        }
        return true;
    }

    Tour::iterator stop(std::size_t i) { return tour_.begin() + std::ptrdiff_t(i); }

    Point start_;
    Tour tour_;
    Point goal_;
    const Airspace& air_;
    std::vector<std::vector<Cell>> cells_;  // by target
};

}  // namespace

Tour improved_tour(Point start, Tour tour, Point goal, std::span<const Target> targets, const Airspace& air) {
    return LocalSearch(start, std::move(tour), goal, targets, air).run();
}

}  // namespace waybreaker
