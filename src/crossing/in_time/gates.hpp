// Gates: places at the border of an obstacle where the agent waits until it opens.
//
// An obstacle that opens later than the agent gets there is entered wherever the path on from there is shortest: every
// direction is taut there. The border is kept as one group, whose points come out one by one, the most promising first;
// how long the path to a point is, is found out when it is its turn.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "crossing/geometry/border.hpp"

namespace waybreaker::crossing {

class GateGroup {
  public:
    // Times are in half cells. `arrival`: when the agent is at `from`. `early`: how much earlier than at a lattice
    // point it may be at a place of the border that is nearest to that point.
    struct Terms {
        std::uint32_t since = 0;              // label at `from`
        RegionId region;                      // that opens
        std::vector<ObstacleId> opened = {};  // its obstacles that were not crossed before, sorted
        std::uint32_t set = 0;                // of what is crossed then
        Vertex from;
        double arrival = 0;
        double open = 0;
        double early = 0;
        std::vector<std::uint32_t> passed = {};  // groups of what is entered on the way, not before it opens
    };
    GateGroup() = default;
    GateGroup(Terms terms, const Border& border) : terms_(std::move(terms)), border_(&border) {}

    const Terms& terms() const { return terms_; }

    // Lower bound of the cost of a path by any gate of the group. `to_go`: lower bound of the cost to go from the
    // border.
    double first_estimate(double to_go) const;

    struct Gate {
        Vertex at;
        double cost = 0;  // when it is left
        double estimate = 0;
    };
    // Turns to the gate with the least estimate of those left; false if none is. `stands`: whether the agent can be
    // somewhere; `cost_to_go`: a lower bound from there, for a path that has cost so much.
    bool find_best(Vertex goal, const std::function<bool(Vertex)>& stands,
                   const std::function<double(Vertex, double)>& cost_to_go);
    // From now on `cost_to_go` may say less.
    void forget_cost_to_go();
    const Gate& best() const { return best_gate_; }
    // Whether the arrival at the best gate is known, not only a lower bound.
    bool proven() const { return points_[best_].proven; }
    // `arrival`: no path gets there earlier.
    void prove(double arrival) { prove(best_, arrival); }
    void take() { points_[best_].done = true; }

    // Earliest time at v for a path that enters the obstacle anywhere before. `arrival_at`: the same at a point of the
    // border.
    double past(Vertex v, const std::function<bool(Vertex)>& stands, const std::function<double(Vertex)>& arrival_at);

  private:
    struct Point {
        double arrival;     // a lower bound
        double cost_to_go;  // likewise
        bool proven = false;
        bool cost_to_go_known = false;
        bool stands = false;
        bool done = false;
    };
    // A gate that may be the best, with its least cost when it was put into the queue.
    struct Candidate {
        double estimate;
        std::uint32_t point;
        friend auto operator<=>(const Candidate&, const Candidate&) = default;
    };
    bool is_gate(double arrival) const;
    double cost_of(const Point& point) const;
    double estimate_of(std::uint32_t point, Vertex goal) const;
    void open_up(const std::function<bool(Vertex)>& stands);
    void queue_all(Vertex goal);
    void learn_cost_to_go(std::uint32_t point, Vertex goal);
    void prove(std::uint32_t point, double arrival);
    void learn_arrival(std::uint32_t point, double arrival);
    void prove_around(std::uint32_t point, double arrival);

    Terms terms_;
    const Border* border_ = nullptr;
    std::vector<Point> points_;     // as the border's; empty until the first is asked for
    std::vector<Candidate> queue_;  // heap, the least first; may hold points that are done
    bool queued_ = false;
    std::uint32_t best_ = 0;
    Gate best_gate_;
};

}  // namespace waybreaker::crossing
