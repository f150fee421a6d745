#include "lockstep/lockstep.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lockstep/configurations.hpp"
#include "lockstep/delays.hpp"
#include "lockstep/improvement.hpp"

namespace waybreaker::lockstep {
namespace {

constexpr std::size_t most_sites = 1U << 16U;
constexpr std::size_t most_distances = 1U << 24U;  // of all vehicles
constexpr std::size_t most_occupied = 1U << 20U;   // words of what is taken when
constexpr std::size_t most_configurations = 2000;  // of an attempt; of long trips as many as these take twice over
constexpr std::uint64_t attempts = 20;

// The routes of configurations, without the time that each stands at its goal in the end.
std::vector<Route> routes_of(const std::vector<Configuration>& configurations) {
    std::vector<Route> routes(configurations.front().size());
    for (std::size_t i = 0; i < routes.size(); ++i) {
        for (const Configuration& at : configurations) routes[i].push_back(at[i]);
        leave_out_rest(routes[i]);
    }
    return routes;
}

}  // namespace

std::optional<std::vector<std::vector<Cell>>> move_in_lockstep(const OpenedMap& map, const Body& body, double apart,
                                                               std::span<const Trip> trips, Aim aim,
                                                               const std::function<bool()>& due) {
    const double at_turn = std::sqrt(0.5);  // so near come two of which one turns into where the other leaves
    if (apart > 1 || trips.empty()) return std::nullopt;
    const Meeting meeting{.at_turns = apart > at_turn};
    if (std::size_t(map.width() + 63) * std::size_t(map.height()) > most_sites) return std::nullopt;
    const Lattice lattice(map, body);
    if (trips.size() * lattice.size() > most_distances) return std::nullopt;
    std::vector<std::vector<std::uint32_t>> left;
    std::size_t most = most_configurations;
    Configuration starts;
    Configuration goals;
    for (const Trip& trip : trips) {
        starts.push_back(lattice.site(trip.start));
        goals.push_back(lattice.site(trip.goal));
        left.push_back(lattice.distances_to(goals.back()));
        const std::uint32_t steps = left.back()[starts.back()];
        if (steps == Lattice::unreachable) return std::nullopt;
        most = std::max(most, std::size_t{2} * steps);
    }
    std::optional<std::vector<Configuration>> configurations;
    for (std::uint64_t seed = 0; seed < attempts && !configurations && !due(); ++seed) {
        configurations = move_all(lattice, starts, goals, left, seed, most, due);
    }
    if (!configurations) return std::nullopt;
    std::vector<Route> routes = routes_of(*configurations);
    if (meeting.at_turns) routes = delayed_at_turns(*configurations);
    const std::size_t times = std::ranges::max_element(routes, {}, &Route::size)->size();
    if (times * lattice.words() > most_occupied) return std::nullopt;
    routes = improved(lattice, meeting, left, std::move(routes), aim, 100 + 20 * trips.size(), most_occupied, due);
    std::vector<std::vector<Cell>> found;
    for (const Route& route : routes) {
        for (found.emplace_back(); const Site site : route) found.back().push_back(lattice.cell(site));
    }
    return found;
}

}  // namespace waybreaker::lockstep
