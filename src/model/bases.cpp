#include "model/bases.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "model/timeline.hpp"

namespace waybreaker {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

std::vector<Cell> bases_of(const Agent& agent) {
    if (!agent.bases.empty()) return agent.bases;
    return {agent.start, agent.goal};
}

// Between two landings, in units of time, give or take rounding.
double most_flown(const Agent& agent) {
    return (1 - agent.reserve) * agent.battery() * (1 + 1e-9);
}

}  // namespace

Bases::Bases(const Agent& agent)
    : agent_(agent), recharge_(agent.recharge.value_or(0)), full_(most_flown(agent)), places_(bases_of(agent)) {
    std::ranges::sort(places_, {}, [](Cell c) { return std::pair(c.y, c.x); });
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    // All shortest chains (Floyd 1962).
    chains_.assign(count() * count(), never);
    next_.assign(count() * count(), 0);
    for (std::size_t a = 0; a < count(); ++a) {
        for (std::size_t b = 0; b < count(); ++b) {
            const double time = a == b ? 0 : flight(places_[a], places_[b]);
            if (!is_enough(time)) continue;
            chains_[a * count() + b] = a == b ? 0 : time + recharge_;
            next_[a * count() + b] = b;
        }
    }
    for (std::size_t by = 0; by < count(); ++by) {
        for (std::size_t a = 0; a < count(); ++a) {
            for (std::size_t b = 0; b < count(); ++b) {
                if (chain(a, by) + chain(by, b) >= chain(a, b)) continue;
                chains_[a * count() + b] = chain(a, by) + chain(by, b);
                next_[a * count() + b] = next_[a * count() + by];
            }
        }
    }
    for (std::size_t base = 0; base < count(); ++base) {
        bool there = false;
        bool home = false;
        for (std::size_t other = 0; other < count(); ++other) {
            there = there || (std::isfinite(chain(other, base)) &&
                              is_enough(agent.flown + flight(agent.begin(), places_[other])));
            home = home || (std::isfinite(chain(base, other)) && is_enough(flight(places_[other], agent.goal)));
        }
        gets_there_.push_back(char(there));
        gets_home_.push_back(char(home));
    }
}

void Bases::add_landings(std::size_t from, std::size_t to, std::vector<Cell>& landings) const {
    landings.push_back(places_[from]);
    for (std::size_t at = from; at != to;) {
        at = next_[at * count() + to];
        landings.push_back(places_[at]);
    }
}

std::vector<BaseWay> Bases::ways(Point from, double flown, Point to) const {
    std::vector<BaseWay> all;
    const double straight = flight(from, to);
    if (is_enough(flown + straight)) all.push_back({{}, straight, flown + straight});
    for (std::size_t last = 0; last < count(); ++last) {
        const double onward = flight(places_[last], to);
        if (!is_enough(onward)) continue;
        double least = never;
        std::size_t first = 0;
        for (std::size_t base = 0; base < count(); ++base) {
            const double there = flight(from, places_[base]);
            const double lasts = there + recharge_ + chain(base, last);
            if (!is_enough(flown + there) || lasts >= least) continue;
            least = lasts;
            first = base;
        }
        if (std::isinf(least)) continue;
        BaseWay way{{}, least + onward, onward};
        add_landings(first, last, way.landings);
        all.push_back(std::move(way));
    }
    std::ranges::stable_sort(all, {}, &BaseWay::lasts);
    double least = never;
    std::erase_if(all, [&](const BaseWay& way) {
        if (way.flown >= least) return true;
        least = way.flown;
        return false;
    });
    return all;
}

double Bases::least_sortie(Point past) const {
    double there = agent_.flown + flight(agent_.begin(), past);
    for (std::size_t base = 0; base < count(); ++base) {
        if (gets_there_[base] != 0) there = std::min(there, flight(places_[base], past));
    }
    return there + least_landing(past);
}

double Bases::least_landing(Point from) const {
    double least = flight(from, agent_.goal);
    for (std::size_t base = 0; base < count(); ++base) {
        if (gets_home_[base] != 0) least = std::min(least, flight(from, places_[base]));
    }
    return least;
}

BaseWay way_home(const Agent& agent) {
    const double straight = agent.airspace.length(agent.begin(), agent.goal) / agent.speed;
    BaseWay direct{{}, straight, agent.flown + straight};
    if (!agent.recharge) return direct;
    std::vector<BaseWay> ways = Bases(agent).ways(agent.begin(), agent.flown, agent.goal);
    return std::move(ways.empty() ? direct : ways.front());
}

std::vector<Point> route_home(const Agent& agent) {
    std::vector<Point> stops{agent.begin()};
    for (const Cell base : way_home(agent).landings) stops.emplace_back(base);
    stops.emplace_back(agent.goal);
    return agent.airspace.way_past(stops);
}

std::vector<Waypoint> flight_home(const Agent& agent) {
    std::vector<Waypoint> path{{agent.begin().x, agent.begin().y, 0}};
    double time = agent.ready_at;
    if (time > 0) path.push_back({agent.begin().x, agent.begin().y, time});
    const auto fly_to = [&](Cell to) {
        const std::vector<Point> way = agent.airspace.way({path.back().x, path.back().y}, to);
        const std::vector<Waypoint> leg = timed(way, agent.speed, time);
        path.insert(path.end(), leg.begin() + 1, leg.end());
        time = leg.back().t;
    };
    for (const Cell base : way_home(agent).landings) {
        fly_to(base);
        time += agent.recharge.value_or(0);
        path.push_back({double(base.x), double(base.y), time});
    }
    fly_to(agent.goal);
    return path;
}

std::vector<Recharge> recharges_on(const Agent& agent, std::span<const Waypoint> path,
                                   std::span<const Breach> breaches) {
    std::vector<Recharge> recharges;
    if (!agent.recharge) return recharges;
    const std::vector<Cell> bases = bases_of(agent);
    double off = agent.ready_at - agent.flown;  // when it took off
    bool grounded = agent.flown == 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Waypoint& from = path[i - 1];
        const Waypoint& until = path[i];
        const auto is_here = [&](Cell base) { return base.x == from.x && base.y == from.y; };
        const auto is_this = [&](const Breach& breach) {
            return (breach.by.empty() || breach.by == agent.id) && is_here(breach.at) && breach.cleared_at == until.t;
        };
        if (from.x != until.x || from.y != until.y || std::ranges::any_of(breaches, is_this)) {
            grounded = false;
            continue;
        }
        const double least = *agent.recharge - 1e-9 * (1 + until.t);
        const auto base = std::ranges::find_if(bases, is_here);
        const bool recharged = base != bases.end() && from.t >= agent.ready_at && until.t - from.t >= least;
        if (recharged) recharges.push_back({*base, from.t, until.t, from.t - off});
        grounded = grounded || recharged;
        if (grounded) off = until.t;  // it waits on the ground
    }
    return recharges;
}

bool keeps_battery(const Agent& agent, std::span<const Waypoint> path, std::span<const Recharge> recharges) {
    if (recharges.empty()) return agent.flown + (path.back().t - agent.ready_at) <= most_flown(agent);
    const auto is_enough = [&](const Recharge& recharge) { return recharge.flown <= most_flown(agent); };
    return std::ranges::all_of(recharges, is_enough) && path.back().t - recharges.back().until <= most_flown(agent);
}

double with_recharging(const Agent& agent, double flight) {
    if (!agent.recharge || std::isinf(flight)) return flight;
    const double sorties = (agent.flown + flight) / most_flown(agent);
    return flight + *agent.recharge * std::max(std::ceil(sorties - 1e-6) - 1, 0.0);
}

}  // namespace waybreaker
