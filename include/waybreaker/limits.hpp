// Limits: how long a call may take, how good is good enough, and how to end it from outside.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

namespace waybreaker {

// Stands for std::stop_token, which not every standard library has yet: asks work on other threads to end.
class StopToken {
  public:
    StopToken() = default;  // never asks
    bool stop_requested() const {
        return state_ && (state_->requested.load(std::memory_order_relaxed) || (state_->look && state_->look()));
    }

  private:
    friend class StopSource;
    struct State {
        std::atomic<bool> requested = false;
        std::function<bool()> look = {};  // asked as well, each time
    };
    explicit StopToken(std::shared_ptr<const State> state) : state_(std::move(state)) {}
    std::shared_ptr<const State> state_;
};

class StopSource {
  public:
    StopSource() : state_(std::make_shared<StopToken::State>()) {}
    // Its token asks this as well whenever it is asked itself, on the thread that works.
    explicit StopSource(std::function<bool()> look) : StopSource() { state_->look = std::move(look); }

    StopToken get_token() const { return StopToken(state_); }
    bool stop_requested() const { return state_->requested.load(std::memory_order_relaxed); }
    // Whether this is the first time.
    bool request_stop() { return !state_->requested.exchange(true, std::memory_order_relaxed); }

  private:
    std::shared_ptr<StopToken::State> state_;
};

// What is known of the objective while obstacles are still being selected, in units of time.
struct Progress {
    double best = std::numeric_limits<double>::infinity();  // of the best plan so far
    double bound = 0;                                       // no plan is below it
};

struct Limits {
    // Time limit for the whole call, in seconds, > 0; on expiry the best result found so far is returned. It may be
    // overrun by what lies between two looks at the clock, which grows with the map: with a limit of 1 ms on 1024 x
    // 1024 cells, calls took up to 17 ms for a disc of radius 1.
    double seconds = std::numeric_limits<double>::infinity();
    std::uint64_t expansions = UINT64_MAX;  // of each single search
    // A plan is good enough if it is proven to be above the best possible by no more than this share of it, >= 0:
    // planning ends there, and no choice is tried that gains less than this share. The same plan comes out
    // every time, unless a time limit ends planning before. Single searches do not use it.
    double gap = 0;
    // So many threads plan the vehicles of a team with aircraft side by side (0: all cores): the same plan, sooner. All
    // else is done by the thread that calls.
    unsigned threads = 1;
    StopToken stop = {};  // checked, as the time is, at least every 1024 expansions
    // Called by `exact` whenever more is known, on the thread that calls. Single searches do not call it.
    std::function<void(const Progress&)> progress = {};
};

}  // namespace waybreaker
