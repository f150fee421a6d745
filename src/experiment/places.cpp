#include "experiment/places.hpp"

#include <fmt/format.h>

#include <limits>

#include "site/tag_filter.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::experiment {

Places places_of(const Experiment& experiment, const std::string& spec) {
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    const std::vector<std::string>& patterns = experiment.places;
    Places places{std::vector<std::size_t>(experiment.maps.size(), none), patterns.size()};
    for (std::size_t p = 0; p < patterns.size(); ++p) {
        bool fits_any = false;
        for (std::size_t m = 0; m < experiment.maps.size(); ++m) {
            const std::string& name = experiment.maps[m].name;
            if (!site::fits(name, patterns[p])) continue;
            fits_any = true;
            if (places.of_map[m] != none) {
                throw InputError(spec, 0,
                                 fmt::format("the places '{}' and '{}' both hold {}", patterns[places.of_map[m]],
                                             patterns[p], name));
            }
            places.of_map[m] = p;
        }
        if (!fits_any) throw InputError(spec, 0, fmt::format("the place '{}' holds none of the maps", patterns[p]));
    }
    for (std::size_t& place : places.of_map) {
        if (place == none) place = places.count++;
    }
    return places;
}

}  // namespace waybreaker::experiment
