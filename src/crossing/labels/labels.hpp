// Labels: paths from the start to a vertex, those of each vertex, and the open list.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "crossing/geometry/fan.hpp"
#include "crossing/geometry/lattice.hpp"

namespace waybreaker::crossing {

inline constexpr std::uint32_t no_label = UINT32_MAX;

// A path from the start to a vertex.
struct Label {
    double cost = 0;      // half cells, driven or waited
    double estimate = 0;  // the least that a path can cost which goes on from there
    Vertex at;
    std::uint32_t parent = no_label;
    std::uint32_t set = 0;           // number of the set of obstacles crossed
    std::uint32_t next = no_label;   // at the same vertex
    std::uint32_t fronts_begin = 0;  // regions met straight on; 0, 0: not known
    std::uint32_t fronts_end = 0;
    std::uint32_t since = 0;  // label of the last gate before it, or of the start
    std::uint32_t gate = 0;   // group of the gate that it waits at; 0: it does not wait
    std::uint32_t group = 0;  // not 0: it stands for the gates of a group that are left
    bool dominated = false;
    bool settled = false;  // the estimate knows what may still be crossed in time
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

class Labels {
  public:
    void clear() {
        labels_.clear();
        open_.clear();
        places_.clear();
        fronts_.resize(1);
    }

    Label& operator[](std::uint32_t label) { return labels_[label]; }
    const Label& operator[](std::uint32_t label) const { return labels_[label]; }

    // Adds a label to its vertex and to the open list, unless one that is there dominates it; marks those that it
    // dominates.
    template <class Dominates>
    void add(Label label, const Dominates& dominates) {
        const std::uint32_t place = places_.find_or_add(label.at);
        for (std::uint32_t other = places_[place].labels; other != no_label; other = labels_[other].next) {
            if (!labels_[other].dominated && dominates(labels_[other], label)) return;
        }
        for (std::uint32_t other = places_[place].labels; other != no_label; other = labels_[other].next) {
            if (!labels_[other].dominated && dominates(label, labels_[other])) labels_[other].dominated = true;
        }
        label.next = places_[place].labels;
        places_[place].labels = std::uint32_t(labels_.size());
        add_open(label);
    }
    // Adds a label to the open list only.
    void add_open(const Label& label) {
        labels_.push_back(label);
        insert(std::uint32_t(labels_.size() - 1));
    }
    // Puts a label back into the open list.
    void insert(std::uint32_t label) {
        open_.push_back(label);
        std::push_heap(open_.begin(), open_.end(), [this](auto a, auto b) { return earlier(b, a); });
    }

    std::size_t open_count() const { return open_.size(); }
    // The next label to expand. Precondition: the open list is not empty.
    std::uint32_t first() const { return open_.front(); }
    std::uint32_t take_first() {
        const std::uint32_t first = open_.front();
        std::pop_heap(open_.begin(), open_.end(), [this](auto a, auto b) { return earlier(b, a); });
        open_.pop_back();
        return first;
    }
    // The label at a vertex that would be expanded first; no_label if it has none.
    std::uint32_t first_at(Vertex v) {
        std::uint32_t best = no_label;
        for (std::uint32_t label = places_[places_.find_or_add(v)].labels; label != no_label;
             label = labels_[label].next) {
            if (best == no_label || earlier(label, best)) best = label;
        }
        return best;
    }

    // The last label at a gate of a path, the path's end included; or the start.
    std::uint32_t last_gate(std::uint32_t label) const {
        return labels_[label].gate != 0 ? label : labels_[label].since;
    }

    // Regions that a path meets which goes straight on from a label, if they are known.
    std::optional<std::span<const Front>> ahead(const Label& label) const {
        if (label.fronts_begin == 0) return std::nullopt;
        return std::span(fronts_.data() + label.fronts_begin, fronts_.data() + label.fronts_end);
    }
    void keep_ahead(Label& label, std::span<const Front> fronts) {
        label.fronts_begin = std::uint32_t(fronts_.size());
        fronts_.insert(fronts_.end(), fronts.begin(), fronts.end());
        label.fronts_end = std::uint32_t(fronts_.size());
    }

  private:
    bool earlier(std::uint32_t a, std::uint32_t b) const {
        const Label& la = labels_[a];
        const Label& lb = labels_[b];
        if (la.estimate != lb.estimate) return la.estimate < lb.estimate;
        if (la.cost != lb.cost) return la.cost > lb.cost;
        return a < b;
    }

    std::vector<Label> labels_;
    std::vector<std::uint32_t> open_;  // heap
    Places places_;
    std::vector<Front> fronts_{{}};  // ahead of labels; the first is none
};

}  // namespace waybreaker::crossing
