// Cost to go: lower bounds of the length of paths from a vertex to the goal.
//
// Two kinds: for paths through all that can be removed (rivers and railways stay, so that is often much more than the
// straight line, and as often nearly all there is to prove); and for paths through nothing but what is open, where
// nothing else opens in time.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "crossing/geometry/fan.hpp"
#include "crossing/labels/query.hpp"

namespace waybreaker::crossing {

class CostToGo {
  public:
    enum class Passes { destructible, open };
    // Keeps what it is given for as long as the query lasts.
    void start_query(const CrossingQuery& query, Passes passes, Interrupt& interrupt);
    // Until the next query the straight line is bound enough.
    void use_straight_line(Vertex goal);
    bool is_straight_line() const { return straight_; }

    // From now on these obstacles, sorted, are all that is open.
    void open(std::span<const ObstacleId> obstacles);

    // A lower bound, half cells; infinity if no path through v is short enough. `at_most`: the length of a known path,
    // which only saves time.
    double from(Vertex v, double at_most = infinity) { return straight_ ? length(goal_ - v) : detour_from(v, at_most); }
    // A lower bound, half cells: the length of a path if that is at most `range`, and soon found.
    double within(Vertex v, double range);
    // Labels expanded since the query began.
    std::uint64_t expanded() const { return expanded_; }

  private:
    static constexpr double rounding = 1e-11;  // relative

    struct Known {
        double least = 0;
        bool exact = false;
    };
    struct Label {
        Vertex at;
        double cost = 0;
        double estimate = 0;
        std::uint32_t parent = 0;  // of the first: itself
        bool exact = false;        // the estimate is the length of a path
    };

    double detour_from(Vertex v, double at_most);
    double search(Vertex v, std::size_t expansions);
    void push(std::uint32_t parent, Vertex at);
    void expand(std::uint32_t index);
    Known known(Vertex v) const;
    void learn(Vertex v, Known bound);
    bool later(std::uint32_t a, std::uint32_t b) const {
        return labels_[a].estimate != labels_[b].estimate ? labels_[a].estimate > labels_[b].estimate : a < b;
    }
    static std::uint64_t key(Vertex v) { return (std::uint64_t(std::uint32_t(v.x)) << 32) | std::uint32_t(v.y); }
    using KnownBounds = std::unordered_map<std::uint64_t, Known>;  // by vertex

    Vertex start_;
    Vertex goal_;
    bool straight_ = false;
    double longest_ = 0;                      // path that matters, half cells
    std::vector<ObstacleId> open_obstacles_;  // sorted
    Interrupt* interrupt_ = nullptr;
    Fan fan_;
    std::map<std::vector<ObstacleId>, KnownBounds> known_with_;  // by what is open
    KnownBounds* known_ = nullptr;                               // of them
    std::uint64_t expanded_ = 0;
    // Search from one vertex:
    double range_ = 0;  // length of the longest path, half cells
    std::vector<Label> labels_;
    std::vector<std::uint32_t> open_;                    // heap
    std::unordered_map<std::uint64_t, double> reached_;  // the least cost, by vertex
};

}  // namespace waybreaker::crossing
