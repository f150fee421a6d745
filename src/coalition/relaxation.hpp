// Relaxation: what no choice of obstacles can beat. One set serves all vehicles; if each may have a set of its own, and
// pays for what it has opened, each is solved alone, and the prices say how much that leaves out.
//
// For any weights w of the vehicles (their own for a sum; together 1 for a maximum) and any prices p >= 0, and for the
// set X of a plan, with S_i the part of X that vehicle i drives through, and f(X) what the aircraft add to the sum:
//
//     sum w_i arrival_i + f(X)  >=  sum (w_i arrival_i + p_i(S_i)) + f(X) - p(X)
//                               >=  sum min_S (w_i arrival_i(S) + p_i(S)) - max_X (p(X) - f(X))
//
// The right side needs only one search for each vehicle, whatever the number of sets (Lagrangian relaxation; Held, Karp
// 1971). Prices are improved by subgradients on the columns that are known, and then proven by searches, which find
// new columns. As few columns are known at first, prices go only part of the way to what looks best on them.
#pragma once

#include <optional>
#include <vector>

#include "coalition/columns.hpp"
#include "coalition/offers.hpp"
#include "coalition/tuning.hpp"

namespace waybreaker::coalition {

class Relaxation {
  public:
    // All arguments must outlive it.
    Relaxation(const Problem& problem, Columns& columns, Workers& workers);

    // No plan has a smaller objective.
    double bound() const { return bound_; }
    // One round: better prices for the columns that are known, by subgradients towards the objective of a set that is
    // known; searches prove the bound there, and find the best column of each vehicle, and where these are few some
    // more. Whether that has gained anything.
    bool tighten(double reached);
    // Searches at the prices that are proven best: for all columns that cost up to so much more than the best.
    void list(double margin) { prove(centre_, margin); }

    // What the last searches have proven.
    struct Proof {
        double fixed = 0;                              // beside the vehicles
        std::vector<double> weights = {};              // by vehicle
        std::vector<std::vector<double>> prices = {};  // by vehicle, as its list of obstacles
        std::vector<double> sums = {};                 // by id: paid by all, less what its breach takes
        std::vector<Columns::Search> searches = {};    // by vehicle: of its weighted arrival and prices
        Offers offers = {};                            // of the sums
        double bound = 0;
        bool complete = false;  // no search was left out
    };
    const Proof& proof() const { return proof_; }
    // By the last searches: no plan that removes only so many, beside what it must, has a smaller objective.
    double bound_with(std::size_t removals) const;
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

    // Of a maximum, a vehicle that hardly counts is; of a sum, one that does not count.
    bool is_left_out(double weight) const {
        return problem_.sums() ? weight == 0 : weight < tuning::least_weight_of_vehicle;
    }
    void number_obstacles();
    Answer answer(const Prices& at) const;
    Prices direction(const Prices& at, const Answer& answer, double scale) const;
    double fixed() const;
    Offers offers(const Prices& at) const;
    double best_paid(const Offers& offers, std::vector<ObstacleId>& chosen) const;
    void ascend(double reached);
    double claim(std::size_t vehicle, double weight, const Obstacle& obstacle) const;
    std::vector<double> offer_all(const Prices& at);
    std::vector<double> prices_of(std::size_t vehicle, const Prices& at, const std::vector<double>& free) const;
    bool prove(Prices at, std::optional<double> margin = std::nullopt);

    const Problem& problem_;
    Columns& columns_;
    Workers& workers_;
    std::vector<ObstacleId> numbered_;                 // obstacles of any column
    std::vector<std::vector<std::uint32_t>> numbers_;  // by vehicle: of its list of obstacles
    std::map<ObstacleId, std::uint32_t> number_of_;
    std::vector<double> detours_;  // by number: of the nearest aircraft, where flights count
    Prices best_;                  // on what is known
    Prices centre_;                // those that are proven best
    Proof proof_;
    double bound_ = 0;
};

}  // namespace waybreaker::coalition
