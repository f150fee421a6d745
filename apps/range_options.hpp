// How far aircraft may fly: options, and what a plan leaves of it.
#pragma once

#include <string>

#include "plan_options.hpp"
#include "plan_table.hpp"

namespace waybreaker::apps {

void add_range_options(CLI::App& command, PlanOptions& options);

// Of all aircraft. Throws InputError where there are none. REQUIRES: the mission's clock is set.
void set_ranges(const PlanOptions& options, const io::MapFile& map, io::MissionDocument& document);

// What is left at landing, and what is out of range: a line each.
std::string ranges_left(const Plan& plan, const io::PlanContext& context, const TableStyle& style);
std::string out_of_range(const Plan& plan, const io::PlanContext& context, const TableStyle& style);

}  // namespace waybreaker::apps
