#include "select/shortcuts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace waybreaker {
namespace {

constexpr int most_places = 128;  // beside the turns
constexpr int most_removals = 32;
constexpr double slack = 1e-6;

Point between(Point a, Point b, double share) {
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

// The turns, and places in between, not too far from each other.
std::vector<Point> places_of(std::span<const Point> path) {
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i) length += distance(path[i - 1], path[i]);
    const double density = std::min(most_places / length, 1.0);
    std::vector<Point> places{path.front()};
    for (std::size_t i = 1; i < path.size(); ++i) {
        const int parts = int(distance(path[i - 1], path[i]) * density) + 1;
        for (int part = 1; part <= parts; ++part) places.push_back(between(path[i - 1], path[i], double(part) / parts));
    }
    return places;
}

class Shortcuts {
  public:
    Shortcuts(const Task& task, std::span<const Point> path)
        : task_(task),
          places_(places_of(path)),
          most_(std::size_t(std::min(task.rules.removals, most_removals))),
          protected_(task.rules.protect) {
        std::sort(protected_.begin(), protected_.end());
    }

    std::vector<ObstacleId> chosen() {
        ways_.assign(places_.size(), std::vector<Way>(most_ + 1));
        ways_.front().front().length = 0;
        shortest_.assign(places_.size() * (most_ + 1), std::numeric_limits<double>::infinity());
        for (std::size_t to = 1; to < places_.size(); ++to) {
            if (task_.deadline.passed()) return {};  // a path may have any number of turns
            for (std::size_t from = 0; from < to; ++from) extend(from, to);
        }
        return crossed_on(*std::ranges::min_element(ways_.back(), {}, &Way::length));
    }

  private:
    // The shortest way found to a place with so many obstacles crossed.
    struct Way {
        double length = std::numeric_limits<double>::infinity();
        double weight = 0;
        std::size_t from = 0;  // the place before, and how many were crossed up to there
        std::size_t count = 0;
        std::vector<ObstacleId> crossed;  // since then
    };

    void extend(std::size_t from, std::size_t to) {
        const double step = distance(places_[from], places_[to]);
        const std::optional<std::size_t> most = most_crossed(from, to, step);
        if (!most) return;
        std::vector<ObstacleId> crossed;
        if (from + 1 < to) {
            std::optional<std::vector<ObstacleId>> met = in_the_way(places_[from], places_[to], *most);
            if (!met) return;
            crossed = std::move(*met);
        }
        double weight = 0;
        for (const ObstacleId id : crossed) weight += task_.map.obstacle(id).weight;
        for (std::size_t count = 0; count + crossed.size() <= most_; ++count) {
            const Way& way = ways_[from][count];
            if (!gains(way.length + step, to, count + crossed.size())) continue;
            if (way.weight + weight > task_.rules.budget) continue;
            keep(to, count + crossed.size(), {way.length + step, way.weight + weight, from, count, crossed});
        }
    }

    // How many obstacles there may be on a step at most that is to gain anything; none if nothing is gained without
    // any.
    std::optional<std::size_t> most_crossed(std::size_t from, std::size_t to, double step) const {
        std::size_t gaining = 0;  // numbers, from none upwards
        for (std::size_t count = 0; count <= most_; ++count) {
            while (count + gaining <= most_ && gains(ways_[from][count].length + step, to, count + gaining)) ++gaining;
        }
        if (gaining == 0) return std::nullopt;
        return gaining - 1;
    }

    bool gains(double length, std::size_t to, std::size_t count) const { return length < shortest(to, count) - slack; }

    void keep(std::size_t place, std::size_t count, Way way) {
        for (std::size_t most = count; most <= most_; ++most) {
            double& shortest = shortest_[place * (most_ + 1) + most];
            shortest = std::min(shortest, way.length);
        }
        ways_[place][count] = std::move(way);
    }

    // The length of the shortest way found to a place with at most so many obstacles crossed.
    double shortest(std::size_t place, std::size_t count) const { return shortest_[place * (most_ + 1) + count]; }

    // What the agent would meet on a straight line; none if that is more than `most`, or must stay.
    std::optional<std::vector<ObstacleId>> in_the_way(Point a, Point b, std::size_t most) const {
        std::vector<ObstacleId> met;
        const int steps = int(distance(a, b)) + 1;
        const double reach = 0.5 + task_.driver.body.reach() - slack;
        for (int i = 0; i <= steps; ++i) {
            const Point at = between(a, b, double(i) / steps);
            for (Cell c{0, int(std::ceil(at.y - reach))}; c.y <= at.y + reach; ++c.y) {
                for (c.x = int(std::ceil(at.x - reach)); c.x <= at.x + reach; ++c.x) {
                    if (!task_.map.grid().blocked(c)) continue;
                    if (!task_.map.grid().contains(c)) return std::nullopt;
                    const ObstacleId id = task_.map.obstacle_at(c);
                    if (std::ranges::find(met, id) != met.end()) continue;
                    if (met.size() == most || !removable(id)) return std::nullopt;
                    met.push_back(id);
                }
            }
        }
        return met;
    }

    bool removable(ObstacleId id) const {
        return task_.map.obstacle(id).destructible && !std::binary_search(protected_.begin(), protected_.end(), id);
    }

    std::vector<ObstacleId> crossed_on(const Way& last) const {
        std::vector<ObstacleId> crossed;
        for (const Way* way = &last; way->length > 0; way = &ways_[way->from][way->count]) {
            crossed.insert(crossed.end(), way->crossed.begin(), way->crossed.end());
        }
        std::sort(crossed.begin(), crossed.end());
        crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
        return crossed;
    }

    const Task& task_;
    std::vector<Point> places_;
    std::size_t most_;
    std::vector<ObstacleId> protected_;
    std::vector<std::vector<Way>> ways_;  // by place and by number of obstacles crossed
    std::vector<double> shortest_;        // likewise, in one row: with at most so many crossed
};

}  // namespace

std::vector<ObstacleId> chosen_by_shortcuts(const Task& task, std::span<const Point> path) {
    if (path.size() < 3) return {};
    return Shortcuts(task, path).chosen();
}

}  // namespace waybreaker
