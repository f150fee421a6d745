#include "coalition/ways.hpp"

#include <algorithm>

#include "plan/timeline.hpp"
#include "select/shortened.hpp"
#include "select/timed_path.hpp"

namespace waybreaker::coalition {
namespace {

constexpr std::size_t most_ways = 16;  // for one set
constexpr std::uint64_t most_expansions_in_time = 2'000;
constexpr double rounding = 1e-9;
constexpr std::uint64_t most_expansions = 20'000;

}  // namespace

double arrival(const Agent& agent, const Way& way, const Openings& openings) {
    double delay = 0;
    for (const Gate& gate : way.gates) {
        if (openings.empty()) break;
        delay = std::max(delay, openings.at(gate.obstacle) - agent.ready_at - gate.after);
    }
    return agent.start == agent.goal ? 0 : agent.ready_at + way.drive + delay;
}

Ways::Ways(const Problem& problem, std::span<const team::Vehicle> closed, CrossingSearcher& crossing, Searcher& theta)
    : problem_(problem), closed_(closed), crossing_(crossing), theta_(theta), known_(closed.size()) {}

const std::vector<Way>& Ways::of(std::size_t vehicle, const Set& set) {
    Set part = near(vehicle, set);
    const auto known = known_[vehicle].find(part);
    if (known != known_[vehicle].end()) return known->second;
    std::vector<Way> found = search(vehicle, part);
    return known_[vehicle].emplace(std::move(part), std::move(found)).first->second;
}

// Those that a way can cross that is no longer than the one past all of them.
Set Ways::near(std::size_t vehicle, const Set& set) const {
    const Agent& agent = closed_[vehicle].agent;
    if (closed_[vehicle].way.empty()) return set;
    const double length = (closed_[vehicle].alone - agent.ready_at) * agent.speed;
    const double reach = agent.body.reach() + 1;
    Set part;
    for (const ObstacleId id : set) {
        const Box& box = problem_.map().obstacle(id).bounds;
        if (gap(box, agent.start) + gap(box, agent.goal) - 2 * reach < length) part.push_back(id);
    }
    return part;
}

// As the disc drives it that crosses so much: bends that only the square needs are gone.
std::vector<Point> Ways::shorter(const Agent& agent, std::vector<Point> path,
                                 std::span<const ObstacleId> crossed) const {
    if (!team::drives_by_crossing(agent.body)) return path;
    return shortened(OpenedMap(problem_.map(), crossed), agent.body, std::move(path));
}

Way Ways::way_of(const Agent& agent, std::span<const Point> path, std::span<const ObstacleId> set) const {
    Way way;
    const std::vector<Waypoint> driven = timed(path, agent.speed);
    way.drive = driven.back().t;
    way.path = team::cells_of(path);
    for (const ObstacleId id : set) {
        const auto touched = first_touch(problem_.map(), id, driven, standing_radius(agent.body));
        if (touched) way.gates.push_back({id, *touched});
    }
    return way;
}

std::vector<Way> Ways::search(std::size_t vehicle, const Set& set) {
    const team::Vehicle& closed = closed_[vehicle];
    std::vector<Way> ways;
    if (!closed.way.empty()) ways.push_back(closed_way(vehicle));
    if (set.empty() || problem_.interrupts().due()) return ways;
    if (team::drives_by_crossing(closed.agent.body)) {
        std::ranges::move(search_crossing(vehicle, set), std::back_inserter(ways));
        return ways;
    }
    const SearchOptions options{.body = closed.agent.body, .limits = problem_.interrupts().limits()};
    const OpenedMap opened(problem_.map(), set);
    const SearchResult found = theta_.find(opened, closed.agent.start, closed.agent.goal, options);
    if (found.status != SearchStatus::found) return ways;
    ways.push_back(way_of(closed.agent, std::vector<Point>(found.path.begin(), found.path.end()), set));
    ways.back().expanded = found.expanded;
    ways.back().generated = found.generated;
    return ways;
}

std::vector<Way> Ways::search_crossing(std::size_t vehicle, const Set& set) {
    const team::Vehicle& closed = closed_[vehicle];
    const Agent& agent = closed.agent;
    CrossingOptions options;
    options.body = agent.body;
    options.crossings = int(set.size());
    options.only = set;
    options.limits = problem_.interrupts().limits();
    options.limits.expansions = std::min(options.limits.expansions, most_expansions);
    if (!closed.way.empty()) options.length_limit = (closed.alone - agent.ready_at) * agent.speed;
    std::vector<Way> ways;
    const CrossingResult all =
        crossing_.enumerate(problem_.map(), agent.start, agent.goal, options, [&](const CrossingPath& path) {
            if (!path.crossed.empty())
                ways.push_back(way_of(agent, shorter(agent, path.path, path.crossed), path.crossed));
            return ways.size() < most_ways;
        });
    for (Way& way : ways) {
        way.expanded = all.expanded;
        way.generated = all.generated;
    }
    return ways;
}

Way Ways::closed_way(std::size_t vehicle) const {
    const team::Vehicle& closed = closed_[vehicle];
    Way way = way_of(closed.agent, shorter(closed.agent, {closed.way.begin(), closed.way.end()}, {}), {});
    way.expanded = closed.expanded;
    way.generated = closed.generated;
    return way;
}

bool Ways::find_timed(std::size_t vehicle, const Set& set, const Openings& openings, double arrive_before) {
    const Agent& agent = closed_[vehicle].agent;
    const Set part = near(vehicle, set);
    if (part.empty() || !team::drives_by_crossing(agent.body)) return false;
    CrossingOptions options;
    options.body = agent.body;
    options.crossings = int(part.size());
    options.only = part;
    options.limits = problem_.interrupts().limits();
    options.limits.expansions = std::min(options.limits.expansions, most_expansions_in_time);
    options.length_limit = (arrive_before - agent.ready_at) * agent.speed * (1 - rounding);
    options.opened_after = [&](std::span<const ObstacleId> crossed) {
        double last = 0;
        for (const ObstacleId id : crossed) last = std::max(last, openings.at(id) - agent.ready_at);
        return last * agent.speed;
    };
    if (!(options.length_limit > 0)) return false;
    const CrossingResult found = crossing_.find(problem_.map(), agent.start, agent.goal, options);
    if (found.best.path.empty()) return false;
    const Method method;
    const Limits limits = options.limits;
    const Task task{problem_.map(), agent,  *problem_.aircraft().front(),   problem_.rules(),
                    method,         limits, problem_.interrupts().deadline, 0};
    const Opening driven = drivable(task, {theta_, crossing_}, found.best, part);
    if (driven.status != SearchStatus::found) return false;
    // Not shortened: who bends may do so to come late.
    Way way = way_of(agent, driven.ground.path, part);
    if (!(arrival(agent, way, openings) < arrive_before * (1 - rounding))) return false;
    way.expanded = found.expanded;
    way.generated = found.generated;
    known_[vehicle][part].push_back(std::move(way));
    return true;
}

}  // namespace waybreaker::coalition
