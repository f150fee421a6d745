#include "render/bands.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/palette.hpp"

namespace waybreaker::render {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// The least step of 1, 1.5, 2, ... 8 times a power of ten of which so many make `whole`.
double round_step(double whole, int most) {
    const double least = whole / most;
    const double power = std::pow(10, std::floor(std::log10(least)));
    for (const double digits : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0}) {
        if (digits * power >= least) return digits * power;
    }
    return 10 * power;
}

}  // namespace

Bands::Bands(const Reach& reach, const Mission& mission, double factor)
    : factor_(factor), unreached_(mission.rules.unreached.value_or(std::numeric_limits<double>::max())) {
    double latest = 0;
    for (const auto* times : {&reach.before, &reach.after}) {
        for (const float time : *times) {
            if (is_reached(time)) latest = std::max(latest, shown(time));
        }
    }
    step_ = round_step(std::max(latest, 1e-6), int(colour::bands.size()));
    count_ = std::min(std::size_t(std::ceil(latest / step_)), colour::bands.size());
}

std::size_t Bands::of(float time) const {
    return std::min(std::size_t(shown(time) / step_), std::max<std::size_t>(count_, 1) - 1);
}

BandRaster band_raster(const Map& map, const Plan& plan, const Reach& reach, const Bands& bands, int step) {
    BandRaster raster{(map.width() + step - 1) / step, (map.height() + step - 1) / step, {}, {}, {}};
    std::vector<ObstacleId> removed;
    for (const Breach& breach : plan.breaches) removed.push_back(breach.obstacle);
    const OpenedMap opened(map, removed);
    const auto band = [&bands](bool is_free, float time) {
        return std::uint32_t(is_free ? (bands.is_reached(time) ? bands.of(time) : bands.count()) + 1 : 0);
    };
    for (int row = 0; row < raster.height; ++row) {
        for (int column = 0; column < raster.width; ++column) {
            float before = infinity;
            float after = infinity;
            bool was_free = false;
            bool is_free = false;
            for (int y = row * step; y < std::min((row + 1) * step, map.height()); ++y) {
                for (int x = column * step; x < std::min((column + 1) * step, map.width()); ++x) {
                    const std::size_t at = std::size_t(y) * std::size_t(map.width()) + std::size_t(x);
                    before = std::min(before, reach.before[at]);
                    after = std::min(after, reach.after[at]);
                    was_free = was_free || !map.grid().blocked({x, y});
                    is_free = is_free || !opened.blocked({x, y});
                }
            }
            raster.before.push_back(band(was_free, before));
            raster.after.push_back(band(is_free, after));
            const bool only_now = was_free && bands.only_now(before, after);
            raster.gains.push_back(only_now ? 2 : bands.sooner(before, after) ? 1 : 0);
        }
    }
    return raster;
}

}  // namespace waybreaker::render
