#include "coalition/restricted_master.hpp"

#include <algorithm>
#include <map>

namespace waybreaker::coalition {
namespace {

// Who cannot arrive at all costs that much: to let one more through is worth anything else.
constexpr double stranded = 1e12;

}  // namespace

RestrictedMaster::RestrictedMaster(const Problem& problem, const Columns& columns)
    : problem_(problem), columns_(columns) {
    std::map<ObstacleId, std::uint32_t> number_of;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const Pool& pool = columns.of(i);
        std::vector<std::uint32_t> numbers;
        for (const ObstacleId id : pool.obstacles) {
            const auto [known, is_new] = number_of.try_emplace(id, std::uint32_t(numbered_.size()));
            if (is_new) {
                numbered_.push_back(id);
                vehicles_of_.emplace_back();
            }
            numbers.push_back(known->second);
            vehicles_of_[known->second].push_back(std::uint32_t(i));
        }
        std::vector<std::vector<std::uint32_t>>& sets = sets_.emplace_back();
        for (const Column& column : pool.columns) {
            std::vector<std::uint32_t>& set = sets.emplace_back();
            for (const std::uint32_t at : column.opened) set.push_back(numbers[at]);
            std::ranges::sort(set);
            if (!set.empty()) offers_.push_back(set);
        }
    }
    for (std::uint32_t j = 0; j < numbered_.size(); ++j) offers_.push_back({j});
    std::ranges::sort(offers_);
    offers_.erase(std::unique(offers_.begin(), offers_.end()), offers_.end());
    open_.assign(numbered_.size(), 0);
    arrivals_.resize(columns.size());
    for (std::size_t i = 0; i < arrivals_.size(); ++i) arrivals_[i] = arrival(i);
}

double RestrictedMaster::arrival(std::size_t vehicle) const {
    double least = stranded;
    for (std::size_t c = 0; c < sets_[vehicle].size(); ++c) {
        const double arrival = columns_.of(vehicle).columns[c].arrival;
        if (arrival >= least) continue;
        if (std::ranges::all_of(sets_[vehicle][c], [this](std::uint32_t j) { return is_open(j); })) least = arrival;
    }
    return least;
}

double RestrictedMaster::objective() const {
    double sum = 0;
    double last = 0;
    for (std::size_t i = 0; i < arrivals_.size(); ++i) {
        sum += problem_.weight(i) * arrivals_[i];
        last = std::max(last, arrivals_[i]);
    }
    if (!problem_.sums()) return last + 1e-6 * sum;  // the others count where the last one has no gain
    double detour = 0;
    for (std::size_t j = 0; j < open_.size(); ++j) {
        if (!is_open(j)) continue;
        sum += problem_.weighted_breach_time(numbered_[j]);
        detour = std::max(detour, problem_.least_detour(numbered_[j]));
    }
    return sum + detour;
}

bool RestrictedMaster::fits(const std::vector<std::uint32_t>& more) const {
    std::size_t count = 0;
    double weight = 0;
    for (std::size_t j = 0; j < open_.size(); ++j) {
        if (!is_open(j) && !std::ranges::binary_search(more, std::uint32_t(j))) continue;
        ++count;
        weight += problem_.map().obstacle(numbered_[j]).weight;
    }
    return count <= std::size_t(problem_.spare_removals()) && weight <= problem_.spare_budget() * (1 + rounding);
}

// Opens what gains most for each obstacle. Whether anything gains.
bool RestrictedMaster::add_best() {
    const double now = objective();
    double best_gain = rounding * now;
    const std::vector<std::uint32_t>* best = nullptr;
    std::vector<std::uint32_t> touched;
    std::vector<double> before;
    for (const std::vector<std::uint32_t>& offer : offers_) {
        if (problem_.interrupts().due()) break;
        std::vector<std::uint32_t> opened;
        for (const std::uint32_t j : offer) {
            if (!is_open(j)) opened.push_back(j);
        }
        if (opened.empty() || !fits(opened)) continue;
        touched.clear();
        for (const std::uint32_t j : opened) {
            open_[j] = 1;
            touched.insert(touched.end(), vehicles_of_[j].begin(), vehicles_of_[j].end());
        }
        std::ranges::sort(touched);
        touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
        before.clear();
        for (const std::uint32_t i : touched) {
            before.push_back(arrivals_[i]);
            arrivals_[i] = arrival(i);
        }
        const double gain = (now - objective()) / double(opened.size());
        if (gain > best_gain * (1 + rounding)) {
            best_gain = gain;
            best = &offer;
        }
        for (std::size_t k = 0; k < touched.size(); ++k) arrivals_[touched[k]] = before[k];
        for (const std::uint32_t j : opened) open_[j] = 0;
    }
    if (best == nullptr) return false;
    for (const std::uint32_t j : *best) open_[j] = 1;
    for (std::size_t i = 0; i < arrivals_.size(); ++i) arrivals_[i] = arrival(i);
    return true;
}

void RestrictedMaster::set_open(const Set& set) {
    for (std::size_t j = 0; j < open_.size(); ++j) open_[j] = contains(set, numbered_[j]) ? 1 : 0;
    for (std::size_t i = 0; i < arrivals_.size(); ++i) arrivals_[i] = arrival(i);
}

Set RestrictedMaster::opened() const {
    Set set;
    for (std::size_t j = 0; j < open_.size(); ++j) {
        if (is_open(j)) set.push_back(numbered_[j]);
    }
    std::ranges::sort(set);
    return set;
}

Set RestrictedMaster::best_from(const Set& start) {
    const auto fill = [this] {
        while (!problem_.interrupts().due() && add_best()) {
        }
    };
    set_open(start);
    fill();
    Set best = opened();
    double least = objective();
    for (bool gained = true; gained && !problem_.interrupts().due();) {
        gained = false;
        for (const ObstacleId id : Set(best)) {
            Set others = best;
            std::erase(others, id);
            set_open(others);
            fill();
            if (!(objective() < least * (1 - rounding))) continue;
            least = objective();
            best = opened();
            gained = true;
            break;
        }
    }
    return best;
}

}  // namespace waybreaker::coalition
