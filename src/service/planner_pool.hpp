// Planner pool: planners keep the memory of their searches, which makes the next plan faster; on large maps that is
// gigabytes. So it counts in the memory budget, and is given back when the map goes, when others need it, or when the
// planner has rested for a while.
//
//     PlannerPool::Loan planner = pool.borrow(map);
//     const Plan plan = planner.plan(map->file.map, mission, method, limits);
#pragma once

#include <chrono>
#include <memory>
#include <mutex>
#include <vector>

#include "service/map_store.hpp"
#include "service/memory_account.hpp"
#include "service/memory_budget.hpp"
#include "waybreaker/planner.hpp"
#include "waybreaker/revise.hpp"

namespace waybreaker::service {

class PlannerPool {
  public:
    using Clock = std::chrono::steady_clock;

    // Keeps the reference.
    explicit PlannerPool(MemoryBudget& budget);
    PlannerPool(const PlannerPool&) = delete;
    PlannerPool& operator=(const PlannerPool&) = delete;
    ~PlannerPool();

    // A planner that one client uses; goes back to the pool with this object.
    class Loan {
      public:
        Loan(Loan&&) noexcept;
        Loan& operator=(Loan&&) = delete;
        ~Loan();

        // As those of Planner. Throw Problem if the search needs more than the budget has left.
        Plan plan(const Map& map, const Mission& mission, const Method& method, const Limits& limits);
        std::vector<Plan> front(const Map& map, const Mission& mission, const Method& method, const Limits& limits);
        Revision revise(const Map& map, const Mission& mission, const Plan& plan, const State& state, double reaction,
                        const Method& method, const Limits& limits);

      private:
        friend class PlannerPool;
        struct Pooled;
        Loan(PlannerPool& pool, std::unique_ptr<Pooled> planner);
        template <class Call>
        auto metered(Call call);

        PlannerPool* pool_;
        std::unique_ptr<Pooled> planner_;
    };

    // For plans on that map: one that rests and has planned on it comes first.
    Loan borrow(const SharedMap& map);

    // Gives back the memory of one that rests. Whether there was one.
    bool release_one();
    // Of all that rest and whose map is gone, or that have rested for so long.
    void release_rested(Clock::duration time);

  private:
    using Pooled = Loan::Pooled;
    void take_back(std::unique_ptr<Pooled> planner);

    MemoryBudget& budget_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<Pooled>> resting_;  // the one that rests longest first
};

}  // namespace waybreaker::service
