#include "service/memory_budget.hpp"

#include <malloc.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace waybreaker::service {

MemoryBudget::MemoryBudget(std::size_t most) : most_(most) {}

void MemoryBudget::when_short(std::function<bool()> free_some) {
    free_some_.push_back(std::move(free_some));
}

std::size_t MemoryBudget::most(Use use) const {
    return use == Use::source || use == Use::answer || use == Use::mission ? most_ / 4 : most_;
}

std::size_t MemoryBudget::total() const {
    return std::accumulate(used_.begin(), used_.end(), std::size_t{0});
}

std::size_t MemoryBudget::used() const {
    const std::scoped_lock lock(mutex_);
    return total();
}

std::size_t MemoryBudget::used(Use use) const {
    const std::scoped_lock lock(mutex_);
    return used_[std::size_t(use)];
}

bool MemoryBudget::take(Use use, std::size_t bytes) {
    const std::scoped_lock lock(mutex_);
    std::size_t& used = used_[std::size_t(use)];
    if (bytes > most_ - total() || bytes > most(use) - used) return false;
    used += bytes;
    return true;
}

void MemoryBudget::give_back(Use use, std::size_t bytes) {
    const std::scoped_lock lock(mutex_);
    used_[std::size_t(use)] -= bytes;
    given_back_ += bytes;
}

bool MemoryBudget::free_some() const {
    return std::ranges::any_of(free_some_, [](const auto& free_some) { return free_some(); });
}

void MemoryBudget::trim() {
    constexpr std::size_t worth_it = std::size_t{16} << 20;
    {
        const std::scoped_lock lock(mutex_);
        if (given_back_ < worth_it) return;
        given_back_ = 0;
    }
    malloc_trim(0);
}

MemoryBudget::Share::Share(Share&& other) noexcept
    : budget_(other.budget_), use_(other.use_), bytes_(std::exchange(other.bytes_, 0)) {}

MemoryBudget::Share& MemoryBudget::Share::operator=(Share&& other) noexcept {
    if (this == &other) return *this;
    shrink_to(0);
    budget_ = other.budget_;
    use_ = other.use_;
    bytes_ = std::exchange(other.bytes_, 0);
    return *this;
}

bool MemoryBudget::Share::grow(std::size_t bytes) {
    if (bytes > budget_->most(use_) - bytes_) return false;  // whatever others give back
    while (!budget_->take(use_, bytes)) {
        if (!budget_->free_some()) return false;
    }
    bytes_ += bytes;
    return true;
}

void MemoryBudget::Share::shrink_to(std::size_t bytes) {
    if (bytes >= bytes_) return;
    budget_->give_back(use_, bytes_ - bytes);
    bytes_ = bytes;
}

}  // namespace waybreaker::service
