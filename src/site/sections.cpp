#include "site/sections.hpp"

#include <algorithm>
#include <array>

namespace waybreaker::site {
namespace {

void keep_each_once(std::vector<std::uint32_t>& numbers) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

std::size_t section_count(const Sections& sections) {
    return std::size_t(
        std::count_if(sections.parts.begin(), sections.parts.end(), [](const auto& parts) { return !parts.empty(); }));
}

std::vector<std::uint32_t> structures_of(const Sections& sections, std::span<const ObstacleId> obstacles) {
    std::vector<std::uint32_t> found;
    for (const ObstacleId id : obstacles) {
        if (id.value >= sections.parts.size()) continue;
        const auto& parts = sections.parts[id.value];
        found.insert(found.end(), parts.begin(), parts.end());
    }
    keep_each_once(found);
    return found;
}

std::vector<std::uint32_t> cut_structures(const Sections& sections) {
    std::vector<std::uint32_t> found;
    for (const auto& parts : sections.parts) found.insert(found.end(), parts.begin(), parts.end());
    keep_each_once(found);
    return found;
}

std::string structures_text(const Sections& sections, std::span<const std::uint32_t> positions) {
    constexpr std::array<const char*, 3> words{"building", "barrier", "structure"};
    std::array<std::size_t, words.size()> counts{};
    for (const std::uint32_t position : positions) {
        const ObstacleKind kind = sections.structures[position].kind;
        ++counts[kind == ObstacleKind::building ? 0 : kind == ObstacleKind::barrier ? 1 : 2];
    }
    std::string text;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] == 0) continue;
        text += (text.empty() ? "" : ", ") + std::to_string(counts[i]) + " " + words[i] + (counts[i] == 1 ? "" : "s");
    }
    return text;
}

std::string sections_summary(const Sections& sections) {
    const std::size_t count = section_count(sections);
    return std::to_string(count) + (count == 1 ? " section of " : " sections of ") +
           structures_text(sections, cut_structures(sections));
}

}  // namespace waybreaker::site
