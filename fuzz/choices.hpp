// A fuzzer's input as choices, and small label maps and rules made of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "waybreaker/mission.hpp"

namespace waybreaker {

// The input as choices, one byte each; zeros once it has ended.
class Choices {
  public:
    Choices(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}

    int below(int count) { return next_ == end_ ? 0 : *next_++ % count; }
    bool one_in(int count) { return below(count) == count - 1; }
    template <class T, std::size_t count>
    T of(const std::array<T, count>& all) {
        return all[std::size_t(below(int(count)))];
    }
    Cell cell(const Map& map) { return {below(map.width()), below(map.height())}; }

  private:
    const std::uint8_t* next_;
    const std::uint8_t* end_;
};

// At most so wide and so high, and at least 2.
inline Map any_map(Choices& choices, int most_wide, int most_high) {
    constexpr int most_labels = 4;
    const int width = 2 + choices.below(most_wide - 1);
    const int height = 2 + choices.below(most_high - 1);
    std::array<ObstacleAttributes, most_labels + 1> attributes;
    for (ObstacleAttributes& known : attributes) {
        known.destructible = !choices.one_in(8);
        known.weight = choices.of(std::array{1.0, 1.0, 0.5, 3.0});
        known.breach_time = choices.of(std::array{0.0, 0.0, 2.0});
    }
    std::vector<std::uint32_t> labels(std::size_t(width * height));
    for (std::uint32_t& label : labels) label = choices.one_in(2) ? std::uint32_t(1 + choices.below(most_labels)) : 0;
    return Map::from_labels(width, height, labels, attributes);
}

// What may be removed, what it takes, and what is to be small.
inline void set_rules(Choices& choices, const Map& map, int most_removals, Rules& rules) {
    rules.removals = choices.below(most_removals + 1);
    rules.objective = choices.of(std::array{Objective::makespan, Objective::flowtime, Objective::ground_makespan});
    rules.breach_time = {choices.of(std::array{0.0, 1.0, 4.5}), choices.of(std::array{0.0, 0.0, 0.3})};
    if (choices.one_in(4)) rules.budget = choices.of(std::array{0.0, 1.0, 2.5, 4.0});
    for (const Obstacle& obstacle : map.obstacles()) {
        const int rule = choices.below(12);
        if (rule == 10) rules.force.push_back(obstacle.id);
        if (rule == 11) rules.protect.push_back(obstacle.id);
    }
}

}  // namespace waybreaker
