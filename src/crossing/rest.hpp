// Rest: how far it is to the goal at least.
//
// For who may pass all that can be removed: rivers and railways stay, so that is often much more than the straight
// line, and as often nearly all there is to prove. Or for who passes nothing but what is open, where nothing else opens
// in time.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "crossing/fan.hpp"

namespace waybreaker::crossing {

class Rest {
  public:
    enum class Passes { destructible, open };
    // Keeps what it is given for as long as the query lasts. `longest`: of the paths that matter, half cells.
    void start_query(const Regions& regions, Vertex start, Vertex goal, double longest, const CrossingOptions& options,
                     Passes passes, bool pinched, Interrupt& interrupt);

    // These, sorted, are all that is open from now on.
    void open(std::span<const ObstacleId> obstacles);

    // A lower limit, half cells; infinity if no path through v is short enough. `at_most`: a way that is known is so
    // long; it only saves time.
    double from(Vertex v, double at_most = infinity);
    // A lower limit, half cells: the length of a path if that is at most `range`, and soon found.
    double within(Vertex v, double range);
    // Labels expanded since the query began.
    std::uint64_t expanded() const { return expanded_; }
    // Whether something that stays is in the way from v straight to the goal.
    bool detours(Vertex v) { return from(v) > length(goal_ - v) * (1 + rounding); }

  private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    static constexpr double rounding = 1e-11;  // relative
    static constexpr std::size_t most_expanded = 256;

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

    double search(Vertex v, std::size_t patience);
    void push(std::uint32_t parent, Vertex at);
    void expand(std::uint32_t index);
    Known known(Vertex v) const;
    void note(Vertex v, Known rest);
    bool later(std::uint32_t a, std::uint32_t b) const { return labels_[a].estimate > labels_[b].estimate; }
    static std::uint64_t key(Vertex v) { return (std::uint64_t(std::uint32_t(v.x)) << 32) | std::uint32_t(v.y); }
    using KnownRests = std::unordered_map<std::uint64_t, Known>;  // by vertex

    Vertex start_;
    Vertex goal_;
    double longest_ = 0;
    std::vector<ObstacleId> open_obstacles_;  // sorted
    Interrupt* interrupt_ = nullptr;
    Fan fan_;
    std::map<std::vector<ObstacleId>, KnownRests> known_with_;  // by what is open
    KnownRests* known_ = nullptr;                               // of them
    std::uint64_t expanded_ = 0;
    // Of the search from one vertex:
    double range_ = 0;  // longest path, half cells
    std::vector<Label> labels_;
    std::vector<std::uint32_t> open_;                    // heap
    std::unordered_map<std::uint64_t, double> reached_;  // the least cost, by vertex
};

}  // namespace waybreaker::crossing
