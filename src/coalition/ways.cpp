#include "coalition/ways.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "coalition/tuning.hpp"
#include "drive/opening.hpp"
#include "drive/punctual.hpp"
#include "drive/shortened.hpp"
#include "map/gap.hpp"
#include "model/rubble.hpp"
#include "model/timeline.hpp"

namespace waybreaker::coalition {
double arrival(const Agent& agent, const Way& way, const Openings& openings) {
    double delay = 0;
    for (const Gate& gate : way.gates) {
        if (openings.empty()) break;
        delay = std::max(delay, openings.at(gate.obstacle) - agent.ready_at - gate.after);
    }
    return agent.ready_at + way.drive + delay;
}

Ways::Ways(const Problem& problem, std::span<const team::Vehicle> closed)
    : problem_(problem),
      closed_(closed),
      effort_(closed.size()),
      memories_(closed.size()),
      known_(closed.size()),
      timed_(closed.size()) {}

bool Ways::knows(std::size_t vehicle, const Set& set) const {
    const Set part = near(vehicle, set);
    return part.empty() || known_[vehicle].contains(part) || larger_menu(vehicle, part) != nullptr;
}

const std::vector<Way>& Ways::of(std::size_t vehicle, const Set& set, Worker& worker) {
    Set part = near(vehicle, set);
    const auto known = known_[vehicle].find(part);
    if (known != known_[vehicle].end()) return known->second.ways;
    Menu menu;
    if (const Menu* larger = larger_menu(vehicle, part)) {
        const auto fits = [&](const Way& way) {
            return std::ranges::all_of(way.gates, [&](const Gate& gate) { return contains(part, gate.obstacle); });
        };
        std::ranges::copy_if(larger->ways, std::back_inserter(menu.ways), fits);
    } else {
        menu = search(vehicle, part, worker);
    }
    return known_[vehicle].emplace(std::move(part), std::move(menu)).first->second.ways;
}

// Of a set that holds this one: its ways are among those. None if it is not known.
const Ways::Menu* Ways::larger_menu(std::size_t vehicle, const Set& part) const {
    if (!team::drives_by_crossing(closed_[vehicle].agent.body)) return nullptr;
    for (const auto& [set, menu] : known_[vehicle]) {
        if (menu.complete && std::ranges::includes(set, part)) return &menu;
    }
    return nullptr;
}

// Of the way past all obstacles, in cells; or of what gets there before it counts as unreached.
double Ways::longest(std::size_t vehicle) const {
    const team::Vehicle& closed = closed_[vehicle];
    if (closed.way.empty() && std::isinf(problem_.unreached(vehicle))) return infinity;
    return (closed.alone - closed.agent.ready_at) * closed.agent.speed;
}

// Those that a way can cross that is no longer than the one past all of them.
Set Ways::near(std::size_t vehicle, const Set& set) const {
    const Agent& agent = closed_[vehicle].agent;
    const double length = longest(vehicle);
    if (std::isinf(length)) return set;
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
    const double rubble = problem_.rules().rubble;
    const std::vector<Waypoint> driven = timed_through(problem_.map(), path, agent.body, agent.speed, 0, {set, rubble});
    way.drive = driven.back().t;
    way.path = team::cells_of(path);
    for (const ObstacleId id : set) {
        const auto touched = first_touch(problem_.map(), id, driven, standing_radius(agent.body));
        if (touched) way.gates.push_back({id, *touched - rubble});
    }
    return way;
}

Ways::Menu Ways::search(std::size_t vehicle, const Set& set, Worker& worker) {
    const team::Vehicle& closed = closed_[vehicle];
    Menu menu;
    if (std::isfinite(problem_.unreached(vehicle))) menu.ways.push_back(stay(vehicle));
    if (!closed.way.empty()) menu.ways.push_back(closed_way(vehicle));
    if (set.empty() || problem_.interrupts().due()) {
        menu.complete = set.empty();
        return menu;
    }
    const Body& body = closed.agent.body;
    if (team::drives_by_crossing(body)) {
        if (square_stands_for(body)) {
            search_crossing(vehicle, set, menu, worker);
        } else {
            search_each(vehicle, set, menu, worker);
        }
        return menu;
    }
    const SearchOptions options{.body = body, .limits = problem_.interrupts().limits()};
    const OpenedMap opened(problem_.map(), set);
    const SearchResult found = worker.theta.find(opened, closed.agent.start, closed.agent.goal, options);
    if (found.status != SearchStatus::found) return menu;
    Way& way =
        menu.ways.emplace_back(way_of(closed.agent, std::vector<Point>(found.path.begin(), found.path.end()), set));
    way.expanded = found.expanded;
    way.generated = found.generated;
    return menu;
}

// Of all sets within that one, as much as is no longer than the way past all of them.
CrossingOptions Ways::options_for(std::size_t vehicle, const Set& set) const {
    const team::Vehicle& closed = closed_[vehicle];
    CrossingOptions options;
    options.body = closed.agent.body;
    options.crossings = int(set.size());
    options.only = set;
    options.prices = problem_.rubble_prices(vehicle);
    options.limits = problem_.interrupts().limits();
    options.limits.expansions = std::min(options.limits.expansions, tuning::most_path_expansions);
    if (const double length = longest(vehicle); std::isfinite(length)) {
        options.length_limit = length;
        options.expected = options.length_limit;  // it is all looked at
    }
    return options;
}

void Ways::search_crossing(std::size_t vehicle, const Set& set, Menu& menu, Worker& worker) {
    const Agent& agent = closed_[vehicle].agent;
    const CrossingOptions options = options_for(vehicle, set);
    const std::size_t before = menu.ways.size();
    const CrossingResult all =
        worker.crossing.enumerate(problem_.map(), agent.start, agent.goal, options, [&](const CrossingPath& path) {
            if (!path.crossed.empty())
                menu.ways.push_back(way_of(agent, shorter(agent, path.path, path.crossed), path.crossed));
            return menu.ways.size() < before + tuning::most_paths;
        });
    effort_[vehicle] += tuning::effort_of_expansion * all.expanded;
    menu.complete = menu.ways.size() < before + tuning::most_paths && came_to_its_end(all.status);
    for (Way& way : std::span(menu.ways).subspan(before)) {
        way.expanded = all.expanded;
        way.generated = all.generated;
    }
}

// As in a mission of its own, for each set that gains for the square or for the relaxed body, and for all of it: the
// disc fits where its square does not.
void Ways::search_each(std::size_t vehicle, const Set& set, Menu& menu, Worker& worker) {
    std::vector<Set> sets = gaining(vehicle, set, false, menu, worker);
    std::vector<Set> others = gaining(vehicle, set, true, menu, worker);
    others.push_back(set);
    for (Set& other : others) {
        if (std::ranges::find(sets, other) == sets.end()) sets.push_back(std::move(other));
    }
    const Agent& agent = closed_[vehicle].agent;
    const Trip trip = team::trip_of(problem_.map(), agent, problem_.interrupts(), problem_.rules().rubble);
    const double longest = options_for(vehicle, set).length_limit;
    for (const Set& crossed : sets) {
        const Opening opening = open(trip, {worker.theta, worker.crossing}, crossed);
        effort_[vehicle] += tuning::effort_of_expansion * opening.ground.expanded;
        menu.complete = menu.complete && !opening.limited;
        if (opening.status != SearchStatus::found || cells_driven(trip, opening) > longest) continue;
        Way& way = menu.ways.emplace_back(way_of(agent, opening.ground.path, crossed));
        way.expanded = opening.ground.expanded;
        way.generated = opening.ground.generated;
    }
}

// The sets that a search tells of.
std::vector<Set> Ways::gaining(std::size_t vehicle, const Set& set, bool relaxed, Menu& menu, Worker& worker) {
    const Agent& agent = closed_[vehicle].agent;
    CrossingOptions options = options_for(vehicle, set);
    options.relaxed = relaxed;
    std::vector<Set> sets;
    const CrossingResult all =
        worker.crossing.enumerate(problem_.map(), agent.start, agent.goal, options, [&](const CrossingPath& path) {
            if (path.crossed.empty()) return true;
            std::ranges::sort(sets.emplace_back(path.crossed));
            return sets.size() < tuning::most_paths;
        });
    effort_[vehicle] += tuning::effort_of_expansion * all.expanded;
    menu.complete = menu.complete && came_to_its_end(all.status) && sets.size() < tuning::most_paths;
    return sets;
}

// At the start, until it counts as unreached.
Way Ways::stay(std::size_t vehicle) const {
    const Agent& agent = closed_[vehicle].agent;
    Way way;
    way.path = {agent.start};
    way.drive = problem_.unreached(vehicle) - agent.ready_at;
    return way;
}

Way Ways::closed_way(std::size_t vehicle) const {
    const team::Vehicle& closed = closed_[vehicle];
    const Set& opened = problem_.opened();
    std::vector<Point> path(closed.way.begin(), closed.way.end());
    // It goes around what is not worth its rubble.
    if (problem_.rules().rubble == 0) path = shorter(closed.agent, std::move(path), opened);
    Way way = way_of(closed.agent, path, opened);
    way.expanded = closed.expanded;
    way.generated = closed.generated;
    return way;
}

bool Ways::find_timed(std::size_t vehicle, const Set& set, const Openings& openings, double arrive_before,
                      bool thorough, Worker& worker) {
    const Agent& agent = closed_[vehicle].agent;
    const Set part = near(vehicle, set);
    if (part.empty() || !team::drives_by_crossing(agent.body) || !(arrive_before > agent.ready_at)) return false;
    std::vector<std::pair<ObstacleId, double>> times;
    for (const ObstacleId id : part) times.emplace_back(id, openings.at(id));
    const auto [tried, is_new] = timed_[vehicle].emplace(std::move(times), thorough);
    if (!is_new && (tried->second || !thorough)) return false;
    tried->second = thorough;
    std::vector<Way> found;
    if (thorough) found = waiting(vehicle, part, openings, arrive_before);
    if (std::optional<Way> way = search_timed(vehicle, part, openings, arrive_before, worker))
        found.push_back(std::move(*way));
    if (found.empty()) return false;
    const OpenedMap opened(problem_.map(), part);
    std::optional<Way> best;
    for (const Way& way : found) {
        Way bent = punctual_way(opened, vehicle, way, part, openings);
        const double time = arrival(agent, bent, openings);
        if (!(time < arrive_before * (1 - rounding))) continue;
        arrive_before = time;
        best = std::move(bent);
    }
    if (!best) return false;
    known_[vehicle][part].ways.push_back(std::move(*best));
    return true;
}

bool Ways::add(std::size_t vehicle, const Set& set, std::span<const Point> path, Worker& worker) {
    const Agent& agent = closed_[vehicle].agent;
    if (!team::drives_by_crossing(agent.body) || path_length(path) > longest(vehicle)) return false;
    of(vehicle, set, worker);
    const Set part = near(vehicle, set);
    known_[vehicle][part].ways.push_back(way_of(agent, path, part));
    return true;
}

// The known ways that are best but for waits.
std::vector<Way> Ways::waiting(std::size_t vehicle, const Set& part, const Openings& openings, double arrive_before) {
    const Agent& agent = closed_[vehicle].agent;
    std::vector<Way> ways = known_[vehicle][part].ways;
    std::erase_if(ways, [&](const Way& way) { return arrival(agent, way, {}) >= arrive_before; });
    std::ranges::stable_sort(ways, {}, [&](const Way& way) { return arrival(agent, way, openings); });
    if (ways.size() > tuning::most_bent_paths) ways.resize(tuning::most_bent_paths);
    return ways;
}

// A path of the crossing search in time, as the vehicle can drive it.
std::optional<Way> Ways::search_timed(std::size_t vehicle, const Set& part, const Openings& openings,
                                      double arrive_before, Worker& worker) {
    const Remembering remembering(worker.crossing, memories_[vehicle]);
    const Agent& agent = closed_[vehicle].agent;
    CrossingOptions options;
    options.body = agent.body;
    options.crossings = int(part.size());
    options.only = part;
    options.limits = problem_.interrupts().limits();
    options.limits.expansions = std::min(options.limits.expansions, tuning::most_path_expansions_in_time);
    options.length_limit = (arrive_before - agent.ready_at) * agent.speed * (1 - rounding);
    options.opened_after = [&](std::span<const ObstacleId> crossed) {
        double last = 0;
        const double rubble = problem_.rules().rubble;
        for (const ObstacleId id : crossed) last = std::max(last, openings.at(id) + rubble - agent.ready_at);
        return last * agent.speed;
    };
    const CrossingResult found = worker.crossing.find(problem_.map(), agent.start, agent.goal, options);
    effort_[vehicle] += tuning::effort_of_expansion * found.expanded;
    if (found.best.path.empty()) return std::nullopt;
    const Trip trip = team::trip_of(problem_.map(), agent, problem_.interrupts(), problem_.rules().rubble);
    const Opening driven = drivable(trip, {worker.theta, worker.crossing}, found.best, part);
    if (driven.status != SearchStatus::found) return std::nullopt;
    // Not shortened: who bends may do so to come late.
    Way way = way_of(agent, driven.ground.path, part);
    way.expanded = found.expanded;
    way.generated = found.generated;
    return way;
}

Way Ways::punctual_way(const OpenedMap& opened, std::size_t vehicle, const Way& way, const Set& part,
                       const Openings& openings) {
    const Agent& agent = closed_[vehicle].agent;
    std::vector<TimedOpening> times;
    for (const ObstacleId id : part) times.push_back({id, openings.at(id)});
    const auto [path, judged] = punctual(opened, agent, way.path, std::move(times), problem_.rules().rubble);
    effort_[vehicle] += judged;
    Way bent = way_of(agent, std::vector<Point>(path.begin(), path.end()), part);
    bent.expanded = way.expanded;
    bent.generated = way.generated;
    return bent;
}

}  // namespace waybreaker::coalition
