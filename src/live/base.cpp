#include "live/base.hpp"

#include <algorithm>
#include <cmath>

#include "map/line_of_sight.hpp"
#include "model/timeline.hpp"
#include "waybreaker/advanced/safe_interval.hpp"

namespace waybreaker::live {
namespace {

// Places at which an agent may stop between bends: so many, so far apart, in cells.
constexpr int most_stops = 12;
constexpr double between_stops = 0.5;
// From the path to the centre of the cell where an agent stops, at most, in cells.
constexpr double farthest_aside = 1.5;
// Who comes just when an obstacle opens comes in time, give or take what places between points lose.
constexpr double punctual = 1e-7;
constexpr double grazing = 1e-6;  // cells
// Of bases held against each other, before it is given up.
constexpr std::size_t most_tries = 10'000;

Cell cell_at(const Waypoint& p) {
    return {int(std::lround(p.x)), int(std::lround(p.y))};
}
bool at_centre(const Waypoint& p) {
    const Cell c = cell_at(p);
    return p.x == c.x && p.y == c.y;
}

// It stands at the last point until then.
Base standing_until(Base base, double time) {
    if (base.back().t < time) base.push_back({base.back().x, base.back().y, time});
    return base;
}

// `stays`: at the end of its path.
std::optional<Base> to_next_bend(const Position& position, double decided, bool stays) {
    const std::vector<Waypoint>& ahead = position.ahead;
    for (std::size_t i = position.stands ? 0 : 1; i < ahead.size(); ++i) {
        if (!at_centre(ahead[i])) continue;
        std::size_t last = i;
        while (last + 1 < ahead.size() && same_place(ahead[last + 1], ahead[i])) ++last;
        // It may stay for ever.
        const bool ends = last + 1 == ahead.size() && stays;
        if (ends) return Base(ahead.begin(), ahead.end());
        const bool leaves_before = last + 1 < ahead.size() && ahead[last].t < decided;
        if (!leaves_before) {
            std::size_t end = i + 1;
            while (end <= last && ahead[end].t <= decided) ++end;
            return standing_until({ahead.begin(), ahead.begin() + std::ptrdiff_t(end)}, decided);
        }
        i = last;
    }
    return std::nullopt;
}

// The cells around a place, the nearest first.
std::vector<Cell> cells_around(const Waypoint& p) {
    std::vector<Cell> cells;
    const Cell centre = cell_at(p);
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) cells.push_back({centre.x + dx, centre.y + dy});
    }
    std::ranges::stable_sort(cells, {}, [&](Cell c) { return distance(Point(c), Point(p.x, p.y)); });
    return cells;
}

}  // namespace

std::optional<double> Ground::first_hit(const std::vector<Waypoint>& path, const Body& body) const {
    const double reach = body.reach() + 1;
    Point least{path.front().x, path.front().y};
    Point most = least;
    for (const Waypoint& p : path) {
        least = {std::min(least.x, p.x), std::min(least.y, p.y)};
        most = {std::max(most.x, p.x), std::max(most.y, p.y)};
    }
    // Places between points are rounded: who grazes a wall must not touch it.
    const double radius = std::max(standing_radius(body) - grazing, 0.0);
    // A single point is a stand.
    std::vector<Waypoint> standing = path;
    if (path.size() == 1) standing.push_back(path.front());
    std::optional<double> first;
    for (const Obstacle& obstacle : map.obstacles()) {
        if (obstacle.gone() || obstacle.bounds.min.x > most.x + reach || obstacle.bounds.max.x < least.x - reach ||
            obstacle.bounds.min.y > most.y + reach || obstacle.bounds.max.y < least.y - reach)
            continue;
        const std::optional<double> touched = first_touch(map, obstacle.id, standing, radius);
        if (!touched || (first && *first <= *touched)) continue;
        const auto opens = std::ranges::find(openings, obstacle.id, &TimedOpening::obstacle);
        if (opens == openings.end() || opens->at > *touched + punctual) first = touched;
    }
    return first;
}

std::vector<Base> bases_of(const Ground& ground, const Agent& agent, const Position& position, double decided,
                           std::size_t most) {
    std::vector<Base> bases;
    const auto add = [&](Base base) {
        if (!ground.first_hit(base, agent.body)) bases.push_back(std::move(base));
    };
    const double ready = std::max(decided, agent.ready_at);
    const bool stays = Point(position.ahead.back().x, position.ahead.back().y) == Point(agent.goal);
    if (position.finished()) {
        add(standing_until(position.ahead, ready));
        return bases;
    }
    if (std::optional<Base> base = to_next_bend(position, ready, stays)) add(std::move(*base));
    if (position.stands && ready > decided) return bases;  // it may not leave yet
    if (bases.size() >= most) return bases;
    std::vector<ObstacleId> open;
    for (const TimedOpening& opening : ground.openings) {
        if (opening.at <= decided) open.push_back(opening.obstacle);
    }
    const OpenedMap opened(ground.map, open);
    const LineOfSight sight(opened, agent.body);
    for (int i = 0; i < most_stops; ++i) {
        const double time = decided + i * between_stops / agent.speed;
        if (time > position.ahead.back().t) break;
        const Base way = until(position.ahead, time);
        if (ground.first_hit(way, agent.body)) break;
        for (const Cell cell : cells_around(way.back())) {
            if (!opened.map().grid().contains(cell) || !sight.fits(cell)) continue;
            Base base = way;
            const double driven = distance(Point(way.back().x, way.back().y), Point(cell));
            if (driven > farthest_aside) continue;
            if (driven > 0) base.push_back({double(cell.x), double(cell.y), time + driven / agent.speed});
            add(std::move(base));
            if (bases.size() >= most) return bases;
        }
    }
    return bases;
}

std::vector<Base> first_of(const std::vector<std::vector<Base>>& choices) {
    std::vector<Base> first;
    for (const std::vector<Base>& bases : choices) {
        if (!bases.empty()) first.push_back(bases.front());
    }
    return first;
}

std::vector<Base> without_meetings(const Map& map, double separation, bool stay, std::span<const Agent> agents,
                                   const std::vector<std::vector<Base>>& choices) {
    if (std::ranges::any_of(choices, [](const auto& bases) { return bases.empty(); })) return {};
    if (choices.size() == 1) return first_of(choices);
    std::vector<std::size_t> chosen(agents.size(), 0);
    const auto base = [&](std::size_t i) -> const Base& { return choices[i][chosen[i]]; };
    Traffic traffic(map.width(), map.height(), separation);
    std::size_t tries = 0;
    for (std::size_t i = 0; i < agents.size();) {
        const std::vector<std::uint32_t> met = traffic.met(base(i), agents[i].body.reach(), stay);
        if (met.empty()) {
            traffic.add(std::uint32_t(i), base(i), agents[i].body.reach(), stay);
            ++i;
            continue;
        }
        if (++tries == most_tries) return {};
        if (++chosen[i] < choices[i].size()) continue;
        // The one in its way takes its next choice, and all after it begin again.
        const std::size_t other = met.front();
        if (++chosen[other] == choices[other].size()) return {};
        while (i > other) {
            chosen[i] = 0;
            traffic.remove(std::uint32_t(--i));
        }
    }
    std::vector<Base> bases;
    for (std::size_t i = 0; i < agents.size(); ++i) bases.push_back(base(i));
    return bases;
}

}  // namespace waybreaker::live
