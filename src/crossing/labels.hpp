// Labels: ways to be at a vertex, and which of them are worth going on from.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "crossing/lattice.hpp"
#include "waybreaker/cell.hpp"

namespace waybreaker::crossing {

inline constexpr std::uint32_t no_label = UINT32_MAX;

// A path from the start to a vertex.
struct Label {
    double cost = 0;      // half cells, driven or waited
    double estimate = 0;  // the least that a path can cost which goes on from there
    Vertex at;
    std::uint32_t parent = no_label;
    std::uint32_t set = 0;           // of the obstacles crossed
    std::uint32_t next = no_label;   // at the same vertex
    std::uint32_t fronts_begin = 0;  // of what it meets straight on; 0, 0: not known
    std::uint32_t fronts_end = 0;
    std::uint32_t since = 0;  // the gate that it comes from, or the start
    std::uint32_t gate = 0;   // the group of the gate that it waits at; 0: it does not wait
    std::uint32_t group = 0;  // not 0: it stands for the gates of a group that are left
    bool dominated = false;
    bool settled = false;  // the estimate knows what may still be crossed in time
};

// The sets of crossed obstacles, each once and in increasing order.
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

// A vertex that a search has looked at.
struct Place {
    Vertex at;
    std::uint32_t labels = no_label;  // the first of its list
};

// Hash table of places, open addressing.
class Places {
  public:
    Places() : slots_(1024, 0) {}

    void clear() {
        places_.clear();
        std::fill(slots_.begin(), slots_.end(), 0);
    }

    std::uint32_t find_or_add(Vertex v) {
        if (2 * places_.size() >= slots_.size()) grow();
        std::size_t slot = hash(v) & (slots_.size() - 1);
        while (slots_[slot] != 0) {
            if (places_[slots_[slot] - 1].at == v) return slots_[slot] - 1;
            slot = (slot + 1) & (slots_.size() - 1);
        }
        places_.push_back({.at = v});
        slots_[slot] = std::uint32_t(places_.size());
        return slots_[slot] - 1;
    }
    Place& operator[](std::uint32_t place) { return places_[place]; }

  private:
    static std::size_t hash(Vertex v) {
        const std::uint64_t key = (std::uint64_t(std::uint32_t(v.x)) << 32) | std::uint32_t(v.y);
        return std::size_t((key * 0x9e3779b97f4a7c15U) >> 29);
    }
    void grow() {
        slots_.assign(2 * slots_.size(), 0);
        for (std::uint32_t place = 0; place < places_.size(); ++place) {
            std::size_t slot = hash(places_[place].at) & (slots_.size() - 1);
            while (slots_[slot] != 0) slot = (slot + 1) & (slots_.size() - 1);
            slots_[slot] = place + 1;
        }
    }

    std::vector<Place> places_;
    std::vector<std::uint32_t> slots_;  // place + 1; 0 is empty
};

}  // namespace waybreaker::crossing
