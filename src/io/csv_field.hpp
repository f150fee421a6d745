// A text as a field of CSV (RFC 4180).
#pragma once

#include <string>
#include <string_view>

namespace waybreaker::io {

// Quoted where it must be. Spreadsheets take a text that begins with = + - @, a tab or a carriage return for a formula,
// quoted or not, and such a formula may start programs: unless it is a number, an apostrophe goes before it.
std::string csv_field(std::string_view text);

}  // namespace waybreaker::io
