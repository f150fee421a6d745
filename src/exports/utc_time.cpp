#include "exports/utc_time.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>

#include "waybreaker/error.hpp"

namespace waybreaker::exports {
namespace {

using std::chrono::milliseconds;

constexpr std::int64_t end_of_9999 = 253402300800;  // seconds since 1970

std::string text_of(milliseconds since_1970, bool with_fraction) {
    using namespace std::chrono;
    const sys_time<milliseconds> moment{since_1970};
    const sys_days day = floor<days>(moment);
    const year_month_day date{day};
    const hh_mm_ss<milliseconds> time{moment - day};
    std::string text =
        fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}", int(date.year()), unsigned(date.month()),
                    unsigned(date.day()), time.hours().count(), time.minutes().count(), time.seconds().count());
    if (with_fraction) text += fmt::format(".{:03}", time.subseconds().count());
    return text + "Z";
}

}  // namespace

std::optional<std::int64_t> parse_utc(std::string_view text) {
    using namespace std::chrono;
    const std::string given(text);
    int y = 0;
    unsigned mo = 0, d = 0, h = 0, mi = 0, s = 0;
    if (std::sscanf(given.c_str(), "%4d-%2u-%2uT%2u:%2u:%2uZ", &y, &mo, &d, &h, &mi, &s) != 6) return std::nullopt;
    const year_month_day date{year(y), month(mo), day(d)};
    if (y < 0 || !date.ok()) return std::nullopt;
    const seconds since_1970 = sys_days(date).time_since_epoch() + hours(h) + minutes(mi) + seconds(s);
    // What is read back differs where a part is out of range, or something stands before or behind.
    if (text_of(since_1970, false) != text) return std::nullopt;
    return since_1970.count();
}

std::string utc_text(std::int64_t start, double seconds_later) {
    if (!(seconds_later >= 0 && double(start) + seconds_later < double(end_of_9999) - 1)) {
        throw InputError("the plan ends after the year 9999, the last that dates can say; give higher speeds");
    }
    return text_of(milliseconds(1000 * start + std::llround(1000 * seconds_later)), true);
}

}  // namespace waybreaker::exports
