#include "crossing/regions.hpp"

#include <cmath>
#include <map>
#include <utility>

#include "crossing/lattice.hpp"

namespace waybreaker::crossing {
namespace {

constexpr std::int64_t unit = 1000;  // a radius is exact to thousandths of a cell

// The cells around a blocked one where the body cannot be, as half widths of rows. Of the square: where the disc around
// a cell's centre meets the blocked cell. Relaxed: cells that lie in the disc's way as a whole.
std::vector<int> growth_of(const CrossingOptions& options) {
    const std::int64_t radius = std::llround(options.body.reach() * double(unit));
    const bool whole = reach_of(options) == 1;
    const auto holds = [&](std::int64_t x, std::int64_t y) {
        if (whole) return (x * x + y * y) * unit * unit <= radius * radius;
        const std::int64_t gap_x = std::max<std::int64_t>(2 * x - 1, 0);
        const std::int64_t gap_y = std::max<std::int64_t>(2 * y - 1, 0);
        return (gap_x * gap_x + gap_y * gap_y) * unit * unit < 4 * radius * radius;
    };
    std::vector<int> half_widths;
    for (int y = 0; y == 0 || holds(0, y); ++y) {
        int x = 0;
        while (holds(x + 1, y)) ++x;
        half_widths.push_back(x);
    }
    if (half_widths.size() == 1 && half_widths.front() == 0) half_widths.clear();  // the cell itself
    return half_widths;
}

// Blocked cells side by side that belong to one obstacle.
struct Run {
    int first;
    int last;
    std::uint32_t obstacle;
};

std::vector<std::vector<Run>> runs_of(const Map& map) {
    std::vector<std::vector<Run>> rows(std::size_t(map.height()));
    for (int y = 0; y < map.height(); ++y) {
        std::vector<Run>& row = rows[std::size_t(y)];
        for (int x = 0; x < map.width(); ++x) {
            const std::uint32_t obstacle = map.obstacle_at({x, y}).value;
            if (obstacle == 0) continue;
            if (!row.empty() && row.back().last == x - 1 && row.back().obstacle == obstacle) {
                row.back().last = x;
            } else {
                row.push_back({x, x, obstacle});
            }
        }
    }
    return rows;
}

// Where an obstacle's growth begins or ends in a row.
struct Event {
    int x;
    bool begins;
    std::uint32_t obstacle;
};

}  // namespace

Regions::Regions(const Map& map, const CrossingOptions& options)
    : identity_(map.identity()), body_(options.body), relaxed_(options.relaxed), half_widths_(growth_of(options)) {
    if (half_widths_.empty()) {
        original_ = &map;
    } else {
        margin_ = half_widths_.front();
        grow(map);
    }
}

// Row by row: the growths that reach into it begin and end one after the other.
void Regions::grow(const Map& map) {
    const int width = map.width();
    const int height = map.height();
    const auto edge = std::uint32_t(map.obstacles().size() + 1);
    const int reach = int(half_widths_.size()) - 1;
    const std::vector<std::vector<Run>> rows = runs_of(map);

    std::vector<std::vector<std::uint32_t>> regions_of(edge + 1);
    std::map<std::vector<std::uint32_t>, std::uint32_t> numbers;
    const auto number_of = [&](const std::vector<std::uint32_t>& obstacles) {
        const auto [known, added] = numbers.try_emplace(obstacles, std::uint32_t(numbers.size() + 1));
        if (!added) return known->second;
        members_.add(obstacles);
        for (const std::uint32_t obstacle : obstacles) regions_of[obstacle].push_back(known->second);
        return known->second;
    };

    std::vector<std::uint32_t> labels(std::size_t(width) * std::size_t(height), 0);
    std::vector<Event> events;
    std::vector<std::pair<std::uint32_t, int>> around;  // obstacles whose growth has begun, sorted, and how often
    std::vector<std::uint32_t> obstacles;
    for (int y = 0; y < height; ++y) {
        events.clear();
        const auto add = [&](int first, int last, std::uint32_t obstacle) {
            events.push_back({std::max(first, 0), true, obstacle});
            events.push_back({std::min(last + 1, width), false, obstacle});
        };
        for (int row = std::max(y - reach, 0); row <= std::min(y + reach, height - 1); ++row) {
            const int beside = half_widths_[std::size_t(std::abs(row - y))];
            for (const Run& run : rows[std::size_t(row)]) add(run.first - beside, run.last + beside, run.obstacle);
        }
        if (std::min(y, height - 1 - y) < reach) add(0, width - 1, edge);
        add(0, margin_ - 1, edge);
        add(width - margin_, width - 1, edge);
        std::ranges::sort(events, {}, &Event::x);
        for (std::size_t i = 0; i < events.size(); ++i) {
            const Event& event = events[i];
            const auto at = std::ranges::lower_bound(around, event.obstacle, {}, &std::pair<std::uint32_t, int>::first);
            const bool known = at != around.end() && at->first == event.obstacle;
            const int step = event.begins ? 1 : -1;
            if (!known) {
                around.insert(at, {event.obstacle, step});
            } else if (at->second + step == 0) {
                around.erase(at);
            } else {
                at->second += step;
            }
            if (i + 1 == events.size() || events[i + 1].x == event.x || around.empty()) continue;
            obstacles.clear();
            for (const auto& [obstacle, times] : around) obstacles.push_back(obstacle);
            const auto row = labels.begin() + std::ptrdiff_t(y) * width;
            std::fill(row + event.x, row + events[i + 1].x, number_of(obstacles));
        }
    }
    for (std::uint32_t obstacle = 1; obstacle <= edge; ++obstacle) regions_.add(regions_of[obstacle]);
    // Both number what they find row by row.
    grown_from_.assign(map.obstacles().begin(), map.obstacles().end());
    grown_ = Map::from_labels(width, height, std::move(labels));
}

}  // namespace waybreaker::crossing
