#include "lockstep/delays.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace waybreaker::lockstep {
namespace {

class Delays {
  public:
    explicit Delays(const std::vector<Configuration>& configurations)
        : visits_(configurations.front().size()), done_(visits_.size(), 0), state_(visits_.size()) {
        std::unordered_map<Site, std::size_t> count;  // of visits
        for (std::size_t i = 0; i < visits_.size(); ++i) {
            visits_[i].push_back({configurations.front()[i], count[configurations.front()[i]]++});
            routes_.push_back({visits_[i].back().site});
        }
        for (std::size_t t = 1; t < configurations.size(); ++t) {
            for (std::size_t i = 0; i < visits_.size(); ++i) {
                const Site site = configurations[t][i];
                if (site != visits_[i].back().site) visits_[i].push_back({site, count[site]++});
            }
        }
        for (std::size_t i = 0; i < visits_.size(); ++i) visitor_[visits_[i].front().site] = i;
    }

    std::vector<Route> run() {
        for (bool any = true; any;) {
            std::ranges::fill(state_, State::unknown);
            any = false;
            for (std::size_t i = 0; i < visits_.size(); ++i) any = moves(i) || any;
            for (std::size_t i = 0; any && i < visits_.size(); ++i) {
                if (state_[i] == State::moves) leave(i);
            }
            for (std::size_t i = 0; any && i < visits_.size(); ++i) {
                if (state_[i] == State::moves) visitor_[visits_[i][++done_[i]].site] = i;
                routes_[i].push_back(visits_[i][done_[i]].site);
            }
        }
        for (Route& route : routes_) leave_out_rest(route);
        return std::move(routes_);
    }

  private:
    enum class State { unknown, moves, stands };
    struct Visit {
        Site site;
        std::size_t before;  // visits of others, all over when this one begins
    };

    // Whether it goes on in this step: nobody is to come before it, and who is there leaves straight ahead.
    bool moves(std::size_t i) {
        if (state_[i] != State::unknown) return state_[i] == State::moves;
        state_[i] = State::stands;
        if (done_[i] + 1 == visits_[i].size()) return false;
        const Site here = visits_[i][done_[i]].site;
        const Visit& next = visits_[i][done_[i] + 1];
        const auto there = visitor_.find(next.site);
        const std::size_t left = over_[next.site] + (there != visitor_.end() ? 1 : 0);
        if (left != next.before) return false;
        if (there != visitor_.end()) {
            const std::size_t other = there->second;
            if (!moves(other) || visits_[other][done_[other] + 1].site - next.site != next.site - here) return false;
        }
        state_[i] = State::moves;
        return true;
    }

    void leave(std::size_t i) {
        const Site here = visits_[i][done_[i]].site;
        ++over_[here];
        visitor_.erase(here);
    }

    std::vector<std::vector<Visit>> visits_;         // by vehicle
    std::vector<std::size_t> done_;                  // the visit it is at
    std::vector<State> state_;                       // in this step
    std::unordered_map<Site, std::size_t> visitor_;  // who is there
    std::unordered_map<Site, std::size_t> over_;     // visits that are
    std::vector<Route> routes_;
};

}  // namespace

std::vector<Route> delayed_at_turns(const std::vector<Configuration>& configurations) {
    return Delays(configurations).run();
}

void leave_out_rest(Route& route) {
    while (route.size() > 1 && route[route.size() - 2] == route.back()) route.pop_back();
}

}  // namespace waybreaker::lockstep
