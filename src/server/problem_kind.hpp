// Problem kinds: what can go wrong, by names that stay. A problem document's `type` is the path of its kind, which the
// service answers with what it means.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace waybreaker::server {

struct ProblemKind {
    std::string_view name;  // "map-not-found"
    int status;
    std::string_view title;
    std::string_view remedy;

    std::string type() const { return "/problems/" + std::string(name); }
};

// All there are; of those with one status the first is what a problem is unless more is known.
std::span<const ProblemKind> problem_kinds();

// Null if there is none.
const ProblemKind* kind_of(std::string_view name);
const ProblemKind* kind_of(int status);

}  // namespace waybreaker::server
