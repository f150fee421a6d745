#include "rehearse/draws.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"

namespace waybreaker::rehearsal {
namespace {

std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
    return Random(a ^ Random(b).next()).next();
}

double unit(Random& random) {
    return double(random.next() >> 11) * 0x1p-53;
}

// Knuth's product of uniform numbers, in parts whose exponential is no tiny number: sums of Poisson numbers are such.
double poisson(Random& random, double mean) {
    constexpr double most_at_once = 16;
    double count = 0;
    double left = mean;
    while (left > 0) {
        const double end = std::exp(-std::min(left, most_at_once));
        double product = unit(random);
        while (product > end) {
            ++count;
            product *= unit(random);
        }
        left -= most_at_once;
    }
    return count;
}

}  // namespace

Draws::Draws(std::uint64_t seed, std::uint64_t run) : run_(mixed(seed, run)) {}

double Draws::share(Chance what, std::uint64_t whom, std::uint64_t count) const {
    Random random(mixed(mixed(mixed(run_, std::uint64_t(what)), whom), count));
    return unit(random);
}

double Draws::delay(const Delay& delay, std::uint64_t agent, std::uint64_t move) const {
    if (delay.mean == 0 || delay.kind == DelayKind::fixed) return delay.mean;
    Random random(mixed(mixed(mixed(run_, std::uint64_t(Chance::delay)), agent), move));
    if (delay.kind == DelayKind::poisson) return poisson(random, delay.mean);
    return -delay.mean * std::log1p(-unit(random));
}

}  // namespace waybreaker::rehearsal
