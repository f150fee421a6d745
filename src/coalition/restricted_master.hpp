// Restricted master problem: the best set of obstacles for the columns in the pools; as if aircraft worked for each
// vehicle alone, and collisions aside. Solved greedily, then by exchanges: quickly, without proof.
#pragma once

#include <vector>

#include "coalition/columns.hpp"

namespace waybreaker::coalition {

class RestrictedMaster {
  public:
    // Columns must outlive it and not change meanwhile.
    RestrictedMaster(const Problem& problem, const Columns& columns);

    // Greedy by gain for each obstacle, whole columns at a time, from a set on; then exchanges of one obstacle for
    // others, while that gains. The same each time.
    Set best_from(const Set& start);

  private:
    bool is_open(std::size_t number) const { return open_[number] != 0; }
    double arrival(std::size_t vehicle) const;
    double objective() const;
    bool fits(const std::vector<std::uint32_t>& more) const;
    bool add_best();
    void set_open(const Set& set);
    Set opened() const;

    const Problem& problem_;
    const Columns& columns_;
    std::vector<ObstacleId> numbered_;
    std::vector<std::vector<std::vector<std::uint32_t>>> sets_;  // by vehicle and column, in numbers
    std::vector<std::vector<std::uint32_t>> vehicles_of_;        // by number
    std::vector<std::vector<std::uint32_t>> offers_;             // what may be opened at once: sets of columns
    std::vector<char> open_;
    std::vector<double> arrivals_;  // by vehicle, with what is open
};

}  // namespace waybreaker::coalition
