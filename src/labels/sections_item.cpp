#include "labels/sections_item.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string_view>

#include "labels/obstacle_names.hpp"
#include "labels/take_until.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::labels {
namespace {

template <class Number>
std::optional<Number> number(std::string_view word) {
    Number value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size() ? std::optional(value) : std::nullopt;
}

// One line; whether it could be understood.
bool read_structure(std::string_view line, site::LabelLayer& layer) {
    std::string_view words = take_until('\t', line);
    const site::ObstacleKind kind = site::kind_called(take_until(' ', words));
    const auto source_id = number<std::int64_t>(take_until(' ', words));
    if (!source_id || words.empty()) return false;
    const auto position = std::uint32_t(layer.structures.size());
    layer.structures.push_back({kind, *source_id, clean_name(line)});
    while (!words.empty()) {
        const auto label = number<std::uint32_t>(take_until(' ', words));
        if (!label || *label == 0) return false;
        std::vector<std::uint32_t>& parts = layer.parts[*label];
        if (parts.empty() || parts.back() != position) parts.push_back(position);
    }
    return true;
}

}  // namespace

std::string sections_text(const site::Sections& sections) {
    std::vector<std::string> numbers(sections.structures.size());
    for (std::size_t id = 1; id < sections.parts.size(); ++id) {
        for (const std::uint32_t structure : sections.parts[id]) numbers[structure] += fmt::format(" {}", id);
    }
    std::string text;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i].empty()) continue;
        const site::Structure& structure = sections.structures[i];
        const std::string name = clean_name(structure.name);
        text += fmt::format("{}{} {}{}{}{}", text.empty() ? "" : "\n",
                            site::obstacle_kind_words[std::size_t(structure.kind)], structure.source_id, numbers[i],
                            name.empty() ? "" : "\t", name);
    }
    return text;
}

void read_sections(std::string_view text, const std::string& name, site::LabelLayer& layer) {
    for (std::size_t line = 1; !text.empty(); ++line) {
        if (read_structure(take_until('\n', text), layer)) continue;
        throw InputError(
            fmt::format("{}: line {} of its metadata item {} is no kind, source id and numbers of sections; drop the "
                        "item with 'gdal_edit.py -mo {}=' or import the map anew",
                        name, line, sections_item, sections_item));
    }
}

}  // namespace waybreaker::labels
