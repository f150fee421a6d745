// What a game can ask within a frame: ways through a level of rooms, one wall to break, by every call that answers.
//
//     bench_frame [--missions N] [--side CELLS] [--seed N]
//
// Rooms of 24 cells with doors of 2. Processor time of one core: median, of 95 in 100, worst; and how much later than
// the plan of the default method the mission ends, on average of those that have an answer. Then, by the clock: a wall
// falls, and planning in slices.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "program.hpp"
#include "waybreaker/advanced/crossing.hpp"
#include "waybreaker/advanced/schedule.hpp"
#include "waybreaker/advanced/search.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/map_edit.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::bench {
namespace {

constexpr int room = 24;
constexpr int door = 2;
constexpr int repeats = 3;  // the least counts

struct Arguments {
    int missions = 200;
    int side = 512;
    unsigned seed = 1;
};

Arguments parse(std::span<char*> words) {
    Arguments arguments;
    for (std::size_t i = 1; i < words.size(); i += 2) {
        const std::string_view option = words[i];
        if (i + 1 == words.size()) throw InputError("usage: bench_frame [--missions N] [--side CELLS] [--seed N]");
        const int value = std::stoi(words[i + 1]);
        if (option == "--missions") arguments.missions = value;
        if (option == "--side") arguments.side = value;
        if (option == "--seed") arguments.seed = unsigned(value);
    }
    return arguments;
}

// A wall between two rooms: where it begins, and which rooms it parts.
struct Wall {
    Cell from;
    bool down = false;
    std::size_t room = 0;
    std::size_t other = 0;
};

std::vector<Wall> walls(int side) {
    const int across = (side + room - 1) / room;
    const auto number = [across](int x, int y) { return std::size_t(y * across + x); };
    std::vector<Wall> walls;
    for (int y = 0; y < across; ++y) {
        for (int x = 0; x < across; ++x) {
            if (x > 0) walls.push_back({{x * room, y * room}, true, number(x - 1, y), number(x, y)});
            if (y > 0) walls.push_back({{x * room, y * room}, false, number(x, y - 1), number(x, y)});
        }
    }
    return walls;
}

// Doors along a random tree, so that each room can be reached, and in one of six of the other walls. What a door leaves
// of a wall on either side is an obstacle.
Map rooms(int side, std::mt19937& random) {
    std::vector<Wall> all = walls(side);
    for (std::size_t i = all.size() - 1; i > 0; --i) std::swap(all[i], all[random() % (i + 1)]);
    std::vector<std::size_t> joined(all.size() + 1);
    std::iota(joined.begin(), joined.end(), std::size_t{0});
    const auto group = [&](std::size_t one) {
        while (joined[one] != one) one = joined[one];
        return one;
    };
    std::vector<std::uint32_t> labels(std::size_t(side) * std::size_t(side));
    std::uint32_t label = 0;
    for (const Wall& wall : all) {
        const bool joins = group(wall.room) != group(wall.other);
        if (joins) joined[group(wall.room)] = group(wall.other);
        const bool has_door = joins || random() % 6 == 0;
        const int length = std::min(room, side - (wall.down ? wall.from.y : wall.from.x));
        const int gap = 1 + int(random() % unsigned(std::max(length - 1 - door, 1)));
        ++label;
        for (int i = 0; i < length; ++i) {
            if (has_door && i == gap) ++label;
            if (has_door && i >= gap && i < gap + door) continue;
            const Cell cell{wall.from.x + (wall.down ? 0 : i), wall.from.y + (wall.down ? i : 0)};
            labels[std::size_t(cell.y) * std::size_t(side) + std::size_t(cell.x)] = label;
        }
    }
    return Map::from_labels(side, side, std::move(labels));
}

std::vector<Mission> missions(const Map& map, int count, std::mt19937& random) {
    std::vector<Mission> missions;
    const auto free_cell = [&] {
        for (;;) {
            const Cell cell{int(random() % unsigned(map.width())), int(random() % unsigned(map.height()))};
            if (!map.obstacle_at(cell)) return cell;
        }
    };
    while (int(missions.size()) < count) {
        missions.push_back(ground_and_air(free_cell(), free_cell()));
        missions.back().rules.removals = 1;
    }
    return missions;
}

// A way to answer a mission: when it ends; infinity where no answer was found.
struct Way {
    const char* name;
    std::function<double(const Mission&)> end_of;
};

double infinite_unless(const std::optional<double>& end) {
    return end.value_or(std::numeric_limits<double>::infinity());
}

std::vector<Way> ways(const Map& map, Planner& planner, Searcher& searcher, CrossingSearcher& crossing) {
    const auto plan = [&](const Method& method, const Limits& limits) {
        return [&map, &planner, method, limits](const Mission& mission) {
            return infinite_unless(planner.plan(map, mission, method, limits).after.makespan);
        };
    };
    const auto cross = [&map, &crossing](const Mission& mission, int crossings, double weight = 1,
                                         const Limits& limits = {}) {
        const Agent& driver = mission.first(AgentKind::ground);
        return crossing.find(map, driver.start, driver.goal,
                             {.crossings = crossings, .weight = weight, .limits = limits});
    };
    const auto through = [&](const PathThroughOptions& options) {
        return [&map, &planner, options](const Mission& mission) {
            const Agent& driver = mission.first(AgentKind::ground);
            const auto ten = [](const Obstacle&) { return 10.0; };
            const PathThrough way = planner.path_through(map, driver.start, driver.goal, ten, options);
            return way.status == PlanStatus::solved ? way.cost : infinite_unless({});
        };
    };
    return {
        {"Searcher, Theta*, nothing breached",
         [&](const Mission& mission) {
             const Agent& driver = mission.first(AgentKind::ground);
             const SearchResult found = searcher.find(OpenedMap(map), driver.start, driver.goal);
             return found.status == SearchStatus::found ? found.length : infinite_unless({});
         }},
        {"CrossingSearcher, .crossings = 0", [=](const Mission& mission) { return cross(mission, 0).best.length; }},
        {"CrossingSearcher, .crossings = 1", [=](const Mission& mission) { return cross(mission, 1).best.length; }},
        {"  the same, .weight = 1.2", [=](const Mission& mission) { return cross(mission, 1, 1.2).best.length; }},
        {"  and .expansions = 2000",
         [=](const Mission& mission) { return cross(mission, 1, 1.2, {.expansions = 2000}).best.length; }},
        {"  and then best_schedule",
         [&map, cross](const Mission& mission) {
             const CrossingPath best = cross(mission, 1, 1.2, {.expansions = 2000}).best;
             if (best.path.empty()) return infinite_unless({});
             return best_schedule(map, {best.path, mission.first(AgentKind::ground), mission.first(AgentKind::air),
                                        mission.rules, best.crossed})
                 .makespan;
         }},
        {"Planner::path_through, 10 a wall", through({})},
        {"  the same, .most = 1", through({.most = 1})},
        {"  the same, .most = 2", through({.most = 2})},
        {"  the same, .most = 3", through({.most = 3})},
        {"  the same, .most = 3, .weight = 1.1", through({.most = 3, .weight = 1.1})},
        {"Planner, Selection::greedy", plan({.select = Selection::greedy}, {})},
        {"  the same, .expansions = 2000", plan({.select = Selection::greedy}, {.expansions = 2000})},
        {"Planner (exact)", plan({}, {})},
        {"  the same, .gap = 0.03", plan({}, {.gap = 0.03})},
        {"  the same, .expansions = 2000", plan({}, {.expansions = 2000})},
        {"  the same, .seconds = 0.004", plan({}, {.seconds = 0.004})},
    };
}

// Of milliseconds.
void print(const char* name, std::vector<double> times) {
    std::sort(times.begin(), times.end());
    std::printf("%-36s %9.3f %9.3f %9.3f\n", name, times[times.size() / 2], times[times.size() * 95 / 100],
                times.back());
}

double milliseconds_of(const auto& act) {
    const auto begun = std::chrono::steady_clock::now();
    act();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
}

// A wall falls: the map by an edit, and made anew.
void time_edits(const Map& map) {
    std::vector<double> edited;
    std::vector<double> anew;
    for (const Obstacle& wall : map.obstacles()) {
        Map next = map;
        edited.push_back(milliseconds_of([&] { next = map.with({MapEdit::remove(wall.id)}); }));
        std::vector<std::uint32_t> labels(next.labels().begin(), next.labels().end());
        anew.push_back(milliseconds_of([&] { next = Map::from_labels(map.width(), map.height(), std::move(labels)); }));
    }
    print("Map::with, a wall falls", std::move(edited));
    print("Map::from_labels, without it", std::move(anew));
}

// How long steps take that were given 2 ms.
void time_steps(const Map& map, std::span<const Mission> missions, Planner& planner) {
    std::vector<double> steps;
    for (const Mission& mission : missions) {
        PlanningJob job = planner.start(map, mission);
        for (bool done = false; !done;) {
            steps.push_back(milliseconds_of([&] { done = job.step(std::chrono::milliseconds(2)); }));
        }
    }
    print("PlanningJob::step, 2 ms", std::move(steps));
}

void run(const Arguments& arguments) {
    std::mt19937 random(arguments.seed);
    const Map map = rooms(arguments.side, random);
    const std::vector<Mission> asked = missions(map, arguments.missions, random);
    std::printf("%d x %d cells, %zu obstacles, %zu missions\n", map.width(), map.height(), map.obstacles().size(),
                asked.size());
    std::printf("%-36s %9s %9s %9s %9s %9s\n", "milliseconds", "median", "95 %", "worst", "above", "no plan");
    Planner planner;
    Searcher searcher;
    CrossingSearcher crossing;
    std::vector<double> best;
    for (const Mission& mission : asked) best.push_back(infinite_unless(planner.plan(map, mission).after.makespan));
    for (const Way& way : ways(map, planner, searcher, crossing)) {
        std::vector<double> times;
        double above = 0;
        int found = 0;
        for (std::size_t i = 0; i < asked.size(); ++i) {
            double end = 0;
            double least = std::numeric_limits<double>::infinity();
            for (int repeat = 0; repeat < repeats; ++repeat) {
                const std::clock_t begun = std::clock();
                end = way.end_of(asked[i]);
                least = std::min(least, 1e3 * double(std::clock() - begun) / CLOCKS_PER_SEC);
            }
            times.push_back(least);
            if (!std::isfinite(end) || end == 0) continue;
            above += end / best[i] - 1;
            ++found;
        }
        std::sort(times.begin(), times.end());
        std::printf("%-36s %9.2f %9.2f %9.2f %8.2f%% %9zu\n", way.name, times[times.size() / 2],
                    times[times.size() * 95 / 100], times.back(), 100 * above / std::max(found, 1),
                    asked.size() - std::size_t(found));
    }
    time_edits(map);
    time_steps(map, asked, planner);
}

}  // namespace
}  // namespace waybreaker::bench

int main(int argc, char** argv) {
    return waybreaker::bench::program("bench_frame", [&] {
        waybreaker::bench::run(waybreaker::bench::parse({argv, std::size_t(argc)}));
    });
}
