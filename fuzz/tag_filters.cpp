#include "city/obstacle_choice.hpp"
#include "laws.hpp"

// Errors name the option where there is one; here it is the input.
static std::vector<waybreaker::city::TagFilter> parsed(std::string_view text) try {
    return waybreaker::city::parse_tag_filters(std::string(text));
} catch (const waybreaker::InputError& error) {
    throw waybreaker::InputError("input", 0, error.what());
}

// Filters come back from their own text.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace waybreaker;
    read_or_refuse(data, size, [](std::string_view bytes) {
        const auto filters = parsed(bytes);
        law(!filters.empty());
        std::string text;
        for (const city::TagFilter& filter : filters) {
            law(!filter.key.empty());
            if (!text.empty()) text += ',';
            text += filter.text();
        }
        const auto again = parsed(text);
        law(again.size() == filters.size());
        for (std::size_t i = 0; i < again.size(); ++i) {
            law(again[i].key == filters[i].key && again[i].values == filters[i].values);
        }
    });
    return 0;
}
