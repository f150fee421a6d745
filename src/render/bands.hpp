// Bands of time: by when ground is reached, in steps that people can read, and what a plan gains. Pictures draw them,
// and the page (render/reach_json.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/reach.hpp"
#include "waybreaker/map.hpp"
#include "waybreaker/mission.hpp"
#include "waybreaker/plan.hpp"

namespace waybreaker::render {

// Their times are those that are shown: `factor` is what a unit of the mission's time is in them.
class Bands {
  public:
    Bands(const Reach& reach, const Mission& mission, double factor);

    bool is_reached(float time) const { return time <= unreached_; }
    // 0 is the first one.
    std::size_t of(float time) const;
    std::size_t count() const { return count_; }
    double end(std::size_t band) const { return step_ * double(band + 1); }
    // What is clearly sooner: a tenth of a band.
    double clear_gain() const { return step_ / 10; }
    bool only_now(float before, float after) const { return is_reached(after) && !is_reached(before); }
    bool sooner(float before, float after) const {
        return is_reached(before) && is_reached(after) && shown(before) - shown(after) >= clear_gain();
    }

  private:
    double shown(float time) const { return double(time) * factor_; }

    double factor_;
    double unreached_;
    double step_ = 1;
    std::size_t count_ = 0;
};

// What each square of `step` by `step` cells shows, row by row: the best of its cells.
struct BandRaster {
    int width = 0;
    int height = 0;
    // 0: obstacles; 1 to the number of bands; above: not reached.
    std::vector<std::uint32_t> before;
    std::vector<std::uint32_t> after;
    std::vector<std::uint32_t> gains;  // 1: sooner, 2: only now
};

BandRaster band_raster(const Map& map, const Plan& plan, const Reach& reach, const Bands& bands, int step);

}  // namespace waybreaker::render
