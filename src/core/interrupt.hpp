// Interrupt: whether a search has to end early, asked for so often that the clock is read now and then only.
#pragma once

#include <utility>

#include "core/stopwatch.hpp"
#include "waybreaker/limits.hpp"

namespace waybreaker::crossing {

class Interrupt {
  public:
    enum class Cause { none, limit, stop };

    Interrupt() = default;
    Interrupt(double seconds, StopToken stop) : deadline_(seconds), stop_(std::move(stop)) {}

    // Once due, always due.
    bool due() {
        constexpr unsigned calls_per_look = 64;
        return calls_++ % calls_per_look == 0 ? due_now() : cause_ != Cause::none;
    }
    // For steps that may take long: reads the clock each time.
    bool due_now() {
        if (cause_ == Cause::none) {
            cause_ = stop_.stop_requested() ? Cause::stop : deadline_.passed() ? Cause::limit : Cause::none;
        }
        return cause_ != Cause::none;
    }
    Cause cause() const { return cause_; }

  private:
    Deadline deadline_;
    StopToken stop_;
    unsigned calls_ = 0;
    Cause cause_ = Cause::none;
};

}  // namespace waybreaker::crossing
