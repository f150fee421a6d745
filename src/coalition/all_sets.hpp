// Every set that may be removed, where these are few: none of them needs to be guessed then.
#pragma once

#include <cstddef>
#include <vector>

#include "coalition/columns.hpp"

namespace waybreaker::coalition {

// Of obstacles by which some vehicle may arrive earlier, beside those that must be removed, within count and budget;
// the smaller ones first. Empty if there are more than `most`.
std::vector<Set> all_sets(const Problem& problem, const Columns& columns, std::size_t most);

}  // namespace waybreaker::coalition
