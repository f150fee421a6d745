// Ways: what a vehicle can drive with some obstacles open, and when it arrives if these open in time.
#pragma once

#include <map>
#include <numeric>
#include <optional>
#include <vector>

#include "coalition/problem.hpp"
#include "coalition/workers.hpp"

namespace waybreaker::coalition {

// On a way, an obstacle that has to be gone: first touched after driving so long without a stop.
struct Gate {
    ObstacleId obstacle;
    double after = 0;
};

struct Way {
    std::vector<Cell> path;
    double drive = 0;  // without a stop, from when the vehicle is ready
    std::vector<Gate> gates;
    std::uint64_t expanded = 0;
    std::uint64_t generated = 0;
};

// When obstacles of a set are gone.
using Openings = std::map<ObstacleId, double>;

// Alone, with a stop before every gate that is not open yet; without openings, all are.
double arrival(const Agent& agent, const Way& way, const Openings& openings);

// For two vehicles, two workers may use it at once.
class Ways {
  public:
    // The vehicles, each with its way past all obstacles, or with none.
    Ways(const Problem& problem, std::span<const team::Vehicle> closed);

    // Of a vehicle with a set removed sooner or later: a way for each part of the set that is worth having open. Stays
    // where it is.
    const std::vector<Way>& of(std::size_t vehicle, const Set& set, Worker& worker);
    // Whether that takes no search.
    bool knows(std::size_t vehicle, const Set& set) const;

    // Looks for a way of a vehicle that is earlier than that, obstacles of a set being gone at certain times: who has
    // to wait anyway waits where the rest of the way is shortest. Whether there is one; it is among its ways from then
    // on. `thorough`: also by bends of known ways.
    bool find_timed(std::size_t vehicle, const Set& set, const Openings& openings, double arrive_before, bool thorough,
                    Worker& worker);

    // Has a path of the vehicle's own mission among its ways through that set. Not where it is longer than the way past
    // all obstacles, or the vehicle is none that the crossing search drives. Whether it has.
    bool add(std::size_t vehicle, const Set& set, std::span<const Point> path, Worker& worker);

    // Of all that was done so far: labels of searches and paths judged, as many as take as long.
    std::uint64_t effort() const { return std::accumulate(effort_.begin(), effort_.end(), std::uint64_t{0}); }

  private:
    struct Menu {
        std::vector<Way> ways;
        bool complete = true;  // no limit has ended the search
    };
    double longest(std::size_t vehicle) const;
    Set near(std::size_t vehicle, const Set& set) const;
    const Menu* larger_menu(std::size_t vehicle, const Set& part) const;
    Menu search(std::size_t vehicle, const Set& set, Worker& worker);
    CrossingOptions options_for(std::size_t vehicle, const Set& set) const;
    void search_crossing(std::size_t vehicle, const Set& set, Menu& menu, Worker& worker);
    void search_each(std::size_t vehicle, const Set& set, Menu& menu, Worker& worker);
    std::vector<Set> gaining(std::size_t vehicle, const Set& set, bool relaxed, Menu& menu, Worker& worker);
    std::vector<Way> waiting(std::size_t vehicle, const Set& part, const Openings& openings, double arrive_before);
    std::optional<Way> search_timed(std::size_t vehicle, const Set& part, const Openings& openings,
                                    double arrive_before, Worker& worker);
    Way punctual_way(const OpenedMap& opened, std::size_t vehicle, const Way& way, const Set& part,
                     const Openings& openings);
    Way stay(std::size_t vehicle) const;
    Way closed_way(std::size_t vehicle) const;
    Way way_of(const Agent& agent, std::span<const Point> path, std::span<const ObstacleId> set) const;
    std::vector<Point> shorter(const Agent& agent, std::vector<Point> path, std::span<const ObstacleId> crossed) const;

    const Problem& problem_;
    std::span<const team::Vehicle> closed_;
    std::vector<std::uint64_t> effort_;       // by vehicle
    std::vector<crossing::Memory> memories_;  // by vehicle
    std::vector<std::map<Set, Menu>> known_;  // by vehicle and the part of a set that is near its way
    // By vehicle: such parts, and when they open, for which ways were looked for; and whether thoroughly.
    std::vector<std::map<std::vector<std::pair<ObstacleId, double>>, bool>> timed_;
};

}  // namespace waybreaker::coalition
