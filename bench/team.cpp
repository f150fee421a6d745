// Teams of the first K lines of a MovingAI scenario, without aircraft: the first plan, and what a time limit makes of
// it.
//
//     bench_team MAP SCENARIO [--radius R] [--seconds S] [--agents K,K,...]
//
// A row for each K: agents; solved or not; processor seconds until the first plan; flowtime of all agents alone, and
// of the first and the last plan by that; the proven gap of the last one; whether the judge accepts it.
#include <cstdio>
#include <ctime>
#include <fstream>
#include <sstream>

#include "program.hpp"
#include "waybreaker/check.hpp"
#include "waybreaker/error.hpp"
#include "waybreaker/movingai.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker::bench {
namespace {

struct Arguments {
    std::string map;
    std::string scenario;
    double radius = 0.5;
    double seconds = 1;
    std::vector<std::size_t> agents{10, 50, 100, 200, 400};
};

Arguments parse(std::span<char*> words) {
    const char* const usage = "usage: bench_team MAP SCENARIO [--radius R] [--seconds S] [--agents K,K,...]";
    if (words.size() < 3 || words.size() % 2 == 0) throw InputError(usage);
    Arguments arguments{words[1], words[2]};
    for (std::size_t i = 3; i < words.size(); i += 2) {
        const std::string_view option = words[i];
        if (option == "--radius") {
            arguments.radius = std::stod(words[i + 1]);
        } else if (option == "--seconds") {
            arguments.seconds = std::stod(words[i + 1]);
        } else if (option == "--agents") {
            arguments.agents.clear();
            std::istringstream list(words[i + 1]);
            for (std::string count; std::getline(list, count, ',');) arguments.agents.push_back(std::stoul(count));
        } else {
            throw InputError(usage);
        }
    }
    return arguments;
}

double processor_seconds() {
    return double(std::clock()) / CLOCKS_PER_SEC;
}

Mission mission_of(const std::vector<Scenario>& scenarios, std::size_t count, double radius) {
    Mission mission;
    mission.rules.objective = Objective::flowtime;
    for (std::size_t i = 0; i < count; ++i) {
        Agent& agent = mission.agents.emplace_back();
        agent.id = std::to_string(i + 1);
        agent.start = scenarios[i].start;
        agent.goal = scenarios[i].goal;
        agent.body.radius = radius;
    }
    return mission;
}

void run(const Arguments& arguments) {
    std::ifstream map_in(arguments.map, std::ios::binary);
    const Map map(read_movingai_map(map_in, arguments.map));
    std::ifstream scenario_in(arguments.scenario, std::ios::binary);
    const std::vector<Scenario> scenarios = read_movingai_scenarios(scenario_in, arguments.scenario);
    std::printf("%s, radius %g, %g s\n%8s %8s %10s %10s %10s %10s %10s %8s\n", arguments.scenario.c_str(),
                arguments.radius, arguments.seconds, "agents", "solved", "first (s)", "alone", "first", "last", "gap %",
                "judged");
    for (const std::size_t count : arguments.agents) {
        if (count > scenarios.size()) continue;
        const Mission mission = mission_of(scenarios, count, arguments.radius);
        const double start = processor_seconds();
        double first_seconds = 0;
        double first = 0;
        Limits limits{.seconds = arguments.seconds};
        limits.progress = [&](const Progress& known) {
            if (first > 0) return;
            first_seconds = processor_seconds() - start;
            first = known.best;
        };
        const Plan plan = Planner().plan(map, mission, {}, limits);
        if (plan.status != PlanStatus::solved) {
            std::printf("%8zu %8s\n", count, "no");
            continue;
        }
        const double alone = *plan.before.flowtime;
        std::printf("%8zu %8s %10.3f %10.2f %10.4f %10.4f %10.2f %8s\n", count, "yes", first_seconds, alone,
                    first / alone, *plan.after.flowtime / alone, 100 * *plan.gap,
                    check(map, mission, plan).empty() ? "valid" : "INVALID");
        std::fflush(stdout);
    }
}

}  // namespace
}  // namespace waybreaker::bench

int main(int argc, char** argv) {
    using namespace waybreaker::bench;
    return program("bench_team", [&] { run(parse({argv, std::size_t(argc)})); });
}
