// Text cut into lines and words, with the line number that errors name.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/byte_order_mark.hpp"
#include "core/in_quotes.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker {

// The lines of a text one by one, without a byte order mark, and without their LF or CRLF. Views into the text.
class TextLines {
  public:
    TextLines(std::string_view text, const std::string& name) : rest_(without_byte_order_mark(text)), name_(name) {}

    // Goes to the next line; false at the end of the text, where line() is the last one still.
    bool next() {
        if (rest_.empty()) return false;
        ++number_;
        const std::size_t end = rest_.find('\n');
        line_ = rest_.substr(0, end);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        if (line_.ends_with('\r')) line_.remove_suffix(1);
        return true;
    }
    std::string_view line() const { return line_; }

    // That names this line.
    InputError error(const std::string& message) const { return {name_, number_, message}; }

  private:
    std::string_view rest_;
    std::string_view line_;
    const std::string& name_;
    std::size_t number_ = 0;
};

// Without spaces and tabs at its ends.
inline std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// What stands between spaces and tabs; of a line of too many words only the first, as no format here has so many.
inline std::vector<std::string_view> words(std::string_view line) {
    constexpr std::size_t most = 64;
    std::vector<std::string_view> found;
    for (std::size_t begin = 0;
         found.size() < most && (begin = line.find_first_not_of(" \t", begin)) != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(" \t", begin), line.size());
        found.push_back(line.substr(begin, end - begin));
        begin = end;
    }
    return found;
}

}  // namespace waybreaker
