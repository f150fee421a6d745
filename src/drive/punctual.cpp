#include "drive/punctual.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "map/line_of_sight.hpp"
#include "model/rubble.hpp"
#include "model/timeline.hpp"

namespace waybreaker {
namespace {

constexpr int farthest_bent = 3;             // cells from where the bend was, or from the path
constexpr int most_bends = 16;               // one after the other
constexpr double least_gain_in_time = 1e-9;  // relative

// The segment on which it is after so many cells, and the cell that is nearest then.
struct Place {
    std::size_t segment = 0;
    Cell at;
};

Place place_after(const std::vector<Cell>& path, double length) {
    std::size_t segment = 0;
    while (segment + 2 < path.size() && distance(path[segment], path[segment + 1]) < length) {
        length -= distance(path[segment], path[segment + 1]);
        ++segment;
    }
    const Cell from = path[segment];
    const Cell to = path[segment + 1];
    const double share = std::min(length / distance(from, to), 1.0);
    return {segment,
            {int(std::lround(from.x + share * (to.x - from.x))), int(std::lround(from.y + share * (to.y - from.y)))}};
}

class Bending {
  public:
    Bending(const OpenedMap& map, const Agent& agent, std::vector<Cell> path, std::vector<TimedOpening> openings,
            double rubble)
        : map_(map),
          agent_(agent),
          openings_(std::move(openings)),
          rubble_(rubble),
          sight_(map, agent.body),
          path_(std::move(path)) {}

    PunctualPath run() && {
        best_ = drive(path_, std::numeric_limits<double>::infinity());
        for (int round = 0; round < most_bends && best_.waits_after && path_.size() > 1; ++round) {
            const std::vector<Cell> path = path_;
            const Place place = place_after(path, *best_.waits_after * agent_.speed);
            const std::size_t first = place.segment;
            if (first > 0) bend(path, first - 1, path[first], first + 1);
            if (first + 2 < path.size()) bend(path, first, path[first + 1], first + 2);
            bend(path, first, place.at, first + 1);
            if (path_ == path) break;
        }
        return {std::move(path_), judged_};
    }

  private:
    // When the agent arrives on a path, waits included; and how long it drives before it has to wait, if it has to.
    struct Drive {
        double arrival = 0;
        std::optional<double> waits_after = std::nullopt;
    };

    // No need to be exact about a path on which it arrives no earlier than that.
    Drive drive(const std::vector<Cell>& path, double arrive_before) {
        const std::vector<Waypoint> driven = timed_through(map_.map(), std::vector<Point>(path.begin(), path.end()),
                                                           agent_.body, agent_.speed, 0, {map_.removed(), rubble_});
        Drive found{agent_.ready_at + driven.back().t};
        if (found.arrival >= arrive_before) return found;
        ++judged_;
        double delay = 0;
        for (TimedOpening& opening : openings_) {
            const auto after = first_touch(map_.map(), opening.obstacle, driven, standing_radius(agent_.body));
            if (!after) continue;
            const double wait = opening.at + rubble_ - agent_.ready_at - *after;
            if (wait <= delay) continue;
            delay = wait;
            found = {agent_.ready_at + driven.back().t + delay, after};
            // Tries the obstacle that it waited for last first: most paths wait for that again.
            std::swap(openings_.front(), opening);
            if (found.arrival >= arrive_before) break;
        }
        return found;
    }

    // Bends at a cell around that one, between two places of a path.
    void bend(const std::vector<Cell>& path, std::size_t before, Cell middle, std::size_t after) {
        for (int dy = -farthest_bent; dy <= farthest_bent; ++dy) {
            for (int dx = -farthest_bent; dx <= farthest_bent; ++dx) {
                const Cell c{middle.x + dx, middle.y + dy};
                if (!map_.map().grid().contains(c) || c == path[before] || c == path[after] || !sight_.fits(c))
                    continue;
                if (!sight_.clear(path[before], c) || !sight_.clear(c, path[after])) continue;
                std::vector<Cell> bent(path.begin(), path.begin() + std::ptrdiff_t(before) + 1);
                bent.push_back(c);
                bent.insert(bent.end(), path.begin() + std::ptrdiff_t(after), path.end());
                consider(std::move(bent));
            }
        }
    }

    void consider(std::vector<Cell> path) {
        const double enough = best_.arrival * (1 - least_gain_in_time);
        const Drive driven = drive(path, enough);
        if (!(driven.arrival < enough)) return;
        best_ = driven;
        path_ = std::move(path);
    }

    const OpenedMap& map_;
    const Agent& agent_;
    std::vector<TimedOpening> openings_;
    double rubble_;
    LineOfSight sight_;
    std::vector<Cell> path_;
    Drive best_;
    std::uint64_t judged_ = 0;
};

}  // namespace

PunctualPath punctual(const OpenedMap& map, const Agent& agent, std::vector<Cell> path,
                      std::vector<TimedOpening> openings, double rubble) {
    return Bending(map, agent, std::move(path), std::move(openings), rubble).run();
}

}  // namespace waybreaker
