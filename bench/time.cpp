// How good plans are in other settings than the default: the paper's 144 missions with breaches that last, aircraft
// from elsewhere, other speeds, objectives and radii. For each setting the certified gap and the time of a plan, mean
// and worst. A radius moves start and goal to the nearest cells with room for it.
//
//     bench_time [--removals N] [--setting WORD] [--gap SHARE]
#include <algorithm>
#include <cstdio>
#include <limits>
#include <random>

#include "maps.hpp"
#include "missions_of_paper.hpp"
#include "program.hpp"
#include "statistics.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::bench {
namespace {

struct Arguments {
    int removals = 3;
    std::string setting;  // part of its name; empty: all
    double gap = 0;       // that is good enough
};

Arguments parse(std::span<char*> words) {
    Arguments arguments;
    for (std::size_t i = 1; i < words.size(); i += 2) {
        const std::string_view option = words[i];
        if (option == "--removals" && i + 1 < words.size()) {
            arguments.removals = std::stoi(words[i + 1]);
        } else if (option == "--setting" && i + 1 < words.size()) {
            arguments.setting = words[i + 1];
        } else if (option == "--gap" && i + 1 < words.size()) {
            arguments.gap = std::stod(words[i + 1]);
        } else {
            throw InputError("usage: bench_time [--removals N] [--setting WORD] [--gap SHARE]");
        }
    }
    return arguments;
}

Cell free_cell(const Map& map, std::mt19937_64& random) {
    while (true) {
        const Cell c{int(random() % std::uint64_t(map.width())), int(random() % std::uint64_t(map.height()))};
        if (!map.grid().blocked(c)) return c;
    }
}

struct Setting {
    const char* name;
    void (*change)(Mission& mission, const Map& map, std::mt19937_64& random);
};

Cell nearest_with_room(const Map& map, Cell to, const Body& body) {
    const OpenedMap closed(map);
    Cell best = to;
    double least = std::numeric_limits<double>::infinity();
    for (Cell c{0, 0}; c.y < map.height(); ++c.y) {
        for (c.x = 0; c.x < map.width(); ++c.x) {
            if (distance(c, to) >= least || !fits(closed, c, body)) continue;
            least = distance(c, to);
            best = c;
        }
    }
    return best;
}

template <int thousandths>
void set_radius(Mission& mission, const Map& map, std::mt19937_64& /*random*/) {
    const Body body{.radius = thousandths / 1000.0};
    mission.agents[0].body = body;
    for (Agent& agent : mission.agents) {
        agent.start = nearest_with_room(map, agent.start, body);
        agent.goal = nearest_with_room(map, agent.goal, body);
    }
}

Agent& air(Mission& mission) {
    return *std::ranges::find(mission.agents, AgentKind::air, &Agent::kind);
}

constexpr Setting settings[] = {
    {"default", [](Mission&, const Map&, std::mt19937_64&) {}},
    {"breach time 5", [](Mission& m, const Map&, std::mt19937_64&) { m.rules.breach_time.per_obstacle = 5; }},
    {"breach time 20", [](Mission& m, const Map&, std::mt19937_64&) { m.rules.breach_time.per_obstacle = 20; }},
    {"breach time 50", [](Mission& m, const Map&, std::mt19937_64&) { m.rules.breach_time.per_obstacle = 50; }},
    {"base at the goal", [](Mission& m, const Map&, std::mt19937_64&) { air(m).start = air(m).goal; }},
    {"base anywhere",
     [](Mission& m, const Map& map, std::mt19937_64& random) { air(m).start = free_cell(map, random); }},
    {"air speed 0.5", [](Mission& m, const Map&, std::mt19937_64&) { air(m).speed = 0.5; }},
    {"air speed 2", [](Mission& m, const Map&, std::mt19937_64&) { air(m).speed = 2; }},
    {"air speed 5", [](Mission& m, const Map&, std::mt19937_64&) { air(m).speed = 5; }},
    {"breach time 50, air speed 5",
     [](Mission& m, const Map&, std::mt19937_64&) {
         m.rules.breach_time.per_obstacle = 50;
         air(m).speed = 5;
     }},
    {"flowtime", [](Mission& m, const Map&, std::mt19937_64&) { m.rules.objective = Objective::flowtime; }},
    {"flowtime, breach time 20",
     [](Mission& m, const Map&, std::mt19937_64&) {
         m.rules.objective = Objective::flowtime;
         m.rules.breach_time.per_obstacle = 20;
     }},
    {"radius 0", set_radius<0>},
    {"radius 0.2", set_radius<200>},
    {"radius 0.7", set_radius<700>},
    {"radius 1", set_radius<1000>},
    {"radius 2", set_radius<2000>},
    {"radius 4", set_radius<4000>},
    {"radius 8", set_radius<8000>},
};

void run(const Arguments& arguments) {
    std::map<std::string, Map> cities;
    const std::vector<CityMission> missions = missions_of_paper();
    for (const CityMission& mission : missions) cities.try_emplace(mission.city, read_city(mission.city));
    Planner planner;
    std::printf("%zu missions, n = %d\n%-30s %10s %10s %10s %10s %12s %6s\n", missions.size(), arguments.removals, "",
                "gap, mean", "worst", "ms, mean", "worst", "makespan", "plans");
    for (const Setting& setting : settings) {
        if (std::string_view(setting.name).find(arguments.setting) == std::string_view::npos) continue;
        std::mt19937_64 random(1);
        std::vector<double> gaps;
        std::vector<double> seconds;
        std::vector<double> makespans;
        for (const CityMission& city : missions) {
            const Map& map = cities.at(city.city);
            Mission mission = ground_and_air(city.start, city.goal);
            mission.rules.removals = arguments.removals;
            setting.change(mission, map, random);
            Plan plan;
            seconds.push_back(seconds_of([&] { plan = planner.plan(map, mission, {}, {.gap = arguments.gap}); }));
            if (!plan.gap) continue;  // no plan
            gaps.push_back(100 * *plan.gap);
            makespans.push_back(plan.after.makespan.value());
        }
        std::printf("%-30s %8.3f %% %8.3f %% %10.2f %10.1f %12.4f %6zu\n", setting.name, mean(gaps),
                    std::ranges::max(gaps), 1e3 * mean(seconds), 1e3 * std::ranges::max(seconds), mean(makespans),
                    gaps.size());
        std::fflush(stdout);
    }
}

}  // namespace
}  // namespace waybreaker::bench

int main(int argc, char** argv) {
    return waybreaker::bench::program("bench_time", [&] {
        waybreaker::bench::run(waybreaker::bench::parse({argv, std::size_t(argc)}));
    });
}
