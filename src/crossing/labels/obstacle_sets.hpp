// Obstacle sets: sets of obstacles, each stored once and known by its number.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "waybreaker/cell.hpp"

namespace waybreaker::crossing {

class ObstacleSets {
  public:
    void clear() {
        members_.clear();
        begins_.assign(1, 0);
        std::ranges::fill(slots_, 0);
    }
    std::uint32_t size() const { return std::uint32_t(begins_.size() - 1); }
    // Its number, which is below size(); the last one if it is new.
    std::uint32_t find_or_add(std::span<const ObstacleId> sorted) {
        if (2 * std::size_t{size()} >= slots_.size()) grow();
        std::size_t slot = hash(sorted) & (slots_.size() - 1);
        while (slots_[slot] != 0) {
            if (std::ranges::equal((*this)[slots_[slot] - 1], sorted)) return slots_[slot] - 1;
            slot = (slot + 1) & (slots_.size() - 1);
        }
        members_.insert(members_.end(), sorted.begin(), sorted.end());
        begins_.push_back(std::uint32_t(members_.size()));
        slots_[slot] = size();
        return size() - 1;
    }
    std::span<const ObstacleId> operator[](std::uint32_t set) const {
        return {members_.data() + begins_[set], members_.data() + begins_[set + 1]};
    }

  private:
    static std::size_t hash(std::span<const ObstacleId> sorted) {
        std::uint64_t key = sorted.size();
        for (const ObstacleId obstacle : sorted) key = (key ^ obstacle.value) * 0x9e3779b97f4a7c15U;
        return std::size_t(key >> 29);
    }
    void grow() {
        slots_.assign(2 * slots_.size(), 0);
        for (std::uint32_t set = 0; set < size(); ++set) {
            std::size_t slot = hash((*this)[set]) & (slots_.size() - 1);
            while (slots_[slot] != 0) slot = (slot + 1) & (slots_.size() - 1);
            slots_[slot] = set + 1;
        }
    }

    std::vector<ObstacleId> members_;
    std::vector<std::uint32_t> begins_{0};
    std::vector<std::uint32_t> slots_ = std::vector<std::uint32_t>(64, 0);  // hash table: set + 1; 0 is empty
};

}  // namespace waybreaker::crossing
