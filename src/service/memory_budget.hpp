// Memory budget: what all work of the service may take together (--max-memory). Who needs memory that can grow large
// has a share of it, and takes more before it allocates. When the budget is used up, what nobody uses is given back
// first: buffers of planners that rest, maps that can be sent or read again.
//
//     MemoryBudget::Share share(budget, MemoryBudget::Use::map);
//     if (!share.grow(bytes)) throw Problem(...);    // given back when the share goes
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <mutex>
#include <vector>

namespace waybreaker::service {

class MemoryBudget {
  public:
    // For: maps held; map data held; searches; the rest of a job's work (JSON read, pictures drawn); imports at work;
    // bodies that are received; bodies that are sent; live missions that no file holds.
    enum class Use { map, source, planner, job, importer, request, answer, mission };
    static constexpr std::size_t uses = 8;

    // Sources, answers and missions have at most a quarter each, so that none can take all.
    explicit MemoryBudget(std::size_t most);
    MemoryBudget(const MemoryBudget&) = delete;
    MemoryBudget& operator=(const MemoryBudget&) = delete;

    // `free_some` gives back some of what nobody uses, and says whether there was any. Called on threads that need
    // memory, in the order given here; to be given before there are any.
    void when_short(std::function<bool()> free_some);

    std::size_t most() const { return most_; }
    std::size_t most(Use use) const;
    std::size_t used() const;
    std::size_t used(Use use) const;

    // Returns to the system what the allocator holds of memory that was given back since the last call. Takes
    // milliseconds.
    void trim();

    // Move-only; counts until it is destroyed. Not for two threads at once.
    class Share {
      public:
        Share(MemoryBudget& budget, Use use) : budget_(&budget), use_(use) {}
        Share(Share&& other) noexcept;
        Share& operator=(Share&& other) noexcept;
        ~Share() { shrink_to(0); }

        // False, and no more than before, if there is no room even after others gave back what they do not use.
        bool grow(std::size_t bytes);
        void shrink_to(std::size_t bytes);
        std::size_t bytes() const { return bytes_; }

      private:
        MemoryBudget* budget_;
        Use use_;
        std::size_t bytes_ = 0;
    };

  private:
    bool take(Use use, std::size_t bytes);
    void give_back(Use use, std::size_t bytes);
    bool free_some() const;
    std::size_t total() const;  // with mutex_ locked

    std::size_t most_;
    std::vector<std::function<bool()>> free_some_;
    mutable std::mutex mutex_;  // held for no call of others
    std::array<std::size_t, uses> used_{};
    std::size_t given_back_ = 0;  // since the last trim
};

}  // namespace waybreaker::service
