#include "site/tag_filter.hpp"

#include <algorithm>

#include "core/in_quotes.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::site {

bool fits(std::string_view text, std::string_view pattern) {
    std::size_t star = std::string_view::npos;  // the last one that was met
    std::size_t taken = 0;                      // of the text, up to where that star reaches
    std::size_t p = 0;
    for (std::size_t t = 0; t < text.size();) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            taken = t;
        } else if (p < pattern.size() && pattern[p] == text[t]) {
            ++p;
            ++t;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            t = ++taken;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

bool says_no(std::string_view value) {
    const auto is = [value](std::string_view word) {
        return std::ranges::equal(value, word, [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b; });
    };
    return is("no") || is("false") || value == "0";
}

bool TagFilter::accepts(const std::string& value) const {
    // A number of 0 counts where it is asked for.
    if (says_no(value)) return value != "no" && std::ranges::find(values, value) != values.end();
    return values.empty() || std::ranges::any_of(values, [&](const auto& pattern) { return fits(value, pattern); });
}

std::string TagFilter::text() const {
    std::string text = key;
    for (std::size_t i = 0; i < values.size(); ++i) text += (i == 0 ? "=" : ",") + values[i];
    return text;
}

std::vector<TagFilter> parse_tag_filters(const std::string& text) {
    const auto refuse = [&](const std::string& why) {
        throw InputError(in_quotes(text) + why + ": a filter is KEY or KEY=VALUE,... such as barrier=wall,fence");
    };
    std::vector<TagFilter> filters;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string part = text.substr(begin, end - begin);
        begin = end + 1;
        const std::size_t equals = part.find('=');
        if (equals == std::string::npos && !filters.empty() && !filters.back().values.empty()) {
            if (part == "building") {
                refuse(" takes building for a value of " + in_quotes(filters.back().key) +
                       "; put it first, or in an option of its own");
            }
            filters.back().values.push_back(part);
        } else {
            filters.push_back({.key = part.substr(0, equals)});
            if (equals != std::string::npos) filters.back().values.push_back(part.substr(equals + 1));
        }
        const TagFilter& filter = filters.back();
        const bool quote = filter.key.find_first_of("\"'\\") != std::string::npos;
        const bool nothing = filter.key.empty() || (!filter.values.empty() && filter.values.back().empty());
        if (quote || nothing) refuse(" is no filter for tags");
    }
    return filters;
}

}  // namespace waybreaker::site
