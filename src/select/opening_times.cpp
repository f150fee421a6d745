#include "select/opening_times.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "flight/target.hpp"

namespace waybreaker {
namespace {

constexpr std::size_t most_toured = 8;  // obstacles

bool may_matter(const Task& task) {
    if (task.rules.timing == Timing::ignore) return false;
    if (task.flyer.start != task.driver.start || task.flyer.speed < task.driver.speed) return true;
    return std::ranges::any_of(task.map.obstacles(),
                               [&](const Obstacle& o) { return task.rules.breach_time.of(o) > 0; });
}

}  // namespace

double hop(const Box& a, const Box& b) {
    const int x = std::max({a.min.x - b.max.x - 2, b.min.x - a.max.x - 2, 0});
    const int y = std::max({a.min.y - b.max.y - 2, b.min.y - a.max.y - 2, 0});
    return std::sqrt(double(x) * x + double(y) * y);
}

OpeningTimes::OpeningTimes(const Task& task) : task_(task), matter_(may_matter(task)) {}

OpeningTimes OpeningTimes::at_once(const Task& task) {
    OpeningTimes times(task);
    times.matter_ = false;
    times.at_once_ = true;
    return times;
}

double OpeningTimes::cells(std::span<const ObstacleId> obstacles) {
    return task_.cells_until(times(obstacles).open);
}

double OpeningTimes::flight_cells(std::span<const ObstacleId> obstacles) {
    const double done = obstacles.empty() ? task_.least_flight : std::max(times(obstacles).done, task_.least_flight);
    const bool adds = task_.rules.objective == Objective::flowtime;
    return adds ? done * task_.driver.speed : task_.cells_until(done);
}

const OpeningTimes::Times& OpeningTimes::times(std::span<const ObstacleId> obstacles) {
    const auto [found, added] = times_.try_emplace({obstacles.begin(), obstacles.end()});
    if (added) found->second = times_of(obstacles);
    return found->second;
}

const OpeningTimes::Legs& OpeningTimes::legs(ObstacleId id) {
    const auto [found, added] = legs_.try_emplace(id, Legs{infinity, infinity, infinity});
    if (!added) return found->second;
    Legs& legs = found->second;
    const std::vector<Target> target = targets_of(task_.map, std::span(&id, 1));
    for (const Cell c : target.front().cells) {
        const double first = distance(task_.flyer.start, c);
        const double last = distance(c, task_.flyer.goal);
        legs.first = std::min(legs.first, first);
        legs.last = std::min(legs.last, last);
        legs.whole = std::min(legs.whole, first + last);
    }
    return legs;
}

OpeningTimes::Times OpeningTimes::times_of(std::span<const ObstacleId> obstacles) {
    double stays = 0;
    double open = 0;
    double done = 0;
    for (const ObstacleId id : obstacles) {
        stays += task_.rules.breach_time.of(task_.map.obstacle(id));
        open = std::max(open, legs(id).first);
        done = std::max(done, legs(id).whole);
    }
    const std::span<const ObstacleId> toured = obstacles.first(std::min(obstacles.size(), most_toured));
    const std::size_t count = toured.size();
    if (count > 1) {
        // The shortest way through each subset that ends at each of its members (Held and Karp 1962).
        const std::uint32_t all = (1U << count) - 1;
        std::vector<double> lengths((std::size_t{all} + 1) * count, infinity);
        for (std::size_t i = 0; i < count; ++i) lengths[(std::size_t{1} << i) * count + i] = legs(toured[i]).first;
        for (std::uint32_t set = 1; set <= all; ++set) {
            for (std::size_t last = 0; last < count; ++last) {
                const double length = lengths[set * count + last];
                for (std::size_t next = 0; next < count; ++next) {
                    if ((set >> next & 1U) != 0 || std::isinf(length)) continue;
                    double& longer = lengths[(set | 1U << next) * count + next];
                    longer = std::min(longer, length + hop(task_.map.obstacle(toured[last]).bounds,
                                                           task_.map.obstacle(toured[next]).bounds));
                }
            }
        }
        double shortest = infinity;
        double home = infinity;
        for (std::size_t i = 0; i < count; ++i) {
            shortest = std::min(shortest, lengths[all * count + i]);
            home = std::min(home, lengths[all * count + i] + legs(toured[i]).last);
        }
        open = std::max(open, shortest);
        done = std::max(done, home);
    }
    return {open / task_.flyer.speed + stays, done / task_.flyer.speed + stays};
}

}  // namespace waybreaker
