// The table that `waybreaker plan` prints for people: before and after, as the paper reports it, and what is removed.
#pragma once

#include <string>

#include "io/plan_json.hpp"

namespace waybreaker::apps {

struct TableStyle {
    bool metres = false;  // lengths in metres beside those in cells
    bool bold = false;    // headings, for a terminal
};

// Precondition: the plan is solved.
std::string plan_table(const Plan& plan, const io::PlanContext& context, const TableStyle& style);

}  // namespace waybreaker::apps
