// From coarse to fine: the targets' cells are grouped into pieces, boxes of cells. Dynamic programming over (targets
// still to visit, piece where the air agent is), after Held and Karp 1962, with a hop as long as the gap between two
// boxes and no cost inside a box, gives lower bounds: pieces that no tour as short as the best one known can use are
// dropped, the others are split, until all pieces are single cells and the bounds are lengths. Round zones a hop is as
// long as the way between two cells, and no less than their gap; so the bounds hold there, too.
//
// Rounds run from start and from goal in turn, so that the bounds of the round before complete those of this one: "from
// here on to the goal" plus "from the start to here". With deadlines the rounds from start drop what is late: to be
// somewhere earlier never hurts, so that the earliest arrival is all there is to know.
#include "flight/exact.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

#include "flight/local_search.hpp"
#include "flight/piece.hpp"

namespace waybreaker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-9;      // relative, and far more than our sums of doubles can be off
constexpr int halvings = 2;            // of a piece from one round to the next
constexpr std::size_t group_size = 8;  // pieces
constexpr std::size_t none = SIZE_MAX;

// A set of targets: bit i stands for target i.
using Set = std::uint32_t;
constexpr Set only(std::size_t target) {
    return Set{1} << target;
}

// How far the air agent can have flown when it comes to a target, having visited a set before.
double latest_arrival(const Deadlines& deadlines, Set before, std::size_t target) {
    double latest = deadlines.latest[target] - deadlines.stay[target];
    for (Set rest = before; rest != 0; rest &= rest - 1) latest -= deadlines.stay[std::size_t(std::countr_zero(rest))];
    return latest;
}

bool in_time(const Deadlines& deadlines, Point start, const Tour& tour, const Airspace& air) {
    Set before = 0;
    double flown = 0;
    for (const Stop& stop : tour) {
        flown += air.length(start, stop.at);
        if (flown > latest_arrival(deadlines, before, stop.target)) return false;
        before |= only(stop.target);
        start = stop.at;
    }
    return true;
}

bool is_cell(const Box& box) {
    return box.min == box.max;
}

// A round finds, for every set of targets and every piece of another target, the least length of a way from the piece
// through the set to one end of the tour, the near end.
class Round {
  public:
    // `pieces` come in order of target and of Piece::whole, an index into the pieces of the round `before`. That one
    // ran from the far end; the first round does without. `deadlines`, if any: the near end is the start.
    Round(std::vector<Piece> pieces, std::size_t targets, Point near_end, Point far_end, double limit,
          const Deadlines* deadlines, const Airspace& air, const Round* before)
        : pieces_(std::move(pieces)),
          deadlines_(deadlines),
          air_(&air),
          all_(only(targets) - 1),
          near_end_(near_end),
          far_end_(far_end),
          useful_(pieces_.size(), false) {
        group(targets);
        bounds_.assign((std::size_t{all_} + 1) * pieces_.size(), infinity);
        group_bounds_.assign((std::size_t{all_} + 1) * groups_.size(), infinity);
        // A set's number is larger than those of its subsets.
        for (Set set = 0; set < all_; ++set) {
            for (std::size_t g = 0; g < groups_.size(); ++g) {
                if ((set & only(groups_[g].target)) == 0) bound(set, g, limit, before);
            }
        }
    }

    bool exact() const {
        return std::ranges::all_of(pieces_, [](const Piece& piece) { return piece.cells.size() == 1; });
    }

    // A lower bound of the length of every tour.
    double least_length() const { return best_way(far_end_, all_, infinity).length; }

    // The pieces of the best way through all targets, from the far end to the near one, each with one of its cells.
    Tour best_tour() const {
        Tour tour;
        const Piece* at = nullptr;
        for (Set rest = all_; rest != 0; rest &= ~only(tour.back().target)) {
            const Way way = at ? best_way(at->box, rest, infinity) : best_way(far_end_, rest, infinity);
            at = &pieces_[way.next];
            tour.push_back({at->target, *std::ranges::min_element(at->cells, before_in_scan)});
        }
        return tour;
    }

    // The pieces of the next round: what lies on a tour within the limit, split.
    std::vector<Piece> useful_parts() const {
        std::vector<Piece> parts;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (useful_[i]) split(pieces_[i], i, halvings, parts);
        }
        return parts;
    }

  private:
    // A few pieces of one target that lie side by side; they can be passed over at once.
    struct Group {
        std::size_t target;
        std::size_t first;
        std::size_t last;  // one past
        Box box;
    };
    struct Way {
        double length;
        std::size_t next;  // piece
    };

    void group(std::size_t targets) {
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            const Piece& piece = pieces_[i];
            const bool begins =
                i == 0 || piece.target != groups_.back().target || i - groups_.back().first == group_size;
            if (begins) groups_.push_back({piece.target, i, i, piece.box});
            groups_.back().last = i + 1;
            groups_.back().box = united(groups_.back().box, piece.box);
        }
        first_group_.assign(targets + 1, groups_.size());
        for (std::size_t g = groups_.size(); g-- > 0;) first_group_[groups_[g].target] = g;
    }

    // The least way between two cells that they can hold.
    double gap(Point a, const Box& b) const {
        return is_cell(b) && !air_->is_open() ? air_->length(a, b.min) : std::sqrt(squared_gap(a, b));
    }
    double gap(const Box& a, const Box& b) const {
        return is_cell(a) && !air_->is_open() ? gap(Point(a.min), b) : std::sqrt(squared_gap(a, b));
    }
    double gap(Point a, Point b) const { return air_->length(a, b); }

    double& bound_of(Set set, std::size_t piece) { return bounds_[set * pieces_.size() + piece]; }
    double bound_of(Set set, std::size_t piece) const { return bounds_[set * pieces_.size() + piece]; }
    double& group_bound_of(Set set, std::size_t g) { return group_bounds_[set * groups_.size() + g]; }
    double group_bound_of(Set set, std::size_t g) const { return group_bounds_[set * groups_.size() + g]; }

    // Bounds the ways from the pieces of a group through a set; they stay infinite where no tour within the limit goes.
    void bound(Set set, std::size_t g, double limit, const Round* before) {
        const Group& group = groups_[g];
        const Set others = all_ & ~set & ~only(group.target);
        const double latest = deadlines_ ? latest_arrival(*deadlines_, set, group.target) : infinity;
        std::size_t next = none;
        for (std::size_t i = group.first; i < group.last; ++i) {
            const Piece& piece = pieces_[i];
            const double far = before ? before->bound_of(others, piece.whole) : gap(far_end_, piece.box);
            if (far + gap(near_end_, piece.box) > limit) continue;
            const double reach = std::min(limit - far, latest);
            const Way way = best_way(piece.box, set, reach, next);
            if (way.length > reach) continue;
            next = way.next;
            bound_of(set, i) = way.length;
            group_bound_of(set, g) = std::min(group_bound_of(set, g), way.length);
            useful_[i] = true;
        }
    }

    // The shortest way from a box through a set to the near end; some longer one if that is longer than `limit`.
    // `likely`: a piece in the set that is probably next; of ways equally long its own is taken.
    Way best_way(const auto& from, Set set, double limit, std::size_t likely = none) const {
        if (set == 0) return {gap(near_end_, from), none};
        Way best{std::nextafter(limit, infinity), none};
        if (likely != none) {
            const double length =
                gap(from, pieces_[likely].box) + bound_of(set & ~only(pieces_[likely].target), likely);
            if (length < best.length) best = {length, likely};
        }
        for (Set next = set; next != 0; next &= next - 1) {
            const std::size_t target = std::size_t(std::countr_zero(next));
            const Set rest = set & ~only(target);
            for (std::size_t g = first_group_[target]; g < first_group_[target + 1]; ++g) {
                if (too_far(from, groups_[g].box, best.length - group_bound_of(rest, g))) continue;
                for (std::size_t i = groups_[g].first; i < groups_[g].last; ++i) {
                    if (too_far(from, pieces_[i].box, best.length - bound_of(rest, i))) continue;
                    const double length = gap(from, pieces_[i].box) + bound_of(rest, i);
                    const bool first = length == best.length && best.next != none && comes_first(i, best.next);
                    if (length < best.length || first) best = {length, i};
                }
            }
        }
        return best;
    }

    static bool too_far(const auto& a, const Box& b, double reach) {
        return reach < 0 || squared_gap(a, b) > reach * reach * (1 + rounding);
    }

    bool comes_first(std::size_t a, std::size_t b) const {
        return pieces_[a].target == pieces_[b].target && before_in_scan(pieces_[a].box.min, pieces_[b].box.min);
    }

    std::vector<Piece> pieces_;
    const Deadlines* deadlines_;
    const Airspace* air_;
    Set all_;
    Point near_end_;
    Point far_end_;
    std::vector<bool> useful_;  // by piece: whether one of its bounds is finite
    std::vector<Group> groups_;
    std::vector<std::size_t> first_group_;  // by target, and one past
    std::vector<double> bounds_;            // by set and piece
    std::vector<double> group_bounds_;      // by set and group: the least of its pieces' bounds
};

// The targets, each with the cells that a tour of some length can visit, were it the only target.
std::vector<Target> in_reach(Point start, Point goal, std::span<const Target> targets, const Airspace& air,
                             double length) {
    std::vector<Target> near(targets.size());
    for (std::size_t i = 0; i < targets.size(); ++i) {
        near[i].obstacle = targets[i].obstacle;
        std::ranges::copy_if(targets[i].cells, std::back_inserter(near[i].cells),
                             [&](Cell c) { return air.length(start, c) + air.length(c, goal) <= length; });
    }
    return near;
}

// The shortest tour within the limit that meets the deadlines, if there are any.
std::optional<Tour> search(Point start, Point goal, std::span<const Target> targets, double limit,
                           const Deadlines* deadlines, const Airspace& air) {
    assert(targets.size() <= exact_flight_limit);
    limit *= 1 + rounding;
    const std::vector<Target> near = in_reach(start, goal, targets, air, limit);
    std::vector<Target> parts = near;  // splitting a piece sorts its cells
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (parts[i].cells.empty()) return std::nullopt;
        pieces.push_back(make_piece(i, parts[i].cells, i));
    }
    const auto learn_from = [&](const Tour& tour) {
        if (!deadlines || in_time(*deadlines, start, tour, air)) {
            limit = std::min(limit, tour_length(start, tour, goal, air) * (1 + rounding));
        }
    };

    Round round(std::move(pieces), targets.size(), start, goal, limit, deadlines, air, nullptr);
    // Lateness is seen from the start. Without deadlines the last round runs from the goal, so that ties are settled
    // from the start on.
    const bool last_from_goal = !deadlines;
    for (bool from_goal = false; !round.exact() || from_goal != last_from_goal;) {
        const double least = round.least_length();
        if (least > limit) return std::nullopt;
        if (least < limit * (1 - 2 * rounding)) {
            Tour guess = round.best_tour();
            if (!from_goal) std::ranges::reverse(guess);
            learn_from(guess);
            learn_from(improved_tour(start, std::move(guess), goal, near, air));
        }
        from_goal = !from_goal;
        round = Round(round.useful_parts(), targets.size(), from_goal ? goal : start, from_goal ? start : goal, limit,
                      from_goal ? nullptr : deadlines, air, &round);
    }
    if (round.least_length() > limit) return std::nullopt;
    Tour tour = round.best_tour();
    if (deadlines) std::ranges::reverse(tour);
    return tour;
}

}  // namespace

Tour shortest_tour(Point start, Point goal, std::span<const Target> targets, const Tour& known, const Airspace& air) {
    assert(known.size() == targets.size());
    return search(start, goal, targets, tour_length(start, known, goal, air), nullptr, air).value_or(known);
}

std::optional<Tour> shortest_tour_in_time(Point start, Point goal, std::span<const Target> targets,
                                          const Deadlines& deadlines, double limit, const Airspace& air) {
    return search(start, goal, targets, limit, &deadlines, air);
}

}  // namespace waybreaker
