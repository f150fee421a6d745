#include "labels/notes_item.hpp"

#include <string_view>
#include <utility>

#include "labels/obstacle_names.hpp"
#include "labels/take_until.hpp"

namespace waybreaker::labels {

std::string notes_text(const std::vector<std::string>& notes) {
    std::string text;
    for (const std::string& note : notes) {
        const std::string clean = clean_name(note);
        if (!clean.empty()) text += (text.empty() ? "" : "\n") + clean;
    }
    return text;
}

std::vector<std::string> read_notes(std::string_view text) {
    std::vector<std::string> notes;
    while (!text.empty()) {
        std::string note = clean_name(take_until('\n', text));
        if (!note.empty()) notes.push_back(std::move(note));
    }
    return notes;
}

}  // namespace waybreaker::labels
