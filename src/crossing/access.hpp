// What the planner's own parts ask of a crossing searcher beside what programs may.
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "waybreaker/advanced/crossing.hpp"

namespace waybreaker::crossing {

class PathLengths;

// Whoever opens the obstacles in time, and when they are done.
struct Opener {
    // What `opened_after` says of several is the latest that it says of one of them. The search is faster then: of what
    // is crossed and left, only the number and the prices matter.
    bool opens_each_alone = false;
    // How many cells the agent could drive until their whole mission is over, none below 0. A path costs no less;
    // `adds_both`: it costs the sum of both.
    std::function<double(std::span<const ObstacleId>)> done_after = {};
    bool adds_both = false;
};

// What queries have found out that helps later ones on the same map. How many labels those count as expanded, and where
// a limit ends them, depends on it.
class Memory {
  public:
    Memory();
    ~Memory();
    Memory(Memory&&) noexcept;
    Memory& operator=(Memory&&) noexcept;

  private:
    friend struct Access;
    std::unique_ptr<PathLengths> lengths_;
};

struct Access {
    // As the searcher's own. They throw InputError on answers of `done_after` that are out of range, too.
    static CrossingResult find(CrossingSearcher& searcher, const Map& map, Cell start, Cell goal,
                               const CrossingOptions& options, const Opener& opener);
    static CrossingResult enumerate(CrossingSearcher& searcher, const Map& map, Cell start, Cell goal,
                                    const CrossingOptions& options, const Opener& opener,
                                    const std::function<bool(const CrossingPath&)>& accept);

    // Another searcher, for queries while this one is busy, that shares the maps grown for wide bodies.
    static CrossingSearcher another(const CrossingSearcher& searcher);
    // The searcher goes on with that memory, and gives away its own.
    static void exchange(CrossingSearcher& searcher, Memory& memory);
};

}  // namespace waybreaker::crossing
