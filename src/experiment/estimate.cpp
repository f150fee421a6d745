#include "experiment/estimate.hpp"

#include <array>
#include <cmath>

namespace waybreaker::experiment {

void Estimator::add(std::size_t place, double value) {
    places_[place].sum += value;
    ++places_[place].count;
}

Estimate Estimator::estimate() const {
    Estimate result;
    double sum = 0;
    std::size_t clusters = 0;
    for (const OfPlace& place : places_) {
        sum += place.sum;
        result.count += place.count;
        clusters += place.count > 0 ? 1 : 0;
    }
    if (result.count == 0) return result;
    const double n = double(result.count);
    result.mean = result.low = result.high = sum / n;
    if (clusters < 2) return result;
    double squares = 0;
    for (const OfPlace& place : places_) {
        const double residual = place.sum - double(place.count) * result.mean;
        squares += residual * residual;
    }
    const double g = double(clusters);
    const double half = student_95(clusters - 1) * std::sqrt(g / (g - 1) * squares) / n;
    result.low -= half;
    result.high += half;
    return result;
}

double student_95(std::size_t degrees) {
    // From tables; beyond them the expansion in 1 / degrees (Abramowitz and Stegun 26.7.5) is exact to three decimals.
    constexpr std::array table{12.7062, 4.3027, 3.1824, 2.7764, 2.5706, 2.4469, 2.3646, 2.3060, 2.2622, 2.2281};
    if (degrees <= table.size()) return table[degrees - 1];
    const double z = 1.959964;
    const double v = double(degrees);
    const double z3 = std::pow(z, 3);
    const double z5 = std::pow(z, 5);
    const double z7 = std::pow(z, 7);
    return z + (z3 + z) / (4 * v) + (5 * z5 + 16 * z3 + 3 * z) / (96 * v * v) +
           (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * v * v * v);
}

}  // namespace waybreaker::experiment
