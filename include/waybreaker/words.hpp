// Words: what the values of an enum are called in documents, on the command line and in messages.
//
//     std::cout << to_string(plan.status);                            // "solved"
//     rules.objective = from_string<Objective>("flowtime").value();   // empty for any other word
//
// Each enum that has words lists them beside its definition: words_of<Objective>, in the order of the values.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string_view>

namespace waybreaker {

template <class Enum>
inline constexpr std::array<std::string_view, 0> words_of{};

template <class Enum>
concept HasWords = !words_of<Enum>.empty();

// Empty for a number that is no value of the enum.
template <HasWords Enum>
[[nodiscard]] constexpr std::string_view to_string(Enum value) {
    const auto i = std::size_t(value);
    return i < words_of<Enum>.size() ? words_of<Enum>[i] : std::string_view();
}

template <HasWords Enum>
[[nodiscard]] constexpr std::optional<Enum> from_string(std::string_view word) {
    for (std::size_t i = 0; i < words_of<Enum>.size(); ++i) {
        if (words_of<Enum>[i] == word) return Enum(i);
    }
    return std::nullopt;
}

}  // namespace waybreaker
