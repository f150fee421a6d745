#include "schedule/local_search.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "schedule/rank.hpp"
#include "schedule/tour_times.hpp"

namespace waybreaker {
namespace {

class LocalSearch {
  public:
    LocalSearch(const Course& course, Tour tour, double rounding, const Deadline& deadline)
        : course_(course),
          tour_(std::move(tour)),
          rounding_(rounding),
          deadline_(deadline),
          rank_(rank_of(course_.finish(tour_))) {
        // Only cells that a better tour could visit, were each its only stop.
        const double reach = course_.reach(
            latest_air_finish(course_.task().rules.objective, rank_.first + rounding_, course_.unhindered()));
        for (const Target& target : course_.targets()) {
            std::vector<Cell>& cells = cells_.emplace_back();
            std::ranges::copy_if(target.cells, std::back_inserter(cells), [&](Cell c) {
                return course_.air().length(course_.start(), c) + course_.air().length(c, course_.goal()) <= reach;
            });
        }
    }

    Tour run() {
        while (!deadline_.passed() && (better_cells() || move_stops())) {
        }
        return std::move(tour_);
    }

  private:
    Point at(std::size_t i) const { return i < tour_.size() ? Point(tour_[i].at) : course_.goal(); }
    Point before(std::size_t i) const { return i > 0 ? Point(tour_[i - 1].at) : course_.start(); }
    double flying(Point a, Point b) const { return course_.air().length(a, b) / course_.task().flyer.speed; }
    Rank rank_of(const Finish& finish) const { return rank(course_.task().rules.objective, finish); }

    bool better_cells() {
        bool any = false;
        for (std::size_t i = 0; i < tour_.size(); ++i) any = better_cell(i) || any;
        return any;
    }

    // A new cell for a stop moves the times of all later stops alike, so that each cell is judged in constant time.
    bool better_cell(std::size_t i) {
        const std::size_t target = tour_[i].target;
        const double stay = course_.breaching(target).stay;
        double left = course_.task().flyer.ready_at;  // when the stop before is left
        double here = 0;                              // when this one is left
        double early = 0;                             // the worst lateness of the stops before, and after
        double late = -std::numeric_limits<double>::infinity();
        std::size_t k = 0;
        const auto pass = [&](const Stop& stop, double, double cleared) {
            if (k < i) left = cleared;
            if (k == i) here = cleared;
            double& worst = k < i ? early : late;
            if (k != i) worst = std::max(worst, course_.lateness(stop.target, cleared));
            ++k;
        };
        const double end = fly(
            course_.task().flyer, tour_, [this](std::size_t t) { return course_.breaching(t).stay; }, pass);
        const double onward = flying(at(i), at(i + 1));

        bool found = false;
        for (const Cell c : cells_[target]) {
            const double cleared = left + flying(before(i), c) + stay;
            const double delay = cleared + flying(c, at(i + 1)) - here - onward;
            const double wait = std::max({early, course_.lateness(target, cleared), late + delay});
            const Rank changed = rank_of(finish_of_two(course_.unhindered() + wait, end + delay));
            if (!better(changed, rank_, rounding_)) continue;
            rank_ = changed;
            tour_[i].at = c;
            found = true;
        }
        return found;
    }

    // Takes a stop out and puts it elsewhere, at the same cell.
    bool move_stops() {
        bool any = false;
        for (std::size_t from = 0; from < tour_.size() && !deadline_.passed(); ++from) {
            for (std::size_t to = 0; to < tour_.size(); ++to) {
                if (from == to) continue;
                Tour moved = tour_;
                moved.erase(moved.begin() + std::ptrdiff_t(from));
                moved.insert(moved.begin() + std::ptrdiff_t(to), tour_[from]);
                const Rank changed = rank_of(course_.finish(moved));
                if (!better(changed, rank_, rounding_)) continue;
                rank_ = changed;
                tour_ = std::move(moved);
                any = true;
            }
        }
        return any;
    }

    const Course& course_;
    Tour tour_;
    double rounding_;
    const Deadline& deadline_;
    Rank rank_;
    std::vector<std::vector<Cell>> cells_;  // by target
};

}  // namespace

Tour improved_tour(const Course& course, Tour tour, double rounding, const Deadline& deadline) {
    return LocalSearch(course, std::move(tour), rounding, deadline).run();
}

}  // namespace waybreaker
