#include "map/label.hpp"

#include <algorithm>

#include "map/bit_run.hpp"
#include "map/map_size.hpp"

namespace waybreaker {
namespace {

struct Run {
    int first;
    int last;
    std::uint32_t index;
};

// Union-find over runs in scan order. A root is always the earliest run of its set, so roots come in scan order too.
class RunSets {
  public:
    std::uint32_t add() {
        parent_.push_back(std::uint32_t(parent_.size()));
        return parent_.back();
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }
    // Numbers the sets from 1 in order of their roots and replaces each run's parent by its number. How many there are.
    std::uint32_t number() {
        std::uint32_t sets = 0;
        for (std::uint32_t run = 0; run < parent_.size(); ++run) {
            parent_[run] = parent_[run] == run ? ++sets : parent_[parent_[run]];
        }
        return sets;
    }
    std::uint32_t number_of(std::uint32_t run) const { return parent_[run]; }

  private:
    std::uint32_t root(std::uint32_t run) {
        while (parent_[run] != run) {
            parent_[run] = parent_[parent_[run]];
            run = parent_[run];
        }
        return run;
    }
    std::vector<std::uint32_t> parent_;
};

RunSets joined_runs(const Grid& grid, Connectivity connectivity) {
    const int slack = connectivity == Connectivity::eight ? 1 : 0;
    RunSets sets;
    std::vector<Run> above;
    std::vector<Run> here;
    for (int y = 0; y < grid.height(); ++y) {
        here.clear();
        auto touching = above.begin();
        for_each_run(grid.row(y), grid.width(), [&](int first, int last) {
            const std::uint32_t index = sets.add();
            while (touching != above.end() && touching->last + slack < first) ++touching;
            for (auto run = touching; run != above.end() && run->first <= last + slack; ++run)
                sets.join(run->index, index);
            here.push_back({first, last, index});
        });
        std::swap(above, here);
    }
    return sets;
}

}  // namespace

std::size_t count_obstacles(const Grid& grid, Connectivity connectivity) {
    return joined_runs(grid, connectivity).number();
}

std::vector<std::uint32_t> label_components(const Grid& grid, Connectivity connectivity) {
    RunSets sets = joined_runs(grid, connectivity);
    sets.number();
    std::vector<std::uint32_t> labels(grid.cell_count(), 0);
    std::uint32_t run = 0;
    for (int y = 0; y < grid.height(); ++y) {
        std::uint32_t* row = labels.data() + std::size_t(y) * std::size_t(grid.width());
        for_each_run(grid.row(y), grid.width(),
                     [&](int first, int last) { std::fill(row + first, row + last + 1, sets.number_of(run++)); });
    }
    return labels;
}

}  // namespace waybreaker
