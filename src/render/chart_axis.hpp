// The vertical axis of a chart: which values it spans, where they lie, which of them are marked.
#pragma once

#include <string>
#include <vector>

#include "render/chart.hpp"

namespace waybreaker::render {

class ChartAxis {
  public:
    // From `bottom` to `top` in the picture, y down.
    ChartAxis(const Chart& chart, double bottom, double top);

    // Where a value lies in the picture.
    double at(double value) const;
    // Whether it can be drawn at all.
    bool shows(double value) const;
    // The lower end of an interval, or of the axis if that cannot be drawn: 0 on a logarithmic one.
    double clipped(double low) const { return shows(low) ? low : least_; }

    struct Tick {
        double value;
        std::string label;
    };
    const std::vector<Tick>& ticks() const { return ticks_; }

  private:
    void span_linear(bool from_zero);
    void span_logarithmic();

    bool logarithmic_;
    double least_;
    double most_;
    double bottom_;
    double top_;
    std::vector<Tick> ticks_;
};

}  // namespace waybreaker::render
