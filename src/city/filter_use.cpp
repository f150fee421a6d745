#include "city/filter_use.hpp"

#include <fmt/format.h>

#include "core/in_quotes.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::city {

FilterUse::FilterUse(const ObstacleChoice& choice) {
    for (const TagFilter& tag : choice.obstacles) unused_.push_back({"obstacles", tag});
    // A profile's barriers are obstacles as well, but not among those that are seen here.
    const bool barriers = choice.only_in_the_way && choice.obstacles.empty();
    for (const TagFilter& tag : choice.destructible) {
        if (!barriers || tag.key != "barrier") unused_.push_back({"destructible", tag});
    }
    for (const TagFilter& tag : choice.protect) {
        if (!barriers || tag.key != "barrier") unused_.push_back({"protected", tag});
    }
    const auto add = [this](const char* option, const Quantity& quantity) {
        if (!quantity.of.empty() && quantity.of != "area") unused_.push_back({option, {.key = quantity.of}, true});
    };
    add("obstacle-weight", choice.weight);
    add("obstacle-breach-time", choice.breach_time);
}

void FilterUse::see(const TagSet& obstacle) {
    std::erase_if(unused_, [&](const Filter& filter) {
        return filter.number ? obstacle.number(filter.tag.key).value_or(0) > 0 : obstacle.matches_any({filter.tag});
    });
}

void FilterUse::see(const Premises& premises) {
    std::erase_if(unused_, [&](const Filter& filter) {
        return filter.option == "protected" && any_fits(premises.tags, {filter.tag});
    });
}

void FilterUse::require_all(const std::string& source) const {
    if (all_used()) return;
    const Filter& filter = unused_.front();
    const char* const nothing = filter.option == "obstacles" ? "no area or line of {} is that"
                                : filter.number              ? "no obstacle of {} says a number above 0 there"
                                                             : "no obstacle of {} is that";
    throw OptionError(filter.option,
                      fmt::format("{}: {}; is it spelt as the source has it?", in_quotes(filter.tag.text()),
                                  fmt::format(fmt::runtime(nothing), source)));
}

}  // namespace waybreaker::city
