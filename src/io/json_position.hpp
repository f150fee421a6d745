// The position of a value in the text of a JSON document. Found by parsing the text again, so that, but for
// repeated_name(), only errors cost time.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace waybreaker::io {

// "FILE:LINE:COLUMN", both counted from 1, columns in characters (UTF-8).
std::string file_position(const std::string& file, std::string_view text, std::size_t byte);

// The byte at which a value begins. `place` is what JsonField calls it: "removed[2].at".
// Precondition, here and below: the text is JSON, and has that value.
std::size_t value_at(std::string_view text, std::string_view place);

// The byte at which the name of a member begins, of the object that begins at a byte.
std::size_t name_at(std::string_view text, std::size_t object, std::string_view name);

// The first name that an object has twice, and where it stands for the second time.
struct RepeatedName {
    std::size_t at = 0;
    std::string name;
};
std::optional<RepeatedName> repeated_name(std::string_view text);

// The first bracket that opens more than so many levels; the end of the text if there is none.
std::size_t depth_at(std::string_view text, int most_levels);

// The first number that is too large for a double; the end of the text if there is none.
std::size_t overflow_at(std::string_view text);

}  // namespace waybreaker::io
