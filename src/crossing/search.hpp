// The crossing search: A* over taut paths, in ellipses that grow: docs/exact.md.
//
// A label is a vertex, the set of obstacles crossed on the way there, and the cost. It is expanded by rays and outlines
// alone (geometry/), so that only what stands in the way costs anything. labels/ holds what the search knows, in_time/
// what obstacles that open late add.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "crossing/access.hpp"
#include "crossing/dominance.hpp"
#include "crossing/geometry/convex.hpp"
#include "crossing/geometry/fan.hpp"
#include "crossing/geometry/regions.hpp"
#include "crossing/in_time/further_crossings.hpp"
#include "crossing/in_time/path_lengths.hpp"
#include "crossing/in_time/waits.hpp"
#include "crossing/labels/cost_to_go.hpp"
#include "crossing/labels/crossed_sets.hpp"
#include "crossing/labels/labels.hpp"
#include "crossing/labels/query.hpp"
#include "waybreaker/advanced/crossing.hpp"

namespace waybreaker {

class CrossingSearcher::Search {
  public:
    using Accept = std::function<bool(const CrossingPath&)>;

    // With the same grown maps.
    std::unique_ptr<Search> another() const;
    void exchange(crossing::PathLengths& lengths) { std::swap(waits_.path_lengths(), lengths); }
    // `accept`: none for the best path alone.
    CrossingResult run(const Map& map, Cell start, Cell goal, const CrossingOptions& options,
                       const crossing::Opener& opener, const Accept* accept);

  private:
    enum class Outcome { found, exhausted, limit_reached, stopped };

    // Between places where the agent can stand.
    CrossingResult run_between(const Map& map, crossing::Vertex start, crossing::Vertex goal,
                               const CrossingOptions& options, const crossing::Opener& opener, const Accept* accept);
    std::shared_ptr<const crossing::Regions> regions_for(const Map& map, const CrossingOptions& options);
    void start_query(const Map& map, crossing::Vertex start, crossing::Vertex goal, const CrossingOptions& options,
                     const crossing::Opener& opener);
    void search_ellipses();
    void start_ellipse();
    Outcome search_ellipse();
    std::optional<Outcome> interrupted();
    bool settle(std::uint32_t index);
    bool reach_goal(std::uint32_t index);
    void expand(std::uint32_t index);
    crossing::Viewpoint viewpoint(const crossing::Label& label);
    void push(std::uint32_t parent, const crossing::Reached& reached);
    void add(const crossing::Label& label) { labels_.add(label, dominates_); }
    double estimate(const crossing::Label& label) {
        return sets_.cost(label.cost + cost_to_go_.from(label.at), label.set);
    }
    CrossingPath path_to(std::uint32_t label);
    CrossingResult find_path_to_gate(crossing::Vertex from, crossing::Vertex gate, const CrossingOptions& options);

    crossing::CrossingQuery query_;
    crossing::CrossingProgress progress_;
    const Accept* accept_ = nullptr;
    double proven_ = 0;     // half cells; no path costs less
    double reported_ = -1;  // half cells; paths that cost no more have been given to `accept`
    CrossingResult result_;

    // Regions by reach: for the point, for the square. Shared with searches within this one.
    std::array<std::shared_ptr<const crossing::Regions>, 2> regions_of_;
    crossing::Fan fan_;
    crossing::Convex convex_;
    crossing::Labels labels_;
    crossing::CrossedSets sets_{query_};
    crossing::CostToGo cost_to_go_;
    crossing::FurtherCrossings further_{query_, progress_, sets_, cost_to_go_, fan_.ray()};
    crossing::Waits waits_{query_,
                           progress_,
                           labels_,
                           sets_,
                           cost_to_go_,
                           further_,
                           fan_,
                           [this](crossing::Vertex from, crossing::Vertex gate, const CrossingOptions& options) {
                               return find_path_to_gate(from, gate, options);
                           }};
    crossing::Dominance dominates_{query_, progress_, sets_, waits_.groups(), convex_};
    bool to_gate_ = false;  // this search finds the path to a gate, for another one:
    std::unique_ptr<Search> search_to_gate_;
};

}  // namespace waybreaker
