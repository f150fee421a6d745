// What a revision costs beside the first plan: one vehicle and one aircraft on the maps of data/, which have to be
// planned anew since a breach has failed, the vehicle is late, or the street ahead is blocked. Processor time, each the
// least of several runs; mean and worst over all missions of a setting, and the ratio of the means.
//
//     bench_revise [--missions N] [--runs N] [--setting WORD] [MAP ...]
#include "waybreaker/revise.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "mapfile/map_reader.hpp"
#include "maps.hpp"
#include "program.hpp"
#include "statistics.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::bench {
namespace {

struct Arguments {
    int missions = 30;    // on each map
    int runs = 3;         // of each call
    std::string setting;  // part of its name; empty: all
    std::vector<std::string> maps = {};
};

Arguments parse(std::span<char*> words) {
    Arguments arguments;
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string_view option = words[i];
        const bool has_value = i + 1 < words.size();
        if (option == "--missions" && has_value) {
            arguments.missions = std::stoi(words[++i]);
        } else if (option == "--runs" && has_value) {
            arguments.runs = std::stoi(words[++i]);
        } else if (option == "--setting" && has_value) {
            arguments.setting = words[++i];
        } else if (!option.starts_with("-")) {
            arguments.maps.emplace_back(option);
        } else {
            throw InputError("usage: bench_revise [--missions N] [--runs N] [--setting WORD] [MAP ...]");
        }
    }
    return arguments;
}

struct Setting {
    std::string name;
    int removals;
    double breach_time;
    double air_speed;
};

std::vector<Setting> settings() {
    std::vector<Setting> settings;
    for (const int removals : {1, 2, 3}) {
        for (const double breach_time : {0.0, 10.0}) {
            settings.push_back({"n = " + std::to_string(removals) + ", breach time " + std::to_string(int(breach_time)),
                                removals, breach_time, 2});
        }
    }
    return settings;
}

Cell free_cell(const Map& map, std::mt19937_64& random) {
    while (true) {
        const Cell c{int(random() % std::uint64_t(map.width())), int(random() % std::uint64_t(map.height()))};
        if (!map.grid().blocked(c)) return c;
    }
}

// Missions that are long enough to be under way, and have a plan that removes something.
struct Begun {
    Mission mission;
    Plan plan;
};
std::vector<Begun> missions_on(const Map& map, const Setting& setting, int count) {
    std::mt19937_64 random(1);
    Planner planner;
    std::vector<Begun> missions;
    while (int(missions.size()) < count) {
        Mission mission = ground_and_air(free_cell(map, random), free_cell(map, random));
        mission.rules.removals = setting.removals;
        mission.rules.breach_time.per_obstacle = setting.breach_time;
        mission.agents[1].speed = setting.air_speed;
        if (distance(mission.agents[0].start, mission.agents[0].goal) < map.width() / 3.0) continue;
        Expected<Plan> plan = planner.try_plan(map, mission);
        if (plan && plan->status == PlanStatus::solved && !plan->breaches.empty())
            missions.push_back({mission, *std::move(plan)});
    }
    return missions;
}

Waypoint place_at(const std::vector<Waypoint>& path, double time) {
    const auto after = std::ranges::upper_bound(path, time, {}, &Waypoint::t);
    if (after == path.begin()) return path.front();
    if (after == path.end()) return path.back();
    const Waypoint& a = *std::prev(after);
    const double share = (time - a.t) / (after->t - a.t);
    return {a.x + share * (after->x - a.x), a.y + share * (after->y - a.y), time};
}

State failed_breach(const Begun& begun) {
    const Breach& breach = begun.plan.breaches.front();
    State state{.sequence = 1, .now = breach.cleared_at};
    state.failed = {{breach.obstacle, breach.cleared_at}};
    return state;
}

// By 5 units of time, half of the way.
State late_vehicle(const Begun& begun) {
    const std::vector<Waypoint>& path = begun.plan.agents[0].path;
    const double then = path.back().t / 2;
    const Waypoint at = place_at(path, then);
    const auto next = std::ranges::upper_bound(path, then, {}, &Waypoint::t);
    State state{.sequence = 1, .now = then + 5};
    state.agents = {{.id = begun.mission.agents[0].id, .passed = std::size_t(next - path.begin()) - 1}};
    state.agents[0].at = Point(at.x, at.y);
    return state;
}

// Ten cells ahead of the vehicle, a third of the way; none where its goal is there, or nothing to block.
std::optional<State> blocked_street(const Map& map, const Begun& begun) {
    const std::vector<Waypoint>& path = begun.plan.agents[0].path;
    State state{.sequence = 1, .now = path.back().t / 3};
    const Waypoint ahead = place_at(path, state.now + 10 / begun.mission.agents[0].speed);
    const Cell centre{int(std::lround(ahead.x)), int(std::lround(ahead.y))};
    if (distance(centre, begun.mission.agents[0].goal) < 4) return std::nullopt;
    Found& found = state.found.emplace_back();
    for (int y = centre.y - 1; y <= centre.y + 1; ++y) {
        for (int x = centre.x - 1; x <= centre.x + 1; ++x) {
            if (map.grid().contains({x, y}) && !map.grid().blocked({x, y})) found.cells.push_back({x, y});
        }
    }
    return found.cells.empty() ? std::nullopt : std::optional(state);
}

// Processor time, the least of several runs.
template <class Work>
double processor_seconds(int runs, Work work) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < runs; ++i) {
        const std::clock_t begun = std::clock();
        work();
        least = std::min(least, double(std::clock() - begun) / CLOCKS_PER_SEC);
    }
    return least;
}

void print(const std::string& name, const std::vector<double>& plans, const std::vector<double>& revisions) {
    if (plans.empty()) return;
    std::printf("%-24s %5zu %10.2f %10.2f %10.2f %10.2f %8.2f\n", name.c_str(), plans.size(), 1e3 * mean(plans),
                1e3 * std::ranges::max(plans), 1e3 * mean(revisions), 1e3 * std::ranges::max(revisions),
                mean(revisions) / mean(plans));
    std::fflush(stdout);
}

void run(const Arguments& arguments) {
    std::vector<std::string> maps = arguments.maps;
    if (maps.empty()) {
        for (const char* city : {"berlin-adlershof", "berlin-mitte"}) maps.push_back(city_in_data(city).string());
    }
    Planner planner;
    for (const std::string& file : maps) {
        const Map map = mapfile::read_map_file(file).map;
        std::printf("%s\n%-24s %5s %10s %10s %10s %10s %8s\n", file.c_str(), "", "", "plan, ms", "worst", "revise, ms",
                    "worst", "ratio");
        for (const Setting& setting : settings()) {
            if (setting.name.find(arguments.setting) == std::string::npos) continue;
            std::printf("%s\n", setting.name.c_str());
            std::vector<double> first[3];
            std::vector<double> next[3];
            for (const Begun& begun : missions_on(map, setting, arguments.missions)) {
                const double planned =
                    processor_seconds(arguments.runs, [&] { static_cast<void>(planner.plan(map, begun.mission)); });
                const std::optional<State> states[] = {failed_breach(begun), late_vehicle(begun),
                                                       blocked_street(map, begun)};
                for (std::size_t i = 0; i < std::size(states); ++i) {
                    if (!states[i]) continue;
                    first[i].push_back(planned);
                    next[i].push_back(processor_seconds(arguments.runs, [&] {
                        static_cast<void>(revise(planner, map, begun.mission, begun.plan, *states[i]));
                    }));
                }
            }
            const char* const news[] = {"  a breach has failed", "  the vehicle is late", "  the street is blocked"};
            for (std::size_t i = 0; i < std::size(news); ++i) print(news[i], first[i], next[i]);
        }
    }
}

}  // namespace
}  // namespace waybreaker::bench

int main(int argc, char** argv) {
    return waybreaker::bench::program("bench_revise", [&] {
        waybreaker::bench::run(waybreaker::bench::parse({argv, std::size_t(argc)}));
    });
}
