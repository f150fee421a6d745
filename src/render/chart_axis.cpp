#include "render/chart_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace waybreaker::render {
namespace {

constexpr int wanted_ticks = 6;

// 1, 2 or 5 times a power of ten, so that about `wanted_ticks` steps make the range.
double nice_step(double range) {
    const double power = std::pow(10, std::floor(std::log10(range / wanted_ticks)));
    for (const double factor : {1, 2, 5}) {
        if (factor * power * wanted_ticks >= range) return factor * power;
    }
    return 10 * power;
}

std::string label(double value) {
    return fmt::format("{:.6g}", std::abs(value) < 1e-12 ? 0 : value);
}

}  // namespace

ChartAxis::ChartAxis(const Chart& chart, double bottom, double top)
    : logarithmic_(chart.logarithmic),
      least_(std::numeric_limits<double>::infinity()),
      most_(-least_),
      bottom_(bottom),
      top_(top) {
    for (const ChartSeries& series : chart.series) {
        for (const auto& point : series.points) {
            if (!point) continue;
            for (const double value : {point->y, point->low, point->high}) {
                if (!shows(value)) continue;
                least_ = std::min(least_, value);
                most_ = std::max(most_, value);
            }
        }
    }
    if (least_ > most_) least_ = most_ = 1;  // nothing to show
    if (logarithmic_) {
        span_logarithmic();
    } else {
        span_linear(chart.from_zero);
    }
}

void ChartAxis::span_linear(bool from_zero) {
    if (from_zero) {
        least_ = std::min(least_, 0.0);
        most_ = std::max(most_, 0.0);
    }
    if (least_ == most_) most_ = least_ + std::max(1.0, std::abs(least_));
    const double step = nice_step(most_ - least_);
    least_ = std::floor(least_ / step + 1e-9) * step;
    most_ = std::ceil(most_ / step - 1e-9) * step;
    const int steps = int(std::lround((most_ - least_) / step));
    for (int i = 0; i <= steps; ++i) ticks_.push_back({least_ + i * step, label(least_ + i * step)});
}

void ChartAxis::span_logarithmic() {
    least_ = std::pow(10, std::floor(std::log10(least_)));
    most_ = std::pow(10, std::floor(std::log10(most_)) + 1);
    const long last = std::lround(std::log10(most_));
    for (long exponent = std::lround(std::log10(least_)); exponent <= last; ++exponent) {
        const double power = std::pow(10, double(exponent));
        ticks_.push_back({power, label(power)});
        for (const double factor : {2, 5}) {
            if (factor * power < most_) ticks_.push_back({factor * power, label(factor * power)});
        }
    }
}

bool ChartAxis::shows(double value) const {
    return std::isfinite(value) && (!logarithmic_ || value > 0);
}

double ChartAxis::at(double value) const {
    const double share =
        logarithmic_ ? std::log(value / least_) / std::log(most_ / least_) : (value - least_) / (most_ - least_);
    return bottom_ + share * (top_ - bottom_);
}

}  // namespace waybreaker::render
