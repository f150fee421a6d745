// The choice of obstacles where too many sets exist to try each (more than 128): prices and branch and bound, against
// every set. What a set is worth is found by means of its own: paths by relaxing every straight move again and again,
// tours of the aircraft by dynamic programming over subsets and cells.
//
// Vehicles drive in rooms side by side, so that none is in another's way. An obstacle may have a part in each of two
// rooms, so what opens the way of one may open that of another.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <random>

#include "checked_plan.hpp"
#include "coalition/all_sets.hpp"
#include "model/timeline.hpp"
#include "plain_map.hpp"
#include "vehicle.hpp"
#include "waybreaker/planner.hpp"

namespace waybreaker {
namespace {

constexpr double unreachable = std::numeric_limits<double>::infinity();
constexpr int room_width = 9;
constexpr int room_height = 5;

struct World {
    Map map;
    Mission mission;
};

class Draw {
  public:
    explicit Draw(std::uint32_t seed) : random_(seed) {}
    int below(int count) { return int(random_() % unsigned(count)); }
    bool one_in(int count) { return below(count) == 0; }
    template <class Item, std::size_t count>
    Item of(const std::array<Item, count>& items) {
        return items[std::size_t(below(int(count)))];
    }

  private:
    std::mt19937 random_;
};

// Three upright walls in each room; a wall has two halves, each a part of some obstacle, and at times a gap.
PlainMap any_rooms(Draw& draw, int rooms, int obstacles) {
    PlainMap plain{rooms * (room_width + 1) - 1, room_height, {}};
    plain.obstacles.assign(std::size_t(plain.width) * std::size_t(plain.height), 0);
    for (int room = 0; room < rooms; ++room) {
        const int left = room * (room_width + 1);
        for (int y = 0; room > 0 && y < room_height; ++y) plain.obstacles[plain.index({left - 1, y})] = 1;
        for (int x = left + 2; x < left + room_width - 1; x += 2) {
            const int middle = 1 + draw.below(room_height - 1);
            const int upper = 2 + draw.below(obstacles);
            const int lower = 2 + draw.below(obstacles);
            const bool has_gap = draw.one_in(3);
            const int gap = draw.below(room_height);
            for (int y = 0; y < room_height; ++y) {
                if (has_gap && y == gap) continue;
                plain.obstacles[plain.index({x, y})] = std::uint32_t(y < middle ? upper : lower);
            }
        }
    }
    return plain;
}

void add_vehicles(Draw& draw, int rooms, Mission& mission) {
    for (int room = 0; room < rooms; ++room) {
        const int left = room * (room_width + 1);
        const int from = draw.below(room_height);
        const int to = draw.below(room_height);
        Agent agent = vehicle(std::to_string(room), {left, from}, {left + room_width - 1, to});
        agent.speed = draw.of(std::array{1.0, 1.0, 2.0, 0.5});
        agent.ready_at = draw.of(std::array{0.0, 0.0, 3.0});
        mission.agents.push_back(agent);
    }
}

// Removed obstacles were never there.
World any_world_without_times(std::uint32_t seed) {
    Draw draw(seed);
    const int rooms = 2 + draw.below(2);
    const int obstacles = 9 + draw.below(2);
    const PlainMap plain = any_rooms(draw, rooms, obstacles);
    std::vector<ObstacleAttributes> attributes(std::size_t(obstacles) + 2);
    attributes[1].destructible = false;
    const bool weighed = draw.one_in(4);
    for (ObstacleAttributes& one : attributes) one.weight = weighed ? 1 + draw.below(3) : 1;
    World world{Map::from_labels(plain.width, plain.height, plain.obstacles, attributes), {}};
    Rules& rules = world.mission.rules;
    rules.timing = Timing::ignore;
    rules.removals = 3 + draw.below(2);
    rules.objective = draw.of(std::array{Objective::flowtime, Objective::makespan, Objective::ground_makespan});
    rules.breach_time.per_obstacle = draw.below(2);
    if (weighed) rules.budget = 4 + draw.below(5);
    add_vehicles(draw, rooms, world.mission);
    const int aircraft_count = 1 + draw.below(2);
    for (int i = 0; i < aircraft_count; ++i) {
        const int from = draw.below(plain.width);
        const int to = draw.below(plain.width);
        const double speed = draw.of(std::array{2.0, 5.0, 20.0});
        world.mission.agents.push_back(aircraft("air" + std::to_string(i), {from, 0}, {to, 4}, speed));
        if (draw.one_in(4)) world.mission.agents.back().breaches = 2;
    }
    return world;
}

// In time, with an aircraft at one base for each removal: each breaches one obstacle from the cell nearest to the base,
// as early as that can be, and is home as early as that can be. No plan is better for the ground agents or the last.
World any_world_in_time(std::uint32_t seed) {
    World world = any_world_without_times(seed);
    Draw draw(seed + 1'000'000);
    Rules& rules = world.mission.rules;
    rules.timing = Timing::enforce;
    rules.objective = draw.of(std::array{Objective::makespan, Objective::ground_makespan});
    rules.breach_time.per_obstacle = draw.of(std::array{0, 0, 4});
    std::erase_if(world.mission.agents, [](const Agent& agent) { return agent.kind == AgentKind::air; });
    const Cell base{draw.below(world.map.width()), draw.below(room_height)};
    const double speed = draw.of(std::array{1.0, 2.0, 10.0});
    for (int i = 0; i < rules.removals; ++i) {
        world.mission.agents.push_back(aircraft("air" + std::to_string(i), base, base, speed));
    }
    return world;
}

using Bits = std::uint32_t;  // a set of obstacles, by id - 1

// The straight moves of a vehicle between cells, and for each the obstacles that it touches.
class RoomMoves {
  public:
    RoomMoves(const Map& map, const Agent& agent, Cell first, Cell last) : agent_(agent) {
        std::vector<ObstacleId> all;
        for (const Obstacle& obstacle : map.obstacles()) {
            if (obstacle.destructible) all.push_back(obstacle.id);
        }
        std::vector<OpenedMap> but_one;
        for (const ObstacleId id : all) {
            std::vector<ObstacleId> others = all;
            std::erase(others, id);
            but_one.emplace_back(map, others);
        }
        for (Cell c = first; c.y <= last.y; ++c.y) {
            for (c.x = first.x; c.x <= last.x; ++c.x) cells_.push_back(c);
        }
        const OpenedMap opened(map, all);
        for (std::size_t a = 0; a < cells_.size(); ++a) {
            for (std::size_t b = 0; b < cells_.size(); ++b) {
                if (a == b || !line_of_sight(opened, cells_[a], cells_[b], agent.body)) continue;
                Move move{a, b, distance(cells_[a], cells_[b]) / agent.speed};
                const std::vector<Waypoint> path{{double(cells_[a].x), double(cells_[a].y), 0},
                                                 {double(cells_[b].x), double(cells_[b].y), move.lasts}};
                for (std::size_t k = 0; k < all.size(); ++k) {
                    if (line_of_sight(but_one[k], cells_[a], cells_[b], agent.body)) continue;
                    move.needs |= Bits{1} << (all[k].value - 1);
                    const auto touched = first_touch(map, all[k], path, agent.body.radius);
                    move.touched.emplace_back(all[k].value, touched.value_or(unreachable));
                }
                moves_.push_back(std::move(move));
            }
        }
    }

    // The earliest arrival, those obstacles being gone at certain times (by id), and no others.
    double arrival(Bits set, const std::vector<double>& openings) const {
        std::vector<double> reached(cells_.size(), unreachable);
        reached[place_of(agent_.start)] = agent_.ready_at;
        for (bool changed = true; changed;) {
            changed = false;
            for (const Move& move : moves_) {
                if ((move.needs & ~set) != 0 || reached[move.from] == unreachable) continue;
                double leaves = reached[move.from];
                for (const auto& [id, after] : move.touched) leaves = std::max(leaves, openings[id] - after);
                if (leaves + move.lasts >= reached[move.to]) continue;
                reached[move.to] = leaves + move.lasts;
                changed = true;
            }
        }
        return reached[place_of(agent_.goal)];
    }

  private:
    struct Move {
        std::size_t from;
        std::size_t to;
        double lasts;
        Bits needs = 0;
        std::vector<std::pair<std::size_t, double>> touched = {};  // by id: how long after it has begun
    };
    std::size_t place_of(Cell c) const { return std::size_t(std::ranges::find(cells_, c) - cells_.begin()); }

    const Agent& agent_;
    std::vector<Cell> cells_;
    std::vector<Move> moves_;
};

// When an aircraft is home that breaches each of a set, at the earliest; by set. Sets of more than `most` are left out.
std::vector<double> flights(const Map& map, const Mission& mission, const Agent& agent) {
    const std::size_t count = map.obstacles().size();
    const int most = int(std::min<std::int64_t>(agent.breaches, mission.rules.removals));
    std::vector<std::vector<Cell>> cells;
    for (const Obstacle& obstacle : map.obstacles()) cells.push_back(map.boundary(obstacle.id));
    const auto stay = [&](std::size_t k) { return mission.rules.breach_time.of(map.obstacles()[k]); };
    std::vector<double> home(std::size_t{1} << count, unreachable);
    home[0] = distance(agent.start, agent.goal) / agent.speed;
    // By set, its last obstacle and the cell that this is breached from: when it is gone.
    std::vector<std::vector<std::vector<double>>> gone(home.size());
    for (Bits set = 1; set < home.size(); ++set) {
        if (std::popcount(set) > most) continue;
        gone[set].resize(count);
        for (std::size_t k = 0; k < count; ++k) {
            if ((set >> k & 1U) == 0) continue;
            const Bits before = set & ~(Bits{1} << k);
            for (const Cell at : cells[k]) {
                double there = before == 0 ? distance(agent.start, at) / agent.speed : unreachable;
                for (std::size_t j = 0; before != 0 && j < count; ++j) {
                    for (std::size_t c = 0; c < gone[before][j].size(); ++c) {
                        there = std::min(there, gone[before][j][c] + distance(cells[j][c], at) / agent.speed);
                    }
                }
                gone[set][k].push_back(there + stay(k));
                home[set] = std::min(home[set], there + stay(k) + distance(at, agent.goal) / agent.speed);
            }
        }
    }
    return home;
}

class ChoiceJudge {
  public:
    explicit ChoiceJudge(const World& world) : map_(world.map), mission_(world.mission) {
        int room = 0;
        for (const Agent& agent : mission_.agents) {
            if (agent.kind == AgentKind::ground) {
                const int left = room++ * (room_width + 1);
                moves_.emplace_back(map_, agent, Cell{left, 0}, Cell{left + room_width - 1, room_height - 1});
            } else if (!in_time()) {
                flights_.push_back(flights(map_, mission_, agent));
            }
        }
        openings_.assign(map_.obstacles().size() + 1, 0);
        for (const Obstacle& obstacle : map_.obstacles()) {
            if (in_time()) openings_[obstacle.id.value] = hop(obstacle.id) + stay(obstacle.id);
        }
    }

    double best() const {
        double best = unreachable;
        for (Bits set = 0; set < Bits{1} << map_.obstacles().size(); ++set) {
            if (is_allowed(set)) best = std::min(best, worth(set));
        }
        return best;
    }

  private:
    bool in_time() const { return mission_.rules.timing == Timing::enforce; }
    double stay(ObstacleId id) const { return mission_.rules.breach_time.of(map_.obstacle(id)); }

    // From the base of all aircraft to where it is nearest.
    double hop(ObstacleId id) const {
        const Agent& agent = mission_.agents.back();
        double least = unreachable;
        for (const Cell c : map_.boundary(id)) least = std::min(least, distance(agent.start, c) / agent.speed);
        return least;
    }

    bool is_allowed(Bits set) const {
        if (std::popcount(set) > mission_.rules.removals) return false;
        double weight = 0;
        for (const Obstacle& obstacle : map_.obstacles()) {
            if ((set >> (obstacle.id.value - 1) & 1U) == 0) continue;
            if (!obstacle.destructible) return false;
            weight += obstacle.weight;
        }
        return weight <= mission_.rules.budget;
    }

    double worth(Bits set) const {
        double sum = 0;
        double last = 0;
        for (const RoomMoves& moves : moves_) {
            const double arrival = moves.arrival(set, openings_);
            sum += arrival;
            last = std::max(last, arrival);
        }
        switch (mission_.rules.objective) {
            case Objective::flowtime:
                return sum + home(set, 0, false);
            case Objective::makespan:
                return std::max(last, home(set, 0, true));
            case Objective::ground_makespan:
                break;
        }
        return home(set, 0, true) < unreachable ? last : unreachable;
    }

    // When the aircraft from a certain one on are home that breach a set: the last of them, or all together.
    double home(Bits set, std::size_t first, bool last) const {
        if (in_time()) {
            double time = 0;
            for (const Obstacle& obstacle : map_.obstacles()) {
                const bool is_in = (set >> (obstacle.id.value - 1) & 1U) != 0;
                if (is_in) time = std::max(time, 2 * hop(obstacle.id) + stay(obstacle.id));
            }
            return time;
        }
        if (first == flights_.size()) return set == 0 ? 0 : unreachable;
        double least = unreachable;
        for (Bits share = set;; share = (share - 1) & set) {
            const double own = flights_[first][share];
            const double others = own == unreachable ? unreachable : home(set & ~share, first + 1, last);
            least = std::min(least, last ? std::max(own, others) : own + others);
            if (share == 0) return least;
        }
    }

    const Map& map_;
    const Mission& mission_;
    std::vector<RoomMoves> moves_;
    std::vector<std::vector<double>> flights_;  // by aircraft and set
    std::vector<double> openings_;              // by id
};

// Whether more sets may be removed than are tried one by one.
bool has_many_sets(const World& world) {
    constexpr std::size_t most_sets = 128;
    const team::Interrupts interrupts{Deadline(), {}};
    const coalition::Problem problem(world.map, world.mission, interrupts);
    CrossingSearcher crossing;
    Searcher theta;
    coalition::Workers workers(problem, crossing, theta);
    const coalition::Columns columns(problem, workers, coalition::Shape::relaxed);
    return coalition::all_sets(problem, columns, most_sets).empty();
}

struct Tally {
    int solvable = 0;
    int solved = 0;
    int removing = 0;
    int best = 0;
    double worst = 0;
};

// No plan may be better than the best, and no bound above it.
Tally judge(World draw(std::uint32_t seed), std::uint32_t seeds) {
    Tally tally;
    for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
        const World world = draw(seed);
        if (!has_many_sets(world)) continue;
        const double best = ChoiceJudge(world).best();
        const Plan plan = Planner().plan(world.map, world.mission);
        EXPECT_TRUE(is_valid(world.map, world.mission, plan)) << seed;
        EXPECT_TRUE(plan.status != PlanStatus::solved || best != unreachable) << seed;
        EXPECT_TRUE(plan.status != PlanStatus::no_plan || best == unreachable) << seed;
        tally.solvable += best != unreachable ? 1 : 0;
        if (plan.status != PlanStatus::solved) continue;
        const double reached = *value(plan.after, world.mission.rules.objective);
        EXPECT_LE(*plan.bound, best + 1e-6) << seed;
        EXPECT_GE(reached, best - 1e-6) << seed;
        ++tally.solved;
        tally.removing += plan.breaches.empty() ? 0 : 1;
        tally.best += reached <= best + 1e-6 ? 1 : 0;
        tally.worst = std::max(tally.worst, reached / best - 1);
    }
    return tally;
}

// The choice is no proof: of 60 and 70 such worlds (300 drawn) 55 and 61 have the best plan.
TEST(ChoiceOracle, MostlyFindsTheBestOfManySets) {
    const Tally tally = judge(any_world_without_times, 300);
    EXPECT_GE(tally.solvable, 50);
    EXPECT_EQ(tally.solved, tally.solvable);
    EXPECT_GE(tally.removing, 50);
    EXPECT_GE(tally.best, tally.solvable * 90 / 100) << "of " << tally.solvable;
    EXPECT_LE(tally.worst, 0.3);
}

TEST(ChoiceOracle, MostlyFindsTheBestOfManySetsInTime) {
    const Tally tally = judge(any_world_in_time, 300);
    EXPECT_GE(tally.solvable, 60);
    EXPECT_EQ(tally.solved, tally.solvable);
    EXPECT_GE(tally.removing, 60);
    EXPECT_GE(tally.best, tally.solvable * 86 / 100) << "of " << tally.solvable;
    EXPECT_LE(tally.worst, 0.3);
}

}  // namespace
}  // namespace waybreaker
