#include "lockstep/improvement.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace waybreaker::lockstep {
namespace {

constexpr std::size_t most_replanned = 8;

struct Cost {
    std::size_t first;
    std::size_t second;
    auto operator<=>(const Cost&) const = default;
};

class Improvement {
  public:
    Improvement(const Lattice& lattice, Meeting meeting, std::span<const std::vector<std::uint32_t>> left,
                std::vector<Route> routes, Aim aim, std::size_t most_words)
        : lattice_(lattice),
          left_(left),
          occupancy_(lattice, meeting, most_words),
          routes_(std::move(routes)),
          aim_(aim) {
        for (const Route& route : routes_) occupancy_.add(route);
    }

    // Until so many tries in a row have gained nothing, or nobody is late.
    void run(std::size_t most_failures, const std::function<bool()>& due) {
        for (std::size_t failures = 0; failures < most_failures && !due();) {
            const std::optional<std::size_t> late = any_late();
            if (!late) return;
            failures =
                replan(around(*late, 2 + std::size_t(random_.below(int(most_replanned) - 1)))) ? 0 : failures + 1;
        }
    }

    std::vector<Route> take() { return std::move(routes_); }

  private:
    std::size_t delay(std::size_t i) const { return arrival(routes_[i]) - left_[i][routes_[i].front()]; }

    // The later it is, the more likely; where the last arrival counts, often that one.
    std::optional<std::size_t> any_late() {
        std::size_t sum = 0;
        std::size_t last = 0;
        for (std::size_t i = 0; i < routes_.size(); ++i) {
            sum += delay(i);
            if (arrival(routes_[i]) > arrival(routes_[last])) last = i;
        }
        if (sum == 0) return std::nullopt;
        if (aim_ == Aim::last && random_.chance(0.5)) return last;
        auto drawn = std::size_t(random_.below(int(std::min<std::size_t>(sum, INT32_MAX))));
        std::size_t i = 0;
        for (; drawn >= delay(i); ++i) drawn -= delay(i);
        return i;
    }

    Cost cost() const {
        std::size_t sum = 0;
        std::size_t last = 0;
        for (const Route& route : routes_) {
            sum += arrival(route);
            last = std::max(last, arrival(route));
        }
        return aim_ == Aim::last ? Cost{last, sum} : Cost{sum, last};
    }

    // The vehicle and those it would meet if it went straight to its goal from some time on; the same for those.
    std::vector<std::size_t> around(std::size_t vehicle, std::size_t most) {
        most = std::min(most, routes_.size());
        std::vector<std::size_t> chosen{vehicle};
        for (std::size_t next = 0; next < chosen.size() && chosen.size() < most; ++next)
            add_met(chosen[next], most, chosen);
        while (chosen.size() < most) {
            const auto any = std::size_t(random_.below(int(routes_.size())));
            if (std::ranges::find(chosen, any) == chosen.end()) chosen.push_back(any);
        }
        random_.shuffle(chosen);
        return chosen;
    }

    void add_met(std::size_t vehicle, std::size_t most, std::vector<std::size_t>& chosen) {
        const Route& route = routes_[vehicle];
        auto t = std::size_t(random_.below(int(route.size())));
        Site here = route[t];
        for (; left_[vehicle][here] > 0; ++t) {
            const Site to = nearer(vehicle, here);
            for (std::size_t other = 0; other < routes_.size(); ++other) {
                const bool passed = at(other, t + 1) == to || (at(other, t) == to && at(other, t + 1) == here);
                if (!passed || std::ranges::find(chosen, other) != chosen.end()) continue;
                chosen.push_back(other);
                if (chosen.size() == most) return;
            }
            here = to;
        }
    }

    Site at(std::size_t i, std::size_t t) const { return routes_[i][std::min(t, arrival(routes_[i]))]; }

    Site nearer(std::size_t i, Site from) {
        for (auto d = Direction(random_.below(int(directions)));; d = (d + 1) % directions) {
            if (lattice_.open(from, d) && left_[i][lattice_.next(from, d)] < left_[i][from])
                return lattice_.next(from, d);
        }
    }

    // One after the other past all the rest; keeps what is no worse.
    bool replan(const std::vector<std::size_t>& order) {
        const Cost before = cost();
        std::vector<Route> old;
        for (const std::size_t i : order) {
            occupancy_.remove(routes_[i]);
            old.push_back(std::move(routes_[i]));
            routes_[i] = {old.back().front()};
        }
        std::size_t done = 0;
        for (; done < order.size(); ++done) {
            const std::size_t i = order[done];
            auto found =
                occupancy_.find(old[done].front(), old[done].back(), latest(before, order, old, done), random_);
            if (!found) break;
            routes_[i] = std::move(*found);
            occupancy_.add(routes_[i]);
        }
        if (done == order.size() && cost() <= before) return cost() < before;
        for (std::size_t k = 0; k < done; ++k) occupancy_.remove(routes_[order[k]]);
        for (std::size_t k = 0; k < order.size(); ++k) {
            routes_[order[k]] = std::move(old[k]);
            occupancy_.add(routes_[order[k]]);
        }
        return false;
    }

    // When a vehicle may arrive at the latest, if those after it lose nothing and all together not more than before.
    std::size_t latest(const Cost& before, const std::vector<std::size_t>& order, const std::vector<Route>& old,
                       std::size_t done) const {
        if (aim_ == Aim::last) return before.first;
        std::size_t spent = 0;
        for (const Route& route : routes_) spent += arrival(route);
        for (std::size_t k = done + 1; k < order.size(); ++k) spent += left_[order[k]][old[k].front()];
        return before.first - spent;
    }

    const Lattice& lattice_;
    std::span<const std::vector<std::uint32_t>> left_;
    Occupancy occupancy_;
    std::vector<Route> routes_;
    Aim aim_;
    Random random_{0};
};

}  // namespace

std::vector<Route> improved(const Lattice& lattice, Meeting meeting, std::span<const std::vector<std::uint32_t>> left,
                            std::vector<Route> routes, Aim aim, std::size_t most_failures, std::size_t most_words,
                            const std::function<bool()>& due) {
    Improvement improvement(lattice, meeting, left, std::move(routes), aim, most_words);
    improvement.run(most_failures, due);
    return improvement.take();
}

}  // namespace waybreaker::lockstep
