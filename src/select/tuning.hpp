// What exact selection spends on each proposer and proof: the budgets of docs/exact.md, all in one place. Expansions
// are labels taken from the open list of a crossing search; gaps are relative; shares are of the time that is left.
#pragma once

#include <cstdint>

namespace waybreaker::tuning {

// Time. A share that ends early makes a plan worse, never a bound wrong.
inline constexpr double share_of_proof = 0.8;    // the rest is for sets that are likely to be good
inline constexpr double share_of_relaxed = 0.5;  // of the proof's time, for the relaxed body; the square comes after it
inline constexpr double share_at_once = 0.3;     // where obstacles open late: for what is proven as if they did not
inline constexpr double share_of_weighted = 0.8;
inline constexpr double share_of_greedy = 0.5;
inline constexpr double share_of_budget = 0.5;  // least demolition: for each budget of cells
// Seconds: with less a weighted search comes before a long proof, so that there is a good plan soon.
inline constexpr double short_time = 0.5;
// Seconds: for a search among few obstacles, though the time is over.
inline constexpr double overtime = 0.01;
// Cells a second: steps from cell to cell are counted where they take half the time at most.
inline constexpr double cells_stepped_per_second = 5e6;

// Expansions of the proof. Beyond, where little time is given, a weighted search comes first; beyond the second, steps
// from cell to cell do.
inline constexpr std::uint64_t easy_proof = 250;
inline constexpr std::uint64_t hard_proof = 5'000;
inline constexpr std::uint64_t proof_in_time = 40'000;  // the whole proof, where obstacles open late

// Expansions of the proposers.
inline constexpr std::uint64_t square_first = 5'000;       // the square's best set, before the bound
inline constexpr std::uint64_t square_in_time = 4'000;     // the same after it, where obstacles open late
inline constexpr std::uint64_t enumeration = 10'000;       // further sets; where obstacles open late `square_in_time`
inline constexpr std::uint64_t least_enumeration = 1'000;  // however short the search for the first set
inline constexpr std::uint64_t weighted = 4'000;
inline constexpr std::uint64_t priced = 10'000;
// Sets of an enumeration that are put in time: with three removals at most, with more, and for other planners. With
// more there are very many that could be better, and hardly one that is.
inline constexpr int most_sets = 256;
inline constexpr int most_sets_of_many = 16;
inline constexpr int most_sets_of_others = 8;
inline constexpr int few_removals_to_enumerate = 3;
// Of a plan above its bound all sets are evaluated, up to the largest size of which there are no more than that.
inline constexpr std::size_t most_sets_evaluated = 64;
// Up to so many removals the square's best set comes before the bound. With more, paths are nearly straight, and it is
// the bound that makes the square's search short.
inline constexpr int few_removals_of_square = 2;
inline constexpr double weight = 1.15;  // of the weighted search: its path is at most so many times the shortest

// Gaps at which something ends or begins.
inline constexpr double enough_in_time = 1e-3;   // where obstacles open late, a plan so near to its bound is kept
inline constexpr double beaten_in_time = 0.03;   // the set that is best at once ends so much later with waits: no more
inline constexpr double worth_searching = 0.01;  // a plan so far from its bound is worth further proposers
// A plan so far from its bound is worth counting steps: seldom is one within 3 %, often within 5 %.
inline constexpr double worth_stepping = 0.05;
inline constexpr double most_shortened = 1e-4;  // the disc's path is hardly ever so much shorter than the square's

// Paths in time: rounds of a path for the schedule of the one before.
inline constexpr int most_rounds = 8;

}  // namespace waybreaker::tuning
