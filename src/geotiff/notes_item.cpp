#include "geotiff/notes_item.hpp"

#include <gdal_priv.h>

#include <string_view>
#include <utility>

#include "geotiff/obstacle_names.hpp"
#include "geotiff/take_until.hpp"

namespace waybreaker::geotiff {

std::string notes_text(const std::vector<std::string>& notes) {
    std::string text;
    for (const std::string& note : notes) {
        const std::string clean = clean_name(note);
        if (!clean.empty()) text += (text.empty() ? "" : "\n") + clean;
    }
    return text;
}

std::vector<std::string> read_notes(GDALDataset& file) {
    const char* const item = file.GetMetadataItem(notes_item);
    std::string_view text = item ? item : "";
    std::vector<std::string> notes;
    while (!text.empty()) {
        std::string note = clean_name(take_until('\n', text));
        if (!note.empty()) notes.push_back(std::move(note));
    }
    return notes;
}

}  // namespace waybreaker::geotiff
