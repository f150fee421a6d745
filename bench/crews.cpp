// What the rules of docs/crews.md cost, on the city missions of the paper: three removals, breaches of 20, makespan.
//
//     bench_crews [--seconds S] [--every K]
//
// S: limit for each mission. Each K-th mission is planned.
//
// A row for each rule: missions; mean and worst of the proven gap; mean of what the removals save; processor
// time of planning (mean, worst); plans that the checker does not accept, and missions without a plan.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>

#include "maps.hpp"
#include "missions_of_paper.hpp"
#include "program.hpp"
#include "statistics.hpp"
#include "waybreaker/check.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::bench {
namespace {

struct Arguments {
    double seconds = 60;
    std::size_t every = 1;
};

Arguments parse(std::span<char*> words) {
    Arguments arguments;
    for (std::size_t i = 1; i < words.size(); i += 2) {
        const std::string_view option = words[i];
        if (i + 1 < words.size() && option == "--seconds") {
            arguments.seconds = std::stod(words[i + 1]);
        } else if (i + 1 < words.size() && option == "--every") {
            arguments.every = std::size_t(std::max(std::stoi(words[i + 1]), 1));
        } else {
            throw InputError("usage: bench_crews [--seconds S] [--every K]");
        }
    }
    return arguments;
}

// A mission of the paper's, and where a second vehicle drives.
struct Places {
    CityMission one;
    CityMission other;

    double apart() const { return distance(one.start, one.goal); }
    Cell middle() const { return {(one.start.x + one.goal.x) / 2, (one.start.y + one.goal.y) / 2}; }
};

Mission pair(const Places& places) {
    Mission mission = ground_and_air(places.one.start, places.one.goal);
    mission.rules.breach_time.per_obstacle = 20;
    return mission;
}

Mission two_vehicles(const Places& places) {
    Mission mission = pair(places);
    mission.agents[0].id = "first";
    mission.agents.insert(mission.agents.begin() + 1, vehicle("second", places.other.start, places.other.goal));
    return mission;
}

Mission without_aircraft(Mission mission) {
    std::erase_if(mission.agents, [](const Agent& agent) { return agent.kind == AgentKind::air; });
    mission.agents[0].own_breaches = 3;
    return mission;
}

// A square in the middle of the way; its side is that share of the distance.
Zone square(ZoneKind kind, const Places& places, double share) {
    const double half = share * places.apart() / 2;
    const Point at(places.middle());
    return {.kind = kind,
            .polygon = {{{at.x - half, at.y - half},
                         {at.x + half, at.y - half},
                         {at.x + half, at.y + half},
                         {at.x - half, at.y + half}}}};
}

Mission with_zone(const Places& places, const Zone& zone) {
    Mission mission = pair(places);
    mission.rules.zones = {zone};
    return mission;
}

struct Rule {
    const char* name;
    std::function<Mission(const Places&)> mission;
};

const std::vector<Rule> rules_of_crews{
    {"an aircraft (no rule)", pair},
    {"a vehicle that opens its own way", [](const Places& places) { return without_aircraft(pair(places)); }},
    {"rubble of 20",
     [](const Places& places) {
         Mission mission = pair(places);
         mission.rules.rubble = 20;
         return mission;
     }},
    {"the aircraft breaches at most 60 cells",
     [](const Places& places) {
         Mission mission = pair(places);
         mission.agents[1].can_breach = {.most_cells = 60};
         return mission;
     }},
    {"no_fly on the way",
     [](const Places& places) { return with_zone(places, square(ZoneKind::no_fly, places, 0.4)); }},
    {"the same for a time",
     [](const Places& places) {
         Zone zone = square(ZoneKind::no_fly, places, 0.4);
         zone.until = places.apart() / 2;
         return with_zone(places, zone);
     }},
    {"keep_out on the way",
     [](const Places& places) { return with_zone(places, square(ZoneKind::keep_out, places, 0.2)); }},
    {"a range of 1.1 times the distance",
     [](const Places& places) {
         Mission mission = pair(places);
         mission.agents[1].range = 1.1 * places.apart();
         return mission;
     }},
    {"a range of 0.6 times it, a base on the way",
     [](const Places& places) {
         Mission mission = pair(places);
         mission.agents[1].range = 0.6 * places.apart();
         mission.agents[1].recharge = 60;
         mission.agents[1].bases = {places.one.start, places.middle(), places.one.goal};
         return mission;
     }},
    {"two vehicles, an aircraft (no rule)", two_vehicles},
    {"two vehicles, the first clears", [](const Places& places) { return without_aircraft(two_vehicles(places)); }},
    {"two vehicles, the first and an aircraft clear",
     [](const Places& places) {
         Mission mission = two_vehicles(places);
         mission.agents[0].own_breaches = 3;
         return mission;
     }},
};

struct Row {
    std::vector<double> gaps;
    std::vector<double> saved;
    std::vector<double> seconds;
    int invalid = 0;
    int without = 0;
};

void add(const Map& map, const Mission& mission, double limit, Row& row) {
    const std::clock_t start = std::clock();
    const Plan plan = Planner().plan(map, mission, {}, {.seconds = limit});
    row.seconds.push_back(double(std::clock() - start) / CLOCKS_PER_SEC);
    if (plan.status != PlanStatus::solved) {
        ++row.without;
        return;
    }
    if (plan.gap) row.gaps.push_back(*plan.gap);
    const std::optional<double> before = value(plan.before, mission.rules.objective);
    if (before) row.saved.push_back(1 - *value(plan.after, mission.rules.objective) / *before);
    row.invalid += check(map, mission, plan).empty() ? 0 : 1;
}

bool is_mission(const Map& map, const Mission& mission) {
    try {
        validate(map, mission);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

// Each mission beside the next one that has room beside it.
std::vector<Places> places_of(const Map& map, const std::vector<CityMission>& missions) {
    std::vector<Places> all;
    for (std::size_t i = 0; i < missions.size(); ++i) {
        for (std::size_t k = 1; k < missions.size(); ++k) {
            const Places places{missions[i], missions[(i + k) % missions.size()]};
            if (!is_mission(map, two_vehicles(places))) continue;
            all.push_back(places);
            break;
        }
    }
    return all;
}

void run(const Arguments& arguments) {
    std::map<std::string, std::vector<CityMission>> missions_of;
    for (const CityMission& mission : missions_of_paper()) missions_of[mission.city].push_back(mission);
    std::vector<Row> rows(rules_of_crews.size());
    std::size_t drawn = 0;
    for (const auto& [city, missions] : missions_of) {
        const Map map(read_city(city));
        for (const Places& places : places_of(map, missions)) {
            if (drawn++ % arguments.every != 0) continue;
            for (std::size_t i = 0; i < rows.size(); ++i) {
                const Mission mission = rules_of_crews[i].mission(places);
                if (is_mission(map, mission)) add(map, mission, arguments.seconds, rows[i]);
            }
        }
    }
    std::printf("%-46s %8s %8s %8s %8s %10s %10s %8s %8s\n", "rule", "missions", "gap %", "worst %", "saved %",
                "mean (ms)", "worst (ms)", "invalid", "no plan");
    const auto most = [](const std::vector<double>& all) { return all.empty() ? 0 : *std::ranges::max_element(all); };
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row& row = rows[i];
        std::printf("%-46s %8zu %8.3f %8.2f %8.2f %10.1f %10.1f %8d %8d\n", rules_of_crews[i].name, row.seconds.size(),
                    100 * mean(row.gaps), 100 * most(row.gaps), 100 * mean(row.saved), 1e3 * mean(row.seconds),
                    1e3 * most(row.seconds), row.invalid, row.without);
    }
}

}  // namespace
}  // namespace waybreaker::bench

int main(int argc, char** argv) {
    using namespace waybreaker::bench;
    return program("bench_crews", [&] { run(parse({argv, std::size_t(argc)})); });
}
