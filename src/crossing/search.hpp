// The state of a crossing search: docs/exact.md.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "crossing/border.hpp"
#include "crossing/convex.hpp"
#include "crossing/fan.hpp"
#include "crossing/gates.hpp"
#include "crossing/interrupt.hpp"
#include "crossing/labels.hpp"
#include "crossing/regions.hpp"
#include "crossing/rest.hpp"
#include "crossing/ways.hpp"
#include "waybreaker/crossing.hpp"

namespace waybreaker {

class CrossingSearcher::Search {
  public:
    // With the same grown maps.
    std::unique_ptr<Search> another() const;
    void exchange(crossing::Ways& ways) { std::swap(ways_, ways); }
    CrossingResult run(const Map& map, Cell start, Cell goal, const CrossingOptions& options,
                       const std::function<bool(const CrossingPath&)>* accept);
    // Between places where the agent can stand.
    CrossingResult run_between(const Map& map, crossing::Vertex start, crossing::Vertex goal,
                               const CrossingOptions& options, const std::function<bool(const CrossingPath&)>* accept);

  private:
    // Whether a cell of the map is free once that is removed.
    static bool stands(const crossing::Regions& regions, Cell c, std::span<const ObstacleId> removed);
    std::shared_ptr<const crossing::Regions> regions_for(const Map& map, const CrossingOptions& options);

    enum class Outcome { found, exhausted, limit_reached, stopped };

    void start_parts();
    void search_ellipses(double longest);
    Outcome search_ellipse();
    std::optional<Outcome> interrupted();
    void expand(std::uint32_t index);
    void push(std::uint32_t parent, const crossing::Reached& reached);
    void add(crossing::Label label);
    void insert(std::uint32_t label);
    bool earlier(std::uint32_t a, std::uint32_t b) const;
    CrossingPath path_of(std::uint32_t index);
    std::vector<ObstacleId> ids_of(std::span<const ObstacleId> set) const;
    CrossingPath incumbent();

    // waits.cpp. Whether paths may cost more than their length, for what they cross:
    bool in_time() const { return waits_ || options_->done_after; }
    double opened_after(std::span<const ObstacleId> sorted) const;
    std::uint32_t add_set(std::span<const ObstacleId> sorted);
    double estimate(const crossing::Label& label);
    // `at_most`: as of Rest.
    double rest(crossing::Vertex v, double at_most = std::numeric_limits<double>::infinity()) {
        return detours_ ? rest_.from(v, at_most) : length(goal_ - v);
    }
    double with_flight(double ground, std::uint32_t set) const;
    double paid(std::uint32_t set) const { return options_->prices.empty() ? 0 : paid_[set]; }
    std::optional<double> cost_of(std::uint32_t parent, const crossing::Reached& reached);
    std::vector<ObstacleId> add_members(crossing::RegionId region, std::vector<ObstacleId>& set) const;
    void push_gates(std::uint32_t parent);
    std::uint32_t push_group(crossing::GateGroup::Terms terms, const std::vector<ObstacleId>& set);
    double rest_of(const crossing::Border& border, crossing::RegionId region);
    void expand_group(std::uint32_t index);
    void push_gate(std::uint32_t of);
    double arrival_at_gate(const crossing::GateGroup::Terms& terms, crossing::Vertex gate);
    double way_to_gate(const crossing::GateGroup::Terms& terms, crossing::Vertex gate);
    std::uint32_t since_of(std::uint32_t label) const;
    std::uint32_t since_all_open(std::uint32_t label, std::span<const ObstacleId> sorted) const;

    // more.cpp
    void list_openable();
    double least_with_more(std::uint32_t set, double than);
    double least_with(std::span<const ObstacleId> sorted, double rest) const;
    double rest_without_more(crossing::Vertex v, double cost, std::uint32_t set, double most);
    bool settle(std::uint32_t index);

    const Map* map_ = nullptr;
    const CrossingOptions* options_ = nullptr;
    std::vector<ObstacleId> removed_;  // sorted
    bool waits_ = false;               // obstacles open in time
    const std::function<bool(const CrossingPath&)>* accept_ = nullptr;
    bool by_count_ = true;  // of what is crossed and left only the number matters
    crossing::Vertex start_;
    crossing::Vertex goal_;
    int capacity_ = 0;  // members of a set, the removed obstacles included
    double weight_capacity_ = std::numeric_limits<double>::infinity();
    double limit_ = std::numeric_limits<double>::infinity();  // half cells; dearer paths are left out
    double proven_ = 0;                                       // half cells; no path costs less
    double told_ = 0;                                         // half cells; cheaper paths have been told to `accept`
    CrossingResult result_;

    // By reach: of the point, of the square. Shared with searches within this one.
    std::array<std::shared_ptr<const crossing::Regions>, 2> regions_of_;
    std::shared_ptr<const crossing::Regions> regions_;
    crossing::Interrupt interrupt_;
    crossing::Fan fan_;
    crossing::Convex convex_;
    crossing::Rest rest_;
    bool detours_ = false;  // what stays is in the straight way to the goal
    crossing::ObstacleSets sets_;
    crossing::Places places_;
    std::vector<crossing::Label> labels_;
    std::vector<crossing::Front> fronts_;  // straight on from labels; the first is none
    std::vector<std::uint32_t> open_;      // heap

    std::vector<double> paid_;  // by set, half cells

    // Of paths in time.
    std::vector<double> done_after_;  // by set, half cells
    double early_ = 0;                // at a gate, half cells
    // What can be crossed, and how far it is from there to the goal at least, half cells.
    struct Openable {
        ObstacleId obstacle;
        double rest;
    };
    std::vector<Openable> openable_;
    std::vector<double> least_with_more_;  // by set; below 0: not known yet
    crossing::Rest without_more_;          // the rest where nothing else is crossed
    crossing::Borders borders_;
    crossing::Ways ways_;
    std::unordered_map<std::uint32_t, double> rest_of_;  // borders, by region
    bool to_gate_ = false;                               // this search is for such a way:
    std::unique_ptr<Search> way_to_gate_;
    std::vector<crossing::GateGroup> groups_{{}};                        // the first is none
    std::map<std::vector<std::uint32_t>, std::uint32_t> group_numbers_;  // by set, obstacle and where they come from
};

}  // namespace waybreaker
