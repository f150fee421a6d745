// Sorties: which aircraft breaches what, in which order and from which cells, so that the coalition is done early;
// collisions of vehicles aside.
//
// Aircraft never wait: so their orders alone say when obstacles are open, and each vehicle takes the way on which it
// arrives first then.
#pragma once

#include <functional>
#include <vector>

#include "coalition/ways.hpp"
#include "schedule/precedence.hpp"
#include "schedule/sorties.hpp"
#include "select/candidate.hpp"
#include "team/fleet.hpp"

namespace waybreaker::coalition {

// A set put in time.
struct Draft {
    Set set;
    Sorties sorties;         // their targets are positions in the set
    Openings openings;       // when each of the set is gone
    std::vector<Way> taken;  // by vehicle: the way that it drives
    team::Cost cost{.missing = 1, .first = infinity, .second = infinity};
};

class SortiePlanner {
  public:
    // All arguments must outlive it.
    SortiePlanner(const Problem& problem, Ways& ways, Workers& workers)
        : problem_(problem), ways_(ways), workers_(workers), due_([&problem] { return problem.interrupts().due(); }) {}

    // The best sorties found for a set: obstacles are inserted in the order in which vehicles come to them, a few of
    // them in every order; then single ones are moved, and cells exchanged, while that gains. Obstacles that nobody
    // drives through are left out, but for those of `kept`. The same each time.
    // `worth`: what it should cost less than; else no effort is made. Until ways have taken `enough` effort, they are
    // looked for in the times of every order in which the aircraft may work, too.
    Draft plan(Set set, const Set& kept, double worth, std::uint64_t enough = 0);
    // The best of those that insert obstacles, where that vehicle may drive as in its own mission, and the sorties of
    // that mission. Nothing is left out.
    Draft plan_as_own(const Set& set, std::size_t vehicle, const Candidate& own);

  private:
    void prepare(const Set& set);
    void search_ways(const Set& set);
    Draft best_for(const Set& set);
    SortieSearch search() const;
    bool rank(Draft& draft) const;
    void fill(Draft& draft) const;
    double could_cost(const Draft& draft) const;
    void try_all_orders(Draft& draft, double worth, std::uint64_t enough);
    bool find_timed_ways(const Draft& draft, bool thorough);
    Sorties sorties_of(const Candidate& candidate, const Set& set) const;
    std::vector<std::size_t> by_need() const;

    const Problem& problem_;
    Ways& ways_;
    Workers& workers_;
    std::function<bool()> due_;  // whether time is over
    std::vector<Target> targets_;
    std::size_t flown_ = 0;                       // targets that do not open by themselves
    std::vector<std::vector<const Way*>> menus_;  // by vehicle
    Precedence precedence_;                       // of all on any way of theirs
};

}  // namespace waybreaker::coalition
