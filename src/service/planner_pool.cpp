#include "service/planner_pool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <new>
#include <utility>

#include "http/problem.hpp"

namespace waybreaker::service {
namespace {

// A planner that has less is as good for another map.
constexpr std::size_t little = std::size_t{32} << 20;

bool same(const std::weak_ptr<const StoredMap>& one, const std::weak_ptr<const StoredMap>& other) {
    return !one.owner_before(other) && !other.owner_before(one);
}

// Why a search got no more memory. `own`: what the plan has reserved beside the planner.
http::Problem shortage(const MemoryBudget& budget, const std::weak_ptr<const StoredMap>& map,
                       const MemoryAccount& planner, std::size_t own) {
    const SharedMap there = map.lock();
    const std::size_t beside = own + (there && there->memory ? there->memory->bytes() : 0);
    const bool others = budget.used() > beside + planner.reserved();
    if (others && beside + planner.needed() <= budget.most()) {
        return {http::unavailable, "what others use leaves too little memory for this plan; ask again", "no-memory"};
    }
    return {http::too_large,
            fmt::format("the map and a plan on it take more than the {} MB of memory there are (--max-memory)",
                        budget.most() >> 20U),
            "map-too-large"};
}

}  // namespace

struct PlannerPool::Loan::Pooled {
    explicit Pooled(MemoryBudget& budget) : account(budget, MemoryBudget::Use::planner) {}

    MemoryAccount account;
    Planner planner;
    std::weak_ptr<const StoredMap> map;  // it has planned on last
    Clock::time_point rests_since;
    bool failed = false;  // half a search is left in it
};

PlannerPool::PlannerPool(MemoryBudget& budget) : budget_(budget) {
    budget_.when_short([this] { return release_one(); });
}

PlannerPool::~PlannerPool() = default;

PlannerPool::Loan::Loan(PlannerPool& pool, std::unique_ptr<Pooled> planner)
    : pool_(&pool), planner_(std::move(planner)) {}
PlannerPool::Loan::Loan(Loan&&) noexcept = default;

PlannerPool::Loan::~Loan() {
    if (!planner_) return;
    const MemoryAccount::Scope none(nullptr);
    planner_->failed ? planner_.reset() : pool_->take_back(std::move(planner_));
}

// The result is the caller's: allocated for whom the caller works.
template <class Call>
auto PlannerPool::Loan::metered(Call call) {
    const MemoryAccount::Scope scope(&planner_->account);
    planner_->failed = true;
    try {
        const auto result = call(planner_->planner);
        planner_->failed = false;
        const MemoryAccount::Scope outer(scope.outer());
        auto copy = result;
        return copy;
    } catch (const std::bad_alloc&) {
        if (planner_->account.needed() == 0) throw;
        const MemoryAccount* const outer = scope.outer();
        throw shortage(pool_->budget_, planner_->map, planner_->account, outer ? outer->reserved() : 0);
    }
}

Plan PlannerPool::Loan::plan(const Map& map, const Mission& mission, const Method& method, const Limits& limits) {
    return metered([&](Planner& planner) { return planner.plan(map, mission, method, limits); });
}

std::vector<Plan> PlannerPool::Loan::front(const Map& map, const Mission& mission, const Method& method,
                                           const Limits& limits) {
    return metered([&](Planner& planner) { return planner.front(map, mission, method, limits); });
}

Revision PlannerPool::Loan::revise(const Map& map, const Mission& mission, const Plan& plan, const State& state,
                                   double reaction, const Method& method, const Limits& limits) {
    return metered([&](Planner& planner) {
        return waybreaker::revise(planner, map, mission, plan, state, reaction, method, limits);
    });
}

PlannerPool::Loan PlannerPool::borrow(const SharedMap& map) {
    const MemoryAccount::Scope none(nullptr);
    std::unique_ptr<Pooled> planner;
    {
        const std::scoped_lock lock(mutex_);
        const auto fits = [&map](const auto& one) { return same(one->map, map) || one->account.bytes() <= little; };
        const auto known = [&map](const auto& one) { return same(one->map, map); };
        auto found = std::find_if(resting_.rbegin(), resting_.rend(), known);
        if (found == resting_.rend()) found = std::find_if(resting_.rbegin(), resting_.rend(), fits);
        if (found != resting_.rend()) {
            planner = std::move(*found);
            resting_.erase(std::next(found).base());
        }
    }
    if (!planner) planner = std::make_unique<Pooled>(budget_);
    planner->map = map;
    return {*this, std::move(planner)};
}

void PlannerPool::take_back(std::unique_ptr<Pooled> planner) {
    planner->rests_since = Clock::now();
    const std::scoped_lock lock(mutex_);
    resting_.push_back(std::move(planner));
}

bool PlannerPool::release_one() {
    std::unique_ptr<Pooled> released;  // destroyed without the lock: that takes time
    const std::scoped_lock lock(mutex_);
    if (resting_.empty()) return false;
    released = std::move(resting_.front());
    resting_.erase(resting_.begin());
    return true;
}

void PlannerPool::release_rested(Clock::duration time) {
    std::vector<std::unique_ptr<Pooled>> released;
    const std::scoped_lock lock(mutex_);
    const Clock::time_point latest = Clock::now() - time;
    const auto stays = [latest](const auto& one) { return !one->map.expired() && one->rests_since > latest; };
    const auto gone = std::stable_partition(resting_.begin(), resting_.end(), stays);
    std::move(gone, resting_.end(), std::back_inserter(released));
    resting_.erase(gone, resting_.end());
}

}  // namespace waybreaker::service
