// Filters of things by their tags, the key=value pairs that map data says of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace waybreaker::site {

// Whether the value of a tag denies it: `no`, and what other sources write for it, `false` and 0.
bool says_no(std::string_view value);

// Things by a tag: `building` is every building, `barrier=wall,fence` some barriers, `*` everything. A * in a value
// stands for any text. A tag that says_no does not count.
struct TagFilter {
    std::string key;
    std::vector<std::string> values = {};  // any, if empty
    bool accepts(const std::string& value) const;
    std::string text() const;  // KEY or KEY=VALUE,...
};

// Whether a text is a pattern in which * stands for any text. Time O(text * pattern).
bool fits(std::string_view text, std::string_view pattern);

// One or more of KEY and KEY=VALUE,... with commas between: what follows a KEY=VALUE and has no = is another value of
// that key. Throws InputError if it is something else.
std::vector<TagFilter> parse_tag_filters(const std::string& text);

}  // namespace waybreaker::site
