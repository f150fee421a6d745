// Problem kinds: stable names for what can go wrong. A problem document's `type` is the path of its kind, where the
// service explains it.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace waybreaker::service {

struct ProblemKind {
    std::string_view name;  // "map-not-found"
    int status;
    std::string_view title;
    std::string_view remedy;

    std::string type() const { return "/problems/" + std::string(name); }
};

// All kinds; the first one of a status is its default.
std::span<const ProblemKind> problem_kinds();

// Null if there is none.
const ProblemKind* kind_of(std::string_view name);
const ProblemKind* kind_of(int status);

// The document: {"type": "/problems/map-not-found", "title": "There is no map of this name", "status": 404,
// "detail": "..."}.
std::string problem_json(int status, const std::string& detail, std::string_view kind = "");

}  // namespace waybreaker::service
