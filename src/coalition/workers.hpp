// Workers: threads that plan the vehicles of a team side by side. What comes out does not depend on how many there are.
#pragma once

#include <cstddef>
#include <deque>

#include "coalition/problem.hpp"
#include "core/parallel.hpp"
#include "crossing/access.hpp"
#include "schedule/earliest_openings.hpp"
#include "waybreaker/advanced/crossing.hpp"
#include "waybreaker/advanced/search.hpp"

namespace waybreaker::coalition {

// What one thread plans with, and remembers.
struct Worker {
    CrossingSearcher& crossing;  // of the vehicles' own bodies
    CrossingSearcher limits;     // for lower limits: a searcher remembers more of one kind of body than of two in turn
    Searcher& theta;
    EarliestOpenings openings;
};

// A vehicle's own memory, in use for as long as this lives: what comes out does not depend on which worker uses it.
class Remembering {
  public:
    Remembering(CrossingSearcher& searcher, crossing::Memory& memory) : searcher_(searcher), memory_(memory) {
        crossing::Access::exchange(searcher_, memory_);
    }
    Remembering(const Remembering&) = delete;
    Remembering& operator=(const Remembering&) = delete;
    ~Remembering() { crossing::Access::exchange(searcher_, memory_); }

  private:
    CrossingSearcher& searcher_;
    crossing::Memory& memory_;
};

class Workers {
  public:
    // The searchers are for the thread that calls; all arguments must outlive it. All workers share the maps that
    // `crossing` has grown for wide bodies before they first have work.
    Workers(const Problem& problem, CrossingSearcher& crossing, Searcher& theta);

    // Of the thread that calls.
    Worker& own();

    // Calls work(i, worker) for i = 0 .. count - 1, each once, in any order.
    template <class Work>
    void for_each(std::size_t count, const Work& work) {
        gather(count);
        for_each_index(count, unsigned(all_.size()), [&](std::size_t i, std::size_t thread) { work(i, all_[thread]); });
    }

  private:
    // As many as there is work for.
    void gather(std::size_t count);

    const Problem& problem_;
    std::size_t most_;
    CrossingSearcher& crossing_;
    Searcher& theta_;
    std::deque<CrossingSearcher> crossings_;  // of all but the first
    std::deque<Searcher> thetas_;
    std::deque<Worker> all_;
};

}  // namespace waybreaker::coalition
