// What the tables of a plan are made of: aligned rows, figures, units.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/plan_json.hpp"

namespace waybreaker::apps {

using Row = std::vector<std::string>;

// What is not known.
inline const std::string nothing = "-";

// The first column to the left, the others to the right, names in the last one as they are; the first row is the
// heading.
std::string aligned(const std::vector<Row>& rows, bool bold, bool names = false);

// A name from a file, as far as a table has room for it, without characters that command a terminal.
std::string shortened(std::string_view name);

std::string text(std::optional<double> value, int digits);
std::string text(Cell c);

// "-3.2 %", "same"; empty where it cannot be said.
std::string change(std::optional<double> before, std::optional<double> after);

// With unit speeds times are lengths (paper, section 2).
bool times_are_lengths(const io::PlanContext& context);
const char* time_unit(const io::PlanContext& context);
// "time", in seconds "time (s)".
std::string timed(const char* what, const io::PlanContext& context);

}  // namespace waybreaker::apps
