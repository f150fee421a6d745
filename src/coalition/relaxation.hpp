// Relaxation: what no choice of obstacles can beat. One set serves all vehicles; if each may have a set of its own, and
// pays for what it has opened, each is solved alone, and the prices say how much that leaves out.
//
// For any weights w of the vehicles (1 each for a sum; together 1 for a maximum) and any prices p >= 0, and for the
// set X of a plan, with S_i the part of X that vehicle i drives through, and f(X) what the aircraft add to the sum:
//
//     sum w_i arrival_i + f(X)  >=  sum (w_i arrival_i + p_i(S_i)) + f(X) - p(X)
//                               >=  sum min_S (w_i arrival_i(S) + p_i(S)) - max_X (p(X) - f(X))
//
// The right side needs only one search for each vehicle, whatever the number of sets (Lagrangian relaxation; Held, Karp
// 1971). Prices are improved by subgradients on the columns that are known, and then proven by searches, which find
// new columns.
#pragma once

#include <vector>

#include "coalition/columns.hpp"

namespace waybreaker::coalition {

class Relaxation {
  public:
    Relaxation(const Problem& problem, Columns& columns);

    // No plan has a smaller objective.
    double bound() const { return bound_; }
    // Raises the bound towards the objective of a set that is known, until it is that near to it (relative), or after
    // so many rounds of searches, or when that gains no more. Columns that matter have been found by then.
    void tighten(double reached, double close, int rounds);
    // What vehicles pay for, together: the most wanted first.
    std::vector<ObstacleId> wanted() const;

  private:
    struct Prices {
        std::vector<double> weights;              // by vehicle
        std::vector<std::vector<double>> prices;  // by vehicle, as its list of obstacles
    };

    struct Answer {
        double value = 0;
        std::vector<char> chosen;        // by number
        std::vector<std::size_t> taken;  // by vehicle: its column
    };

    void number_obstacles();
    Answer answer(const Prices& at) const;
    Prices direction(const Prices& at, const Answer& answer, double scale) const;
    double fixed() const;
    void sum_for(const Prices& at, std::vector<double>& sums) const;
    double dearest(const std::vector<double>& sums, std::vector<char>& chosen) const;
    void mark_most_paid(const std::vector<double>& sums, std::size_t count, std::vector<char>& chosen) const;
    void ascend(double reached);
    bool prove();

    const Problem& problem_;
    Columns& columns_;
    std::vector<ObstacleId> numbered_;                 // obstacles of any column
    std::vector<std::vector<std::uint32_t>> numbers_;  // by vehicle: of its list of obstacles
    std::map<ObstacleId, std::uint32_t> number_of_;
    std::vector<double> detours_;           // by number: of the nearest aircraft, where flights count
    std::vector<std::uint32_t> by_detour_;  // numbers, the shortest first
    Prices best_;
    double bound_ = 0;
};

}  // namespace waybreaker::coalition
