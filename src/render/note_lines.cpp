#include "render/note_lines.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "render/palette.hpp"
#include "render/signs.hpp"
#include "render/xml_text.hpp"

namespace waybreaker::render {
namespace {

constexpr std::size_t most_letters = 128;  // of a line
constexpr std::size_t most_lines = 5;

// Goes past as many words as fit, and the blank behind them; at least past one word.
std::string_view take_line(std::string_view& text) {
    std::size_t end = 0;
    while (end < text.size()) {
        const std::size_t next = std::min(text.find(' ', end + 1), text.size());
        if (end > 0 && letter_count(text.substr(0, next)) > most_letters) break;
        end = next;
    }
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

// Notes begin small and have no full stop, as they do on a command line.
std::string sentence(std::string note) {
    if (!note.empty()) note.front() = char(std::toupper(static_cast<unsigned char>(note.front())));
    return note + '.';
}

}  // namespace

std::vector<std::string> note_lines(const std::vector<std::string>& notes) {
    std::vector<std::string> lines;
    for (const std::string& note : notes) {
        const std::string text = sentence(note);
        for (std::string_view rest = text; !rest.empty();) {
            if (lines.size() == most_lines) {
                lines.back() += " \u2026";
                return lines;
            }
            lines.push_back(xml_text(take_line(rest), most_letters));
        }
    }
    return lines;
}

std::string draw_notes(const std::vector<std::string>& lines, Point small_print, double unit) {
    std::string out;
    Point at{small_print.x, small_print.y - double(lines.size()) * size::note_row * unit};
    for (const std::string& line : lines) {
        out += text(at, line, size::small_text * unit, colour::ink);
        at.y += size::note_row * unit;
    }
    return out;
}

}  // namespace waybreaker::render
