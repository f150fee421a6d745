// Memory account: counts what a thread allocates, in a share of the memory budget, while it works for the account.
// Allocations that the budget has no room for throw std::bad_alloc, as those do that the system has no room for. So
// what is limited is what searches really take, which no formula knows beforehand.
//
// Counts operator new and delete, which this file's source replaces for the whole program; and calloc and free where
// our own code calls them (the linker's --wrap, see CMakeLists.txt): also pages that are not touched yet. Not what
// libraries allocate in other ways.
#pragma once

#include <cstddef>

#include "service/memory_budget.hpp"

namespace waybreaker::service {

// For one thread at a time.
class MemoryAccount {
  public:
    MemoryAccount(MemoryBudget& budget, MemoryBudget::Use use) : share_(budget, use) {}

    // As long as it lives, its thread works for `account`; null: for none. Of several the innermost counts.
    class Scope {
      public:
        explicit Scope(MemoryAccount* account);
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;
        ~Scope();
        // Whom the thread worked for before.
        MemoryAccount* outer() const { return outer_; }

      private:
        MemoryAccount* outer_;
    };

    // Of the budget; not less than bytes().
    std::size_t reserved() const { return share_.bytes(); }
    // Allocated and not freed. What other threads, or this one beyond its scopes, allocate or free is not counted.
    std::size_t bytes() const { return bytes_; }
    // With the last allocation that there was no room for; 0 if there was room for all.
    std::size_t needed() const { return needed_; }

    // For operator new and delete.
    bool add(std::size_t bytes);
    void subtract(std::size_t bytes);

  private:
    bool reserve(std::size_t bytes);

    MemoryBudget::Share share_;
    std::size_t bytes_ = 0;
    std::size_t needed_ = 0;
};

}  // namespace waybreaker::service
