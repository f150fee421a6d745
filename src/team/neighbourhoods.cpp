#include "team/neighbourhoods.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "team/tuning.hpp"

namespace waybreaker::team {
namespace {

constexpr double for_ever = std::numeric_limits<double>::infinity();

}  // namespace

// The vehicle, those in its way, those in their way, and so on; the last ones are drawn.
std::vector<std::uint32_t> NeighbourhoodSearch::around(std::uint32_t vehicle, std::size_t most) {
    std::vector<std::uint32_t> chosen{vehicle};
    for (std::size_t next = 0; next < chosen.size() && chosen.size() < most; ++next) {
        std::vector<std::uint32_t> met = fleet_.in_its_way(chosen[next]);
        random_.shuffle(met);
        for (const std::uint32_t other : met) {
            if (chosen.size() == most) break;
            if (std::ranges::find(chosen, other) == chosen.end()) chosen.push_back(other);
        }
    }
    return chosen;
}

// The time that a vehicle loses on the others.
double NeighbourhoodSearch::delay(std::uint32_t vehicle) const {
    constexpr double rounding = 1e-9;
    const double alone = fleet_.vehicle(vehicle).alone;
    const double lost = fleet_.arrival(vehicle) - alone;
    return lost > rounding * std::max(alone, 1.0) ? lost : 0;
}

// Draws a vehicle that loses time: the more it loses, the more likely.
std::optional<std::uint32_t> NeighbourhoodSearch::delayed() {
    double sum = 0;
    for (std::uint32_t i = 0; i < fleet_.size(); ++i) sum += delay(i);
    if (sum == 0) return std::nullopt;
    constexpr int parts = 1 << 30;
    double left = sum * random_.below(parts) / parts;
    std::optional<std::uint32_t> chosen;
    for (std::uint32_t i = 0; i < fleet_.size() && left >= 0; ++i) {
        if (delay(i) == 0) continue;
        chosen = i;
        left -= delay(i);
    }
    return chosen;
}

bool NeighbourhoodSearch::replan(const std::vector<std::uint32_t>& order, bool repairing) {
    const Cost before = fleet_.cost();
    std::vector<Path> old;
    for (const std::uint32_t i : order) {
        old.push_back(fleet_.path(i));
        fleet_.withdraw(i);
    }
    for (const std::uint32_t i : order) {
        if (fleet_.plan(i, repairing ? for_ever : fleet_.latest_arrival(before, i))) continue;
        if (!repairing) break;
        fleet_.hold_longer(i);
    }
    const Cost after = fleet_.cost();
    // Repair wanders: as many paths, other ones, may be what lets the last vehicle through.
    if (repairing ? after.missing <= before.missing : better(after, before)) return true;
    for (const std::uint32_t i : order) fleet_.withdraw(i);
    for (std::size_t k = 0; k < order.size(); ++k) {
        if (!old[k].empty()) fleet_.put(order[k], old[k]);
    }
    return false;
}

void NeighbourhoodSearch::repair() {
    const std::size_t most_tries = std::min(tuning::most_repairs, tuning::repairs_for_each * fleet_.size());
    for (std::size_t tries = 0; tries < most_tries && !interrupts_.due(); ++tries) {
        std::vector<std::uint32_t> missing;
        for (std::uint32_t i = 0; i < fleet_.size(); ++i) {
            if (!fleet_.has_path(i)) missing.push_back(i);
        }
        if (missing.empty()) return;
        replan(around(missing[std::size_t(random_.below(int(missing.size())))], tuning::most_repaired), true);
    }
}

// A vehicle that waited for another, which might have stood at its start for long but has left by now, need not wait
// any more.
bool NeighbourhoodSearch::shorten_waits() {
    bool any = false;
    for (std::uint32_t i = 0; i < fleet_.size() && !interrupts_.due(); ++i) {
        if (delay(i) > 0) any = replan({i}, false) || any;
    }
    return any;
}

void NeighbourhoodSearch::improve(double enough, const std::function<void()>& gained) {
    if (fleet_.cost().first <= enough) return;
    const std::size_t most_failures = tuning::most_failures + tuning::failures_for_each * fleet_.size();
    const bool held_longer = fleet_.hold_as_at_first();
    if (held_longer && shorten_waits()) gained();
    std::set<std::vector<std::uint32_t>> failed;  // orders, since paths have last changed
    for (std::size_t failures = 0; failures < most_failures && fleet_.cost().first > enough;) {
        const std::optional<std::uint32_t> late = delayed();
        if (!late || interrupts_.due()) return;
        const int more = random_.below(tuning::most_improved - tuning::fewest_improved + 1);
        std::vector<std::uint32_t> order = around(*late, std::size_t(tuning::fewest_improved + more));
        random_.shuffle(order);
        if (!failed.contains(order) && replan(order, false)) {
            failures = 0;
            failed.clear();
            gained();
        } else {
            ++failures;
            failed.insert(std::move(order));
        }
    }
}

}  // namespace waybreaker::team
