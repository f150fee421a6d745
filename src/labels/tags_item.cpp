#include "labels/tags_item.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

#include "labels/obstacle_names.hpp"
#include "labels/take_until.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::labels {
namespace {

// One line; whether it could be understood.
bool read_tag(std::string_view line, site::LabelTags& tags) {
    const std::string tag = clean_name(take_until('\t', line));
    if (tag.find('=') == std::string::npos || line.empty()) return false;
    std::vector<std::uint32_t>& labels = tags[tag];
    while (!line.empty()) {
        const std::string_view word = take_until(' ', line);
        std::uint32_t label = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), label);
        if (error != std::errc() || end != word.data() + word.size() || label == 0) return false;
        labels.push_back(label);
    }
    return true;
}

}  // namespace

std::string tags_text(const site::ObstacleTags& tags) {
    std::string text;
    for (const auto& [tag, obstacles] : tags) {
        text += (text.empty() ? "" : "\n") + tag;
        char before = '\t';
        for (const ObstacleId id : obstacles) {
            text += fmt::format("{}{}", before, id.value);
            before = ' ';
        }
    }
    return text;
}

site::LabelTags read_tags(std::string_view text, const std::string& name) {
    site::LabelTags tags;
    for (std::size_t line = 1; !text.empty(); ++line) {
        if (read_tag(take_until('\n', text), tags)) continue;
        throw InputError(
            fmt::format("{}: line {} of its metadata item {} is no tag and the numbers of its obstacles; drop the item "
                        "with 'gdal_edit.py -mo {}=' or import the map anew",
                        name, line, tags_item, tags_item));
    }
    return tags;
}

}  // namespace waybreaker::labels
