// Teams for which aircraft remove obstacles: on the city maps of the paper's missions, whose agents are drawn from the
// missions of one city, so many of them as are needed from random places at least as far apart.
//
//     bench_coalition [--objective flowtime|makespan] [--breach-time T] [--air-speed V] [--radius R] [--seconds S]
//                     [--gap G] [--threads T] [--teams K+M:N,...] [--every K]
//
// A sample is each K-th mission of a team.
//
// A row for each team: vehicles, aircraft, removals; missions; means of the proven gap, of what the removals save, and
// the worst gap; how long planning took (mean, worst), and how long all its threads together worked (mean); plans that
// the judge does not accept, and missions without a plan.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <random>
#include <sstream>
#include <tuple>

#include "maps.hpp"
#include "missions_of_paper.hpp"
#include "program.hpp"
#include "statistics.hpp"
#include "waybreaker/check.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::bench {
namespace {

constexpr double least_distance = 400;  // of the paper's missions

struct Team {
    int vehicles = 2;
    int aircraft = 1;
    int removals = 3;
};

struct Arguments {
    Objective objective = Objective::flowtime;
    double breach_time = 0;
    double air_speed = 1;
    double radius = 0.5;
    double seconds = 60;
    double gap = 0;
    unsigned threads = 1;
    std::vector<Team> teams{{2, 1, 3},  {2, 1, 5},  {2, 1, 10},  {5, 2, 3},    {5, 2, 5},    {5, 2, 10},
                            {10, 3, 3}, {10, 3, 5}, {10, 3, 10}, {100, 10, 3}, {100, 10, 5}, {100, 10, 10}};
    std::size_t every = 1;
};

Arguments parse(std::span<char*> words) {
    const InputError usage(
        "usage: bench_coalition [--objective flowtime|makespan] [--breach-time T] [--air-speed V] [--radius R] "
        "[--seconds S] [--gap G] [--threads T] [--teams K+M:N,...] [--every K]");
    Arguments arguments;
    for (std::size_t i = 1; i < words.size(); i += 2) {
        if (i + 1 == words.size()) throw usage;
        const std::string_view option = words[i];
        const std::string value = words[i + 1];
        if (option == "--objective") {
            if (value != "flowtime" && value != "makespan") throw usage;
            arguments.objective = value == "flowtime" ? Objective::flowtime : Objective::makespan;
        } else if (option == "--breach-time") {
            arguments.breach_time = std::stod(value);
        } else if (option == "--air-speed") {
            arguments.air_speed = std::stod(value);
        } else if (option == "--radius") {
            arguments.radius = std::stod(value);
        } else if (option == "--seconds") {
            arguments.seconds = std::stod(value);
        } else if (option == "--gap") {
            arguments.gap = std::stod(value);
        } else if (option == "--threads") {
            arguments.threads = unsigned(std::stoul(value));
        } else if (option == "--teams") {
            arguments.teams.clear();
            std::istringstream list(value);
            for (std::string one; std::getline(list, one, ',');) {
                Team team;
                if (std::sscanf(one.c_str(), "%d+%d:%d", &team.vehicles, &team.aircraft, &team.removals) != 3)
                    throw usage;
                arguments.teams.push_back(team);
            }
        } else if (option == "--every") {
            arguments.every = std::size_t(std::max(std::stoi(value), 1));
        } else {
            throw usage;
        }
    }
    return arguments;
}

double processor_seconds() {
    return double(std::clock()) / CLOCKS_PER_SEC;
}

// Agents as far apart as those of the paper, where there is room for them beside those before.
class Draw {
  public:
    Draw(const Map& map, const std::vector<CityMission>& missions) : map_(map), missions_(missions), random_(1) {}

    Mission mission(const Team& team, const Arguments& arguments) {
        Mission mission;
        mission.rules.removals = team.removals;
        mission.rules.objective = arguments.objective;
        mission.rules.breach_time.per_obstacle = arguments.breach_time;
        while (int(mission.agents.size()) < team.vehicles) {
            Agent& agent = mission.agents.emplace_back();
            agent.id = std::to_string(mission.agents.size());
            agent.body.radius = arguments.radius;
            std::tie(agent.start, agent.goal) = places();
            try {
                validate(map_, mission);
            } catch (const InputError&) {
                mission.agents.pop_back();
            }
        }
        for (int i = 0; i < team.aircraft; ++i) {
            // Each aircraft has the base of a vehicle.
            Agent agent = mission.agents[std::size_t(i)];
            agent.id = "air" + std::to_string(i + 1);
            agent.kind = AgentKind::air;
            agent.speed = arguments.air_speed;
            mission.agents.push_back(agent);
        }
        return mission;
    }

  private:
    std::pair<Cell, Cell> places() {
        if (next_ < missions_.size()) {
            const CityMission& mission = missions_[next_++];
            return {mission.start, mission.goal};
        }
        for (;;) {
            const Cell start = any();
            const Cell goal = any();
            if (distance(start, goal) >= least_distance) return {start, goal};
        }
    }
    int below(int count) { return int(random_() % unsigned(count)); }
    Cell any() { return {below(map_.width()), below(map_.height())}; }

    const Map& map_;
    const std::vector<CityMission>& missions_;
    std::mt19937 random_;
    std::size_t next_ = 0;
};

struct Row {
    std::size_t drawn = 0;
    std::vector<double> gaps;
    std::vector<double> saved;
    std::vector<double> seconds;
    std::vector<double> processor_seconds;
    int invalid = 0;
    int without = 0;
};

void run_city(const Map& map, const std::vector<CityMission>& missions, const Team& team, const Arguments& arguments,
              Row& row) {
    Draw draw(map, missions);
    const std::size_t count = std::max<std::size_t>(missions.size() / std::size_t(team.vehicles), 1);
    for (std::size_t i = 0; i < count; ++i) {
        const Mission mission = draw.mission(team, arguments);
        if (row.drawn++ % arguments.every != 0) continue;
        const auto start = std::chrono::steady_clock::now();
        const double start_of_work = processor_seconds();
        const Plan plan = Planner().plan(
            map, mission, {}, {.seconds = arguments.seconds, .gap = arguments.gap, .threads = arguments.threads});
        row.processor_seconds.push_back(processor_seconds() - start_of_work);
        row.seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        if (plan.status != PlanStatus::solved) {
            ++row.without;
            continue;
        }
        row.gaps.push_back(*plan.gap);
        const std::optional<double> before = value(plan.before, arguments.objective);
        if (before) row.saved.push_back(1 - *value(plan.after, arguments.objective) / *before);
        row.invalid += check(map, mission, plan).empty() ? 0 : 1;
    }
}

void run(const Arguments& arguments) {
    std::map<std::string, std::vector<CityMission>> missions_of;
    for (const CityMission& mission : missions_of_paper()) missions_of[mission.city].push_back(mission);
    std::printf("%-12s %9s %8s %8s %8s %10s %10s %10s %8s %8s\n", "team", "missions", "gap %", "worst %", "saved %",
                "mean (ms)", "worst (ms)", "work (ms)", "invalid", "no plan");
    for (const Team& team : arguments.teams) {
        Row row;
        for (const auto& [city, missions] : missions_of) run_city(Map(read_city(city)), missions, team, arguments, row);
        const auto most = [](const std::vector<double>& all) {
            return all.empty() ? 0 : *std::ranges::max_element(all);
        };
        const std::string name =
            std::to_string(team.vehicles) + "+" + std::to_string(team.aircraft) + ":" + std::to_string(team.removals);
        std::printf("%-12s %9zu %8.3f %8.2f %8.2f %10.1f %10.1f %10.1f %8d %8d\n", name.c_str(), row.seconds.size(),
                    100 * mean(row.gaps), 100 * most(row.gaps), 100 * mean(row.saved), 1e3 * mean(row.seconds),
                    1e3 * most(row.seconds), 1e3 * mean(row.processor_seconds), row.invalid, row.without);
        std::fflush(stdout);
    }
}

}  // namespace
}  // namespace waybreaker::bench

int main(int argc, char** argv) {
    using namespace waybreaker::bench;
    return program("bench_coalition", [&] { run(parse({argv, std::size_t(argc)})); });
}
