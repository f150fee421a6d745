// Expected: a value, or the error that stands in its way, as std::expected of C++23 has it.
//
//     Expected<Plan> plan = planner.try_plan(map, mission);
//     if (!plan) return report(plan.error().code);
//     follow(plan->agents);
#pragma once

#include <cassert>
#include <utility>
#include <variant>

#include "waybreaker/error.hpp"

namespace waybreaker {

template <class Value>
class [[nodiscard]] Expected {
  public:
    Expected(Value value) : either_(std::in_place_index<0>, std::move(value)) {}
    Expected(Error error) : either_(std::in_place_index<1>, std::move(error)) {}

    bool has_value() const { return either_.index() == 0; }
    explicit operator bool() const { return has_value(); }

    // Precondition of these: there is a value, which builds with assertions check.
    const Value& operator*() const& { return *value(); }
    Value& operator*() & { return *value(); }
    Value&& operator*() && { return std::move(*value()); }
    const Value* operator->() const { return value(); }
    Value* operator->() { return value(); }

    // Precondition: there is none.
    const Error& error() const {
        assert(!has_value());
        return *std::get_if<1>(&either_);
    }

  private:
    const Value* value() const {
        assert(has_value());
        return std::get_if<0>(&either_);
    }
    Value* value() {
        assert(has_value());
        return std::get_if<0>(&either_);
    }

    std::variant<Value, Error> either_;
};

}  // namespace waybreaker
