#include "schedule/precedence.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "schedule/tour_times.hpp"

namespace waybreaker {
namespace {

double earliest(std::span<const Drive> drives, std::span<const double> cleared) {
    double first = std::numeric_limits<double>::infinity();
    for (const Drive& drive : drives) first = std::min(first, drive.end(cleared));
    return first;
}

}  // namespace

double Drive::end(std::span<const double> cleared) const {
    double delay = 0;
    for (const Passage& passage : passages) delay = std::max(delay, cleared[passage.target] - passage.due);
    return arrival + delay;
}

Precedence::Precedence(std::vector<const Agent*> aircraft, std::size_t targets, std::vector<std::vector<double>> stays)
    : aircraft_(std::move(aircraft)), stays_(std::move(stays)), unflown_(targets, never) {}

void Precedence::add_vehicle(std::vector<Drive> drives, double weight) {
    const bool may_wait = std::ranges::any_of(drives, [](const Drive& drive) { return !drive.passages.empty(); });
    if (may_wait) {
        vehicles_.push_back({std::move(drives), weight});
    } else {
        others_.add(AgentKind::ground, earliest(drives, {}), weight);
    }
}

Precedence::Flights Precedence::flights(std::span<const Tour> tours) const {
    Flights flights{unflown_, others_};
    const auto clear = [&](const Stop& stop, double, double cleared) { flights.cleared[stop.target] = cleared; };
    for (std::size_t a = 0; a < tours.size(); ++a) {
        const auto stay = [this, a](std::size_t target) { return stays_[a][target]; };
        flights.finish.add(*aircraft_[a], fly(*aircraft_[a], tours[a], stay, clear));
    }
    return flights;
}

Finish Precedence::finish(std::span<const Tour> tours) const {
    Flights known = flights(tours);
    for (const Driver& vehicle : vehicles_) {
        known.finish.add(AgentKind::ground, earliest(vehicle.drives, known.cleared), vehicle.weight);
    }
    return known.finish;
}

}  // namespace waybreaker
