#include "mission/reach.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <span>

#include "model/in_zones.hpp"
#include "model/rubble.hpp"
#include "model/timeline.hpp"
#include "waybreaker/advanced/search.hpp"

namespace waybreaker {
namespace {

constexpr std::size_t most_cells = std::size_t{1} << 24;
constexpr std::size_t most_hubs = 16;
constexpr std::size_t most_openings_in_all_sets = 4;
constexpr std::size_t most_sets = 16;

using Openings = std::vector<TimedOpening>;

// Hears the search from one hub, nearest cells first, with all of these openings made sooner or later.
class Arrivals : public SearchListener {
  public:
    Arrivals(const Map& map, const Agent& driver, bool inbound, const Openings& openings, double rubble,
             std::vector<float>& times)
        : map_(map),
          driver_(driver),
          inbound_(inbound),
          openings_(openings),
          rubble_(rubble),
          times_(times),
          held_(times.size()),
          stood_(times.size()) {}

    void generated(Cell, Cell, double, double) override {}
    void updated(Cell, Cell, double, double) override {}
    void expanded(Cell cell, Cell parent, double g, double /*f*/) override {
        double& held = held_[index(cell)];
        double& stood = stood_[index(cell)];
        held = cell == parent ? 0 : held_[index(parent)];
        stood = cell == parent ? 0 : stood_[index(parent)];
        for (const TimedOpening& opening : openings_) stood += stands_for(opening, cell, parent);
        for (const TimedOpening& opening : openings_) held = std::max(held, held_by(opening, cell, parent, g));
        const double driven = driver_.ready_at + g / driver_.speed + stood;
        float& time = times_[index(cell)];
        time = std::min(time, float(inbound_ ? std::max(driven, held) : driven + held));
    }

  private:
    std::size_t index(Cell c) const { return std::size_t(c.y) * std::size_t(map_.width()) + std::size_t(c.x); }

    // Between the cell and its parent, in the direction that is driven.
    std::array<Waypoint, 2> move_between(Cell cell, Cell parent) const {
        const Cell from = inbound_ ? cell : parent;
        const Cell to = inbound_ ? parent : cell;
        return {{{double(from.x), double(from.y), 0}, {double(to.x), double(to.y), distance(cell, parent)}}};
    }

    // How long the rubble of an obstacle takes that is entered there.
    double stands_for(const TimedOpening& opening, Cell cell, Cell parent) const {
        if (rubble_ == 0) return 0;
        const std::array<Waypoint, 2> move = move_between(cell, parent);
        const bool enters = first_touch(map_, opening.obstacle, move, standing_radius(driver_.body)) &&
                            !stands_in(map_, opening.obstacle, Point(move[0].x, move[0].y), driver_.body);
        return enters ? rubble_ : 0;
    }

    // What an obstacle between the cell and its parent means: outbound, how long one waits for it; inbound, when one is
    // at the hub at the earliest, having waited.
    double held_by(const TimedOpening& opening, Cell cell, Cell parent, double g) const {
        const std::array<Waypoint, 2> move = move_between(cell, parent);
        const auto touched = first_touch(map_, opening.obstacle, move, standing_radius(driver_.body));
        if (!touched) return 0;
        const double stood = stood_[index(parent)];
        if (inbound_) return opening.at + rubble_ + (g - *touched) / driver_.speed + stood;
        return opening.at - (driver_.ready_at + (g - move[1].t + *touched) / driver_.speed + stood);
    }

    const Map& map_;
    const Agent& driver_;
    bool inbound_;
    const Openings& openings_;
    double rubble_;
    std::vector<float>& times_;
    std::vector<double> held_;   // by waits for openings
    std::vector<double> stood_;  // for rubble
};

// Those that are worth looking at, of openings in the order of their times.
std::vector<Openings> sets_of(const Openings& all) {
    std::vector<Openings> sets;
    if (all.size() <= most_openings_in_all_sets) {
        for (std::size_t bits = 0; bits < std::size_t{1} << all.size(); ++bits) {
            Openings& set = sets.emplace_back();
            for (std::size_t i = 0; i < all.size(); ++i) {
                if ((bits >> i & 1U) != 0) set.push_back(all[i]);
            }
        }
        return sets;
    }
    const std::size_t step = (all.size() + most_sets - 1) / most_sets;
    for (std::size_t count = 0; count < all.size(); count += step)
        sets.emplace_back(all.begin(), all.begin() + std::ptrdiff_t(count));
    sets.push_back(all);
    return sets;
}

std::vector<float> times(const Map& map, const Agent& driver, const Reach& reach, Openings openings,
                         const Rules& rules) {
    std::vector<float> times(std::size_t(map.width()) * std::size_t(map.height()),
                             std::numeric_limits<float>::infinity());
    std::ranges::stable_sort(openings, {}, &TimedOpening::at);
    const auto later = std::ranges::find_if(openings, [&](const TimedOpening& opening) {
        return rules.rubble > 0 || (rules.timing == Timing::enforce && opening.at > 0);
    });
    std::vector<ObstacleId> open;
    for (auto one = openings.begin(); one != later; ++one) open.push_back(one->obstacle);
    Searcher searcher;
    for (const Openings& set : sets_of({later, openings.end()})) {
        std::vector<ObstacleId> gone = open;
        for (const TimedOpening& opening : set) gone.push_back(opening.obstacle);
        const OpenedMap opened(map, gone);
        for (const Cell hub : reach.hubs) {
            Arrivals arrivals(map, driver, reach.inbound, set, rules.rubble, times);
            searcher.explore(opened, hub, {.body = driver.body, .listener = &arrivals});
        }
    }
    return times;
}

bool drive_alike(const Agent& a, const Agent& b) {
    return a.body == b.body && a.speed == b.speed && a.ready_at == b.ready_at && a.approach.empty();
}

}  // namespace

std::optional<Reach> reach_of(const Map& given, const Mission& asked, const Plan& plan) {
    if (plan.status != PlanStatus::solved || asked.rules.collisions) return std::nullopt;
    if (std::size_t(given.width()) * std::size_t(given.height()) > most_cells) return std::nullopt;
    const Agent& driver = asked.first(AgentKind::ground);
    std::set<Cell> starts;
    std::set<Cell> goals;
    for (const Agent& agent : asked.agents) {
        if (agent.kind == AgentKind::air) continue;
        if (!drive_alike(agent, driver)) return std::nullopt;
        starts.insert(agent.start);
        goals.insert(agent.goal);
    }
    Reach reach;
    reach.inbound = goals.size() < starts.size();
    const std::set<Cell>& hubs = reach.inbound ? goals : starts;
    if (starts.size() == goals.size() || hubs.size() > most_hubs) return std::nullopt;
    reach.hubs.assign(hubs.begin(), hubs.end());
    const InZones zoned(given, asked);
    const Rules& rules = asked.rules;
    Openings openings = rules.opened;
    reach.before = times(zoned.map(), driver, reach, openings, rules);
    for (const Breach& breach : plan.breaches) openings.push_back({breach.obstacle, breach.cleared_at});
    reach.after = times(zoned.map(), driver, reach, std::move(openings), rules);
    return reach;
}

}  // namespace waybreaker
