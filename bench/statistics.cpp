#include "statistics.hpp"

#include <cmath>
#include <cstdio>
#include <numeric>

namespace waybreaker::bench {

double mean(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

double geometric_mean(std::span<const double> values) {
    double logarithms = 0;
    for (const double value : values) logarithms += std::log(value);
    return std::exp(logarithms / double(values.size()));
}

double mean_ratio(std::span<const double> theirs, std::span<const double> ours) {
    return geometric_mean(theirs) / geometric_mean(ours);
}

void print_header() {
    std::printf("%-36s %8s %8s %8s %8s\n", "ms", "mean", "geomean", "median", "max");
}

void print_milliseconds(const std::string& name, std::vector<double> seconds) {
    std::sort(seconds.begin(), seconds.end());
    std::printf("%-36s %8.3f %8.3f %8.3f %8.3f\n", name.c_str(), 1e3 * mean(seconds), 1e3 * geometric_mean(seconds),
                1e3 * seconds[seconds.size() / 2], 1e3 * seconds.back());
}

}  // namespace waybreaker::bench
