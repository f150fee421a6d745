#include "labels/kinds_item.hpp"

#include <fmt/format.h>

#include <charconv>

#include "labels/take_until.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::labels {

std::string kinds_text(const site::ObstacleKinds& kinds) {
    std::string text;
    for (std::size_t kind = 1; kind < site::obstacle_kind_words.size(); ++kind) {
        std::string numbers;
        for (std::size_t id = 1; id < kinds.size(); ++id) {
            if (kinds[id] == site::ObstacleKind(kind)) numbers += fmt::format(" {}", id);
        }
        if (numbers.empty()) continue;
        text += fmt::format("{}{}{}", text.empty() ? "" : "\n", site::obstacle_kind_words[kind], numbers);
    }
    return text;
}

site::LabelKinds read_kinds(std::string_view text, const std::string& name) {
    site::LabelKinds kinds;
    for (std::size_t line = 1; !text.empty(); ++line) {
        std::string_view rest = take_until('\n', text);
        const site::ObstacleKind kind = site::kind_called(take_until(' ', rest));
        while (!rest.empty()) {
            const std::string_view word = take_until(' ', rest);
            std::uint32_t label = 0;
            const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), label);
            if (error != std::errc() || end != word.data() + word.size() || label == 0) {
                throw InputError(
                    fmt::format("{}: line {} of its metadata item {} is no kind and the numbers of its obstacles; drop "
                                "the item with 'gdal_edit.py -mo {}=' or import the map anew",
                                name, line, kinds_item, kinds_item));
            }
            if (kind != site::ObstacleKind::unknown) kinds.insert_or_assign(label, kind);
        }
    }
    return kinds;
}

}  // namespace waybreaker::labels
