// How many nodes searches expand and generate, over maps full of equal distances. The numbers in counts.txt are those
// of every compiler and standard library: where they differ, the order of equals depends on how a library sorts.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "waybreaker/advanced.hpp"
#include "waybreaker/waybreaker.hpp"

namespace {

using namespace waybreaker;

constexpr int side = 144;
constexpr std::uint64_t most = 2000;  // expansions of a search

class Drawn {
  public:
    explicit Drawn(std::uint64_t seed) : random_(seed), map_(city()) {}

    const Map& map() const { return map_; }
    int below(int limit) { return random_.below(limit); }
    template <class Value, std::size_t Count>
    Value one_of(const std::array<Value, Count>& values) {
        return values[std::size_t(below(int(Count)))];
    }

    // With a free cell around it.
    Cell place() {
        for (;;) {
            Cell at;
            at.x = 1 + below(side - 2);
            at.y = 1 + below(side - 2);
            bool free = true;
            for (int i = 0; i < 9; ++i) free = free && !map_.obstacle_at({at.x - 1 + i % 3, at.y - 1 + i / 3});
            if (free) return at;
        }
    }

    Mission pair() {
        Mission mission;
        const Cell start = place();
        const Cell goal = place();
        mission.agents = {vehicle("rover", start, goal), aircraft("drone", below(2) == 0 ? start : place(), goal)};
        mission.agents.front().body.radius = one_of<double, 5>({0, 0.5, 0.5, 1, 2});
        mission.agents.back().speed = one_of<double, 3>({1, 1, 3});
        rule(mission);
        return mission;
    }

    Mission team() {
        Mission mission;
        for (int i = 2 + below(3); i > 0; --i) {
            const Cell start = place();
            const Cell goal = place();
            mission.agents.push_back(vehicle("rover " + std::to_string(i), start, goal));
        }
        for (int i = below(3); i > 0; --i) mission.agents.push_back(aircraft("drone " + std::to_string(i), place()));
        rule(mission);
        return mission;
    }

  private:
    // Blocks with streets between them, cut into pieces that touch; and two rivers with a bridge each, so that straight
    // lines say little of what is left to go.
    Map city() {
        std::vector<std::uint32_t> labels(side * side);
        std::vector<ObstacleAttributes> obstacles(1);
        for (const int x : {side / 3, 2 * side / 3}) {
            const int bridge = below(side - 8);
            obstacles.push_back({.destructible = false});
            for (int y = 0; y < side; ++y) {
                if (y >= bridge && y < bridge + 8) continue;
                for (int i = 0; i < 3; ++i) labels[std::size_t(y * side + x + i)] = std::uint32_t(obstacles.size() - 1);
            }
        }
        for (int block = 0; block < 160; ++block) {
            const Cell corner{2 * below(side / 2), 2 * below(side / 2)};
            const int width = 2 + 2 * below(8);
            const int height = 2 + 2 * below(8);
            const auto first = std::uint32_t(obstacles.size());
            for (int piece = 0; piece < 2; ++piece) {
                obstacles.push_back({.destructible = below(8) > 0, .weight = 1.0 + below(3)});
            }
            for (int y = corner.y; y < std::min(corner.y + height, side); ++y) {
                for (int x = corner.x; x < std::min(corner.x + width, side); ++x) {
                    labels[std::size_t(y * side + x)] = first + (2 * (x - corner.x) < width ? 0 : 1);
                }
            }
        }
        return Map::from_labels(side, side, std::move(labels), obstacles);
    }

    void rule(Mission& mission) {
        mission.rules.removals = below(4);
        mission.rules.breach_time.per_obstacle = one_of<double, 4>({0, 3, 8, 20});
        mission.rules.objective =
            one_of<Objective, 3>({Objective::makespan, Objective::flowtime, Objective::ground_makespan});
        if (below(5) == 0) mission.rules.budget = 3;
    }

    Random random_;
    Map map_;
};

void print(const Expected<Plan>& plan) {
    if (!plan) {
        std::cout << ' ' << to_string(plan.error().code) << '\n';
        return;
    }
    std::cout << ' ' << to_string(plan->status);
    for (const Outcome* outcome : {&plan->before, &plan->after}) {
        for (const Route& route : outcome->routes) std::cout << ' ' << route.expanded << '/' << route.generated;
    }
    for (const Breach& breach : plan->breaches) std::cout << ' ' << breach.obstacle.value;
    std::cout << '\n';
}

// Crossing paths where each obstacle opens later than the one before.
void print_crossings(Drawn& drawn, CrossingSearcher& searcher) {
    const Cell start = drawn.place();
    const Cell goal = drawn.place();
    for (const double radius : {0.0, 0.5, 1.0}) {
        CrossingOptions options;
        options.body.radius = radius;
        options.crossings = 2;
        options.limits.expansions = most;
        options.opened_after = [](std::span<const ObstacleId> open) {
            double at = 0;
            for (const ObstacleId obstacle : open) at += 10 + 5 * double(obstacle.value % 4);
            return at;
        };
        const CrossingResult found = searcher.find(drawn.map(), start, goal, options);
        std::cout << ' ' << found.expanded << '/' << found.generated;
    }
    std::cout << '\n';
}

}  // namespace

int main() {
    Planner planner;
    CrossingSearcher searcher;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        Drawn drawn(seed);
        for (int i = 0; i < 3; ++i) {
            std::cout << seed << " pair";
            print(planner.try_plan(drawn.map(), drawn.pair(), {}, {.expansions = most}));
        }
        std::cout << seed << " team";
        print(planner.try_plan(drawn.map(), drawn.team(), {}, {.expansions = most, .gap = 0.01}));
        std::cout << seed << " crossings";
        print_crossings(drawn, searcher);
        std::cout << seed << " crossings";
        print_crossings(drawn, searcher);
    }
}
