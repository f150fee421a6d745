// AA-SIPP: best first over pairs of a cell and one of its safe intervals (Yakovlev, Andreychuk 2017).
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/stopwatch.hpp"
#include "map/line_of_sight.hpp"
#include "safe_interval/distance_memory.hpp"
#include "safe_interval/traffic.hpp"
#include "waybreaker/advanced/safe_interval.hpp"

namespace waybreaker {

class SafeIntervalSearcher::Search {
  public:
    SafeIntervalResult run(const OpenedMap& map, const Traffic& traffic, Cell start, Cell goal,
                           const SafeIntervalOptions& options);

  private:
    // A cell and one of its safe intervals.
    struct Node {
        Cell cell;
        double from = 0;
        double to = 0;
        double arrival = safe_interval::for_ever;
        double departure = 0;  // from the parent
        std::uint32_t parent = none;
        std::uint32_t tried = none;  // what it was last tried to come from, past the node that offered it
        bool expanded = false;
    };
    struct Nodes {
        std::uint32_t first = 0;
        std::uint32_t count = 0;
        std::uint32_t query = 0;
    };
    struct Open {
        double cost;   // earliest arrival at the goal by way of the node
        double ahead;  // of that, still to go
        double arrival;
        std::uint32_t node;
        std::uint32_t by;  // none: the node has been reached; else from where it might be
        // As a heap: the cheapest on top, of those the one that is nearest to the goal.
        bool operator<(const Open& other) const {
            if (cost != other.cost) return cost > other.cost;
            if (ahead != other.ahead) return ahead > other.ahead;
            return node != other.node ? node > other.node : by < other.by;
        }
    };
    static constexpr std::uint32_t none = UINT32_MAX;

    SearchStatus find_way(std::vector<Cell>& way);
    bool meets_nobody(std::span<const Waypoint> path) const;
    void search_in(safe_interval::Region region, std::span<const Cell> way, SafeIntervalResult& result);
    SearchStatus search();
    std::optional<SearchStatus> interrupted() const;
    Nodes nodes_at(Cell cell);
    safe_interval::Interval useful_times(Cell cell) const;
    void add_nodes(Cell cell);
    bool is_end(std::uint32_t node) const;
    void expand(std::uint32_t at);
    void offer(std::uint32_t by, Cell to);
    void come_from(std::uint32_t by, std::uint32_t to);
    void relax(std::uint32_t by, std::uint32_t to);
    double safe_departure(const safe_interval::Move& move, double earliest, double latest) const;
    bool sees(Cell from, Cell to) const { return sight_ && sight_->clear(from, to); }
    double opened_for(Cell from, Cell to, double duration) const;
    void push(std::uint32_t at, double arrival, std::uint32_t by);
    std::vector<Waypoint> path_to(std::uint32_t node) const;

    // The query.
    const OpenedMap* map_ = nullptr;
    const safe_interval::TrafficIndex* traffic_ = nullptr;
    const SafeIntervalOptions* options_ = nullptr;
    std::optional<LineOfSight> sight_;
    Cell start_;
    Cell goal_;
    double radius_ = 0;
    Deadline deadline_;
    double arrive_before_ = safe_interval::for_ever;  // also than the best path so far
    std::uint64_t expanded_ = 0;

    // The search.
    safe_interval::DistanceMemory memory_;
    const safe_interval::Distances* distances_ = nullptr;
    safe_interval::OpenSteps* open_steps_ = nullptr;
    std::uint32_t query_ = 0;
    std::vector<Nodes> nodes_of_;  // by cell of the region
    std::vector<Node> nodes_;
    std::vector<Open> open_;     // heap
    double goal_free_from_ = 0;  // until the end
    std::uint32_t reached_ = none;
    std::vector<safe_interval::Interval> unsafe_;
    Searcher searcher_;
};

}  // namespace waybreaker
