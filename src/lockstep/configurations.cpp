#include "lockstep/configurations.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace waybreaker::lockstep {
namespace {

using Who = std::uint32_t;
constexpr Who nobody = UINT32_MAX;
constexpr Site fork = nowhere - 1;

// A constraint of LaCAM: some vehicles have a given next site, the last one, and those of the parent.
struct Constraint {
    std::size_t parent = 0;
    std::uint32_t depth = 0;  // number of vehicles with a given site
    Site site = nowhere;
};

struct Node {
    const Configuration* at = nullptr;
    std::size_t parent = 0;
    std::vector<double> priorities;  // by vehicle: the steps since it was last at its goal, and less than one beside
    std::vector<Who> order;          // by priority
    std::vector<Constraint> constraints = std::vector<Constraint>(1);
    std::size_t next = 0;  // of the constraints
};

// The next configuration by priority inheritance with backtracking (PIBT), and by swaps in corridors (Okumura:
// Improving LaCAM for scalable eventually optimal multi-agent pathfinding, IJCAI 2023).
class NextConfiguration {
  public:
    NextConfiguration(const Lattice& lattice, std::span<const std::vector<std::uint32_t>> left, std::uint64_t seed)
        : lattice_(lattice),
          left_(left),
          now_at_(lattice.size(), nobody),
          next_at_(lattice.size(), nobody),
          next_(left.size(), nowhere),
          random_(seed) {}

    // False if vehicles cannot step to their given sites, or are found no place.
    bool find(const Node& node, std::size_t constraint) {
        now_ = node.at;
        for (Who i = 0; i < now_->size(); ++i) now_at_[(*now_)[i]] = i;
        const bool found = obey(node, constraint) &&
                           std::ranges::all_of(node.order, [&](Who i) { return next_[i] != nowhere || move(i); });
        if (found) configuration_ = next_;
        for (Who i = 0; i < now_->size(); ++i) {
            now_at_[(*now_)[i]] = nobody;
            if (next_[i] != nowhere) next_at_[next_[i]] = nobody;
            next_[i] = nowhere;
        }
        return found;
    }

    Configuration take() { return std::move(configuration_); }

  private:
    struct Choice {
        std::uint32_t left;
        std::uint32_t tie;
        Site site;
        auto operator<=>(const Choice&) const = default;
    };

    bool obey(const Node& node, std::size_t constraint) {
        for (std::size_t at = constraint; node.constraints[at].depth > 0; at = node.constraints[at].parent) {
            const Who i = node.order[node.constraints[at].depth - 1];
            const Site to = node.constraints[at].site;
            if (next_at_[to] != nobody || closes_circle(i, to)) return false;
            settle(i, to);
        }
        return true;
    }

    void settle(Who i, Site to) {
        next_[i] = to;
        next_at_[to] = i;
    }

    // Whether those that make room, one for the other, would end with it: two that swap places, or more in a circle.
    bool closes_circle(Who i, Site to) const {
        const Site here = (*now_)[i];
        if (to == here) return false;
        for (Who other = now_at_[to]; other != nobody && next_[other] != nowhere; other = now_at_[next_[other]]) {
            if (next_[other] == here) return true;
        }
        return false;
    }

    // Where a corridor goes on for who comes from a site beside; `nowhere` where it ends, `fork` where it opens. Nobody
    // turns aside into the end of another where somebody is at home.
    Site onward(Site from, Site here) const {
        Site on = nowhere;
        for (Direction d = 0; d < directions; ++d) {
            if (!lattice_.open(here, d)) continue;
            const Site to = lattice_.next(here, d);
            if (to == from || (lattice_.is_end(to) && now_at_[to] != nobody && left_[now_at_[to]][to] == 0)) continue;
            if (on != nowhere) return fork;
            on = to;
        }
        return on;
    }

    // Whether one that pushes another along a corridor would not get past it in the end, as it comes the other way.
    bool must_swap(Who pusher, Who other, Site behind, Site before) const {
        while (left_[pusher][before] < left_[pusher][behind]) {
            const Site on = onward(behind, before);
            if (on == fork) return false;
            if (on == nowhere) break;
            behind = std::exchange(before, on);
        }
        return left_[other][behind] < left_[other][before] &&
               (left_[pusher][behind] == 0 || left_[pusher][before] < left_[pusher][behind]);
    }

    // Whether the corridor that leads there opens somewhere, so that two can pass each other.
    bool can_swap(Site from, Site here) const {
        for (const Site first = from; here != first;) {
            const Site on = onward(from, here);
            if (on == fork) return true;
            if (on == nowhere) return false;
            from = std::exchange(here, on);
        }
        return false;
    }

    // With whom it has to swap places: who stands where it wants to go, or wants to go where it would be pushed on.
    Who to_swap_with(Who i, Site best) const {
        const Site here = (*now_)[i];
        if (best == here || !can_swap(best, here)) return nobody;
        const Who there = now_at_[best];
        if (there != nobody && next_[there] == nowhere && must_swap(i, there, here, best)) return there;
        for (Direction d = 0; d < directions; ++d) {
            const Site beside = lattice_.next(here, d);
            if (!lattice_.open(here, d) || beside == best || now_at_[beside] == nobody) continue;
            if (must_swap(now_at_[beside], i, here, best)) return now_at_[beside];
        }
        return nobody;
    }

    // Settles it somewhere, and those that it drives away. Who has to swap places with another goes back instead, to
    // where the corridor opens, and draws that one along. False if it stands where it is, for want of anything else.
    bool move(Who i) {
        const Site here = (*now_)[i];
        std::array<Choice, directions + 1> choices{};  // the nearest to its goal first
        std::size_t count = 0;
        const auto offer = [&](Site to) {
            const Choice choice{left_[i][to], std::uint32_t(random_.next() >> 32U), to};
            std::size_t at = count++;
            for (; at > 0 && choice < choices[at - 1]; --at) choices[at] = choices[at - 1];
            choices[at] = choice;
        };
        offer(here);
        for (Direction d = 0; d < directions; ++d) {
            if (lattice_.open(here, d)) offer(lattice_.next(here, d));
        }
        const Who partner = to_swap_with(i, choices[0].site);
        if (partner != nobody) std::reverse(choices.begin(), choices.begin() + std::ptrdiff_t(count));
        for (std::size_t k = 0; k < count; ++k) {
            const Site to = choices[k].site;
            if (next_at_[to] != nobody || closes_circle(i, to)) continue;
            settle(i, to);
            const Who there = now_at_[to];
            if (there != nobody && next_[there] == nowhere && !move(there)) continue;
            const bool draws = k == 0 && partner != nobody && next_[partner] == nowhere;
            if (draws && next_at_[here] == nobody && !closes_circle(partner, here)) settle(partner, here);
            return true;
        }
        settle(i, here);
        return false;
    }

    const Lattice& lattice_;
    std::span<const std::vector<std::uint32_t>> left_;
    const Configuration* now_ = nullptr;
    std::vector<Who> now_at_;   // by site
    std::vector<Who> next_at_;  // likewise
    Configuration next_;        // `nowhere` where it is not known yet
    Configuration configuration_;
    Random random_;
};

class Search {
  public:
    Search(const Lattice& lattice, const Configuration& goals, std::span<const std::vector<std::uint32_t>> left,
           std::uint64_t seed)
        : lattice_(lattice), goals_(goals), left_(left), following_(lattice, left, seed) {}

    std::optional<std::vector<Configuration>> run(const Configuration& starts, std::size_t most,
                                                  const std::function<bool()>& due) {
        add(starts, 0);
        for (std::size_t tries = 0; !open_.empty(); ++tries) {
            if (nodes_.size() > most || tries > 4 * most || (tries % 16 == 0 && due())) return std::nullopt;
            const std::size_t at = open_.back();
            if (*nodes_[at].at == goals_) return way_to(at);
            if (nodes_[at].next == nodes_[at].constraints.size()) {
                open_.pop_back();
                continue;
            }
            const std::size_t constraint = nodes_[at].next++;
            branch(nodes_[at], constraint);
            if (!following_.find(nodes_[at], constraint)) continue;
            Configuration found = following_.take();
            const auto known = known_.find(found);
            if (known == known_.end()) {
                add(std::move(found), at);
            } else {
                open_.push_back(known->second);
            }
        }
        return std::nullopt;
    }

  private:
    void add(Configuration at, std::size_t parent) {
        const std::size_t index = nodes_.size();
        Node node;
        node.parent = parent;
        node.priorities.resize(at.size());
        for (Who i = 0; i < at.size(); ++i) {
            if (index == 0) {
                node.priorities[i] = double(left_[i][at[i]]) / double(lattice_.size());
            } else {
                const double before = nodes_[parent].priorities[i];
                node.priorities[i] = at[i] == goals_[i] ? before - double(std::uint64_t(before)) : before + 1;
            }
        }
        node.order.resize(at.size());
        std::iota(node.order.begin(), node.order.end(), Who{0});
        std::ranges::stable_sort(node.order, [&](Who a, Who b) { return node.priorities[a] > node.priorities[b]; });
        node.at = &known_.emplace(std::move(at), index).first->first;
        nodes_.push_back(std::move(node));
        open_.push_back(index);
    }

    // Gives the next vehicle by priority each of its steps in turn.
    void branch(Node& node, std::size_t constraint) const {
        const std::uint32_t depth = node.constraints[constraint].depth;
        if (depth == node.order.size()) return;
        const Site here = (*node.at)[node.order[depth]];
        node.constraints.push_back({constraint, depth + 1, here});
        for (Direction d = 0; d < directions; ++d) {
            if (lattice_.open(here, d)) node.constraints.push_back({constraint, depth + 1, lattice_.next(here, d)});
        }
    }

    std::vector<Configuration> way_to(std::size_t at) const {
        std::vector<Configuration> way{*nodes_[at].at};
        for (; at != 0; at = nodes_[at].parent) way.push_back(*nodes_[nodes_[at].parent].at);
        std::ranges::reverse(way);
        return way;
    }

    const Lattice& lattice_;
    const Configuration& goals_;
    std::span<const std::vector<std::uint32_t>> left_;
    NextConfiguration following_;
    std::vector<Node> nodes_;
    std::map<Configuration, std::size_t> known_;
    std::vector<std::size_t> open_;
};

}  // namespace

std::optional<std::vector<Configuration>> move_all(const Lattice& lattice, const Configuration& starts,
                                                   const Configuration& goals,
                                                   std::span<const std::vector<std::uint32_t>> left, std::uint64_t seed,
                                                   std::size_t most_configurations, const std::function<bool()>& due) {
    return Search(lattice, goals, left, seed).run(starts, most_configurations, due);
}

}  // namespace waybreaker::lockstep
