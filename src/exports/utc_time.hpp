// Dates and times of formats that know no other: UTC, as ISO 8601 writes it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace waybreaker::exports {

// Seconds since 1970 of a text such as 2026-05-01T08:00:00Z; empty if it is none.
std::optional<std::int64_t> parse_utc(std::string_view text);

// 2026-05-01T08:00:12.500Z, to a millisecond. Throws InputError after the year 9999, which formats cannot say.
std::string utc_text(std::int64_t start, double seconds_later);

}  // namespace waybreaker::exports
