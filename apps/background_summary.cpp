#include "background_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace waybreaker::apps {

std::vector<std::string> background_summary(const site::Background& background) {
    using Kind = site::Background::Kind;
    struct Words {
        Kind kind;
        const char* one;
        const char* many;
    };
    constexpr std::array<Words, 5> words{{{Kind::street, "street", "streets"},
                                          {Kind::rail, "railway", "railways"},
                                          {Kind::water, "water", "waters"},
                                          {Kind::green, "green area", "green areas"},
                                          {Kind::place, "place", "places"}}};
    std::vector<std::string> counts;
    for (const auto& [kind, one, many] : words) {
        const auto count = std::ranges::count(background.features, kind, &site::Background::Feature::kind);
        if (count > 0) counts.push_back(fmt::format("{} {}", count, count == 1 ? one : many));
    }
    return counts;
}

}  // namespace waybreaker::apps
