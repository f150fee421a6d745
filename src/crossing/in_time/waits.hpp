// Waits: where and until when paths in time wait, as gates at the borders of obstacles that open late.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "crossing/geometry/border.hpp"
#include "crossing/geometry/fan.hpp"
#include "crossing/in_time/further_crossings.hpp"
#include "crossing/in_time/gates.hpp"
#include "crossing/in_time/path_lengths.hpp"
#include "crossing/labels/cost_to_go.hpp"
#include "crossing/labels/crossed_sets.hpp"
#include "crossing/labels/labels.hpp"
#include "crossing/labels/query.hpp"

namespace waybreaker::crossing {

class Waits {
  public:
    // Finds a shortest path that waits for nothing.
    using FindPath = std::function<CrossingResult(Vertex from, Vertex to, const CrossingOptions&)>;

    // All must outlive it.
    Waits(const CrossingQuery& query, CrossingProgress& progress, Labels& labels, CrossedSets& sets,
          CostToGo& cost_to_go, FurtherCrossings& further, Fan& fan, FindPath find_path)
        : query_(query),
          progress_(progress),
          labels_(labels),
          sets_(sets),
          cost_to_go_(cost_to_go),
          further_(further),
          fan_(fan),
          find_path_(std::move(find_path)) {}

    // Path lengths remembered from earlier queries.
    PathLengths& path_lengths() { return path_lengths_; }

    void start_query();
    // Forgets all gates.
    void start_ellipse();

    // Whether all that a path crosses from a label on to what it has reached is open when it gets there.
    bool in_time(const Label& from, const Reached& reached);
    // Adds labels for the gates of what the last look from a label has entered, where that may open late.
    void add_gates(std::uint32_t label);
    // Takes the next gate out of the group that a label stands for, if its turn has come; the label goes back into the
    // open list where gates are left.
    std::optional<Label> take_gate(std::uint32_t index);

    const std::vector<GateGroup>& groups() const { return groups_; }

  private:
    std::vector<ObstacleId> add_members(RegionId region, std::vector<ObstacleId>& set) const;
    std::uint32_t add_group(GateGroup::Terms terms, const std::vector<ObstacleId>& set);
    double cost_to_go_from(const Border& border, RegionId region);
    Label gate_label(std::uint32_t group_label) const;
    double arrival_at_gate(const GateGroup::Terms& terms, Vertex gate);
    double length_to_gate(const GateGroup::Terms& terms, Vertex gate);
    std::uint32_t first_in_time(std::uint32_t label, std::span<const ObstacleId> sorted) const;

    const CrossingQuery& query_;
    CrossingProgress& progress_;
    Labels& labels_;
    CrossedSets& sets_;
    CostToGo& cost_to_go_;
    FurtherCrossings& further_;
    Fan& fan_;
    FindPath find_path_;
    Borders borders_;
    PathLengths path_lengths_;
    std::unordered_map<std::uint32_t, double> cost_to_go_from_;          // borders, by region
    std::vector<GateGroup> groups_{{}};                                  // the first is none
    std::map<std::vector<std::uint32_t>, std::uint32_t> group_numbers_;  // by set, obstacle and where they come from
};

}  // namespace waybreaker::crossing
