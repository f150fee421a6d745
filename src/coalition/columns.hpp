// Columns: for each vehicle, sets of obstacles that are worth having open, and when it can arrive then at the earliest.
// A few of very many: those that matter are found by a search in which each obstacle has a price.
#pragma once

#include <algorithm>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "coalition/problem.hpp"
#include "coalition/workers.hpp"
#include "waybreaker/advanced/crossing.hpp"

namespace waybreaker::coalition {

struct Column {
    std::vector<std::uint32_t> opened;  // positions in the vehicle's list of obstacles, sorted
    double arrival = 0;  // no earlier through these, waits included; Rules::unreached if that is earlier; units of time
};

// What is known of one vehicle.
struct Pool {
    std::vector<ObstacleId> obstacles;  // of all columns, as they came
    std::vector<Column> columns;        // the first: nothing is opened
    double least = 0;                   // no column at all arrives earlier; 0 where that does not matter
};

// Of what body: `relaxed` for lower limits of all plans; `own` for what the vehicle can drive, or nearly so, which may
// need obstacles gone where a point slips through.
enum class Shape { relaxed, own };

class Columns {
  public:
    // What a search proves: no set costs less; and each that costs less than `complete_below` is in the pool, or
    // arrives no earlier than one within it that is.
    struct Search {
        double least = 0;
        double complete_below = 0;
    };

    // Each vehicle with nothing opened but what must be, and with what is best for it alone. `closed`: past all
    // obstacles, if that is known.
    Columns(const Problem& problem, Workers& workers, Shape shape, std::span<const team::Vehicle> closed = {});

    // Of vehicles that are many and never collide, searches first take obstacles as open from the beginning: that says
    // nearly as much in a fraction of the time. From now on they heed when these open. Whether they did not before.
    bool heed_times();

    // Of vehicles that are many and never collide, the first searches share so many expansions: one that takes long for
    // a single vehicle says less than a round more for all. From now on each may take its own. Whether it did not
    // before.
    bool search_longer();

    std::size_t size() const { return pools_.size(); }
    const Pool& of(std::size_t vehicle) const { return pools_[vehicle]; }
    // Whether a vehicle may arrive earlier than past all obstacles with that one open.
    bool may_gain(std::size_t vehicle, const Obstacle& obstacle) const;
    // How much earlier at most, in units of time; 0 if it may not. Who has no way otherwise, and must have one, gains
    // as much as the way may take.
    double most_gain(std::size_t vehicle, const Obstacle& obstacle) const;
    // Whether a limit has ended a search.
    bool limited() const { return std::ranges::find(limited_, true) != limited_.end(); }

    // The least arrival plus prices over all sets, also those that are not known: a lower limit, the exact value unless
    // a limit ends a search. Prices by id, in units of time. Adds the best column, or one nearly as good. For two
    // vehicles, two workers may do so at once.
    Search search(std::size_t vehicle, std::span<const double> prices, Worker& worker);
    // The same, and adds columns that cost up to so much more than the best, if they are not too many.
    Search list(std::size_t vehicle, std::span<const double> prices, double margin, Worker& worker);

  private:
    // At certain prices, for what costs less than that. The options refer to the lists, and are those of a search as if
    // all were open.
    struct Query {
        std::vector<double> prices;       // by id, in cells
        std::vector<double> with_rubble;  // likewise
        std::vector<ObstacleId> protect;
        CrossingOptions options;
    };
    Query query(std::size_t vehicle, std::span<const double> prices, double less_than) const;
    Search search_best(std::size_t vehicle, std::span<const double> prices, Worker& worker);
    Search list_near(std::size_t vehicle, std::span<const double> prices, double margin, Worker& worker);
    double closed_length(std::size_t vehicle, std::span<const team::Vehicle> closed, Worker& worker);
    CrossingResult find(std::size_t vehicle, int crossings, double length_limit, Worker& worker);
    void begin_latest(Worker& worker);
    void begin(std::size_t vehicle, Worker& worker);
    void begin_in_time(std::size_t vehicle, Worker& worker);
    void begin_by_count(std::size_t vehicle, Worker& worker);
    CrossingSearcher& searcher(Worker& worker) const {
        return shape_ == Shape::relaxed ? worker.limits : worker.crossing;
    }
    void note(std::size_t vehicle, const CrossingResult& search);
    void add(std::size_t vehicle, std::span<const ObstacleId> opened, double length);
    void add_in_time(std::size_t vehicle, std::span<const ObstacleId> opened, double length, Worker& worker);
    double greatest_fall(std::span<const double> from, std::span<const double> to) const;
    double best_known(std::size_t vehicle, std::span<const double> prices) const;
    bool can_heed_times() const { return shape_ == Shape::relaxed && problem_.rules().timing == Timing::enforce; }
    bool in_time() const { return heeds_times_; }
    CrossingOptions options_for(std::size_t vehicle) const;
    std::vector<ObstacleId> useless(const Agent& agent, std::span<const double> prices, double known) const;
    double opened_after(const Agent& agent, std::span<const ObstacleId> obstacles, EarliestOpenings& openings) const;
    double each_opened_after(const Agent& agent, std::span<const ObstacleId> obstacles) const;
    double arrival_of(const Agent& agent, std::span<const ObstacleId> opened, double length) const;

    const Problem& problem_;
    Shape shape_;
    bool heeds_times_;
    std::uint64_t most_expansions_;  // of one search
    // What the last search of a vehicle has proven.
    struct Proof {
        std::vector<double> prices = {};
        double least = 0;
        bool complete = false;  // no limit has ended it
    };

    std::vector<Pool> pools_;
    std::vector<Proof> proofs_;
    std::vector<crossing::Memory> memories_;  // by vehicle
    std::vector<std::set<Set>> timed_;        // by vehicle: searched in time, and nothing else open
    std::vector<char> limited_;               // by vehicle
};

// The least arrival plus prices (as pool.obstacles) over the known columns, and the first column that has it.
struct Cheapest {
    double cost = infinity;
    std::size_t column = 0;
};
Cheapest cheapest(const Pool& pool, double weight, const std::vector<double>& prices);

}  // namespace waybreaker::coalition
