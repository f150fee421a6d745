// Timing and summing up for the benchmarks that print tables of their own.
#pragma once

#include <algorithm>
#include <chrono>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace waybreaker::bench {

template <class Work>
double seconds_of(Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// The shortest of several runs: the one the rest of the machine disturbed least.
template <class Work>
double least_seconds(int repeats, Work work) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < repeats; ++i) least = std::min(least, seconds_of(work));
    return least;
}

double mean(std::span<const double> values);
double geometric_mean(std::span<const double> values);

// The geometric mean of theirs[i] / ours[i].
double mean_ratio(std::span<const double> theirs, std::span<const double> ours);

void print_header();
void print_milliseconds(const std::string& name, std::vector<double> seconds);

}  // namespace waybreaker::bench
