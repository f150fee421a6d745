#include "clearing/clearing_drive.hpp"

#include <algorithm>
#include <utility>

#include "clearing/standing_place.hpp"
#include "model/rubble.hpp"

namespace waybreaker::clearing {
namespace {

Point middle_of(const Box& box) {
    return {(box.min.x + box.max.x) / 2.0, (box.min.y + box.max.y) / 2.0};
}

}  // namespace

Agent under_way(const Agent& vehicle, const ClearingDrive& clearing) {
    Agent agent = vehicle;
    agent.own_breaches = 0;
    if (clearing.breaches.empty()) return agent;
    agent.start = clearing.breaches.back().at;
    agent.ready_at = clearing.path.back().t;
    agent.approach = clearing.path;
    return agent;
}

const ClearingDrives::Leg& ClearingDrives::leg(const Agent& vehicle, Cell from, ObstacleId obstacle,
                                               std::optional<Point> next, std::vector<ObstacleId> open) {
    const Body& body = vehicle.body;
    Key key{body.radius, body.corners, vehicle.reach, from, obstacle, {}, open};
    if (next) std::get<5>(key) = {next->x, next->y};
    const auto [known, is_new] = legs_.try_emplace(std::move(key));
    if (!is_new) return known->second;
    const auto place = standing_place(OpenedMap(map_, open), vehicle, from, obstacle, next);
    if (!place) return known->second;
    Agent driver = vehicle;
    driver.start = from;
    driver.goal = *place;
    const Trip trip{map_, driver, search_options(method_, body), deadline_, UINT64_MAX, {}, rules_.rubble};
    known->second = {*place, waybreaker::open(trip, searchers_, std::move(open)).ground.path};
    return known->second;
}

std::optional<ClearingDrive> ClearingDrives::drive(const Agent& vehicle, const Tour& tour,
                                                   std::span<const TimedOpening> opened) {
    ClearingDrive clearing;
    if (tour.empty()) return clearing;
    const auto add = [&](Point at, double time) {
        const Waypoint point{at.x, at.y, time};
        if (clearing.path.empty() || clearing.path.back() != point) clearing.path.push_back(point);
    };
    clearing.path = vehicle.approach;
    if (vehicle.approach.empty()) add(vehicle.start, 0);
    add(vehicle.start, vehicle.ready_at);
    Cell at = vehicle.start;
    double time = vehicle.ready_at;
    for (auto one = tour.begin(); one != tour.end(); ++one) {
        std::vector<ObstacleId> open;
        for (auto before = tour.begin(); before != one; ++before) open.push_back(before->obstacle);
        for (const TimedOpening& opening : opened) {
            if (opening.at <= time) open.push_back(opening.obstacle);
        }
        std::ranges::sort(open);
        const std::vector<ObstacleId> passed = open;
        std::optional<Point> next;
        if (one->place == Place::onward) {
            const bool is_last = one + 1 == tour.end();
            next = is_last ? Point(vehicle.goal) : middle_of(map_.obstacle((one + 1)->obstacle).bounds);
        }
        const Leg& taken = leg(vehicle, at, one->obstacle, next, std::move(open));
        if (taken.path.empty()) return std::nullopt;
        const std::vector<double> stands = stands_on(map_, taken.path, vehicle.body, {passed, rules_.rubble});
        for (std::size_t i = 1; i < taken.path.size(); ++i) {
            time += stands[i - 1];
            add(taken.path[i - 1], time);
            time += distance(taken.path[i - 1], taken.path[i]) / vehicle.speed;
            add(taken.path[i], time);
        }
        at = taken.to;
        const double cleared = time + time_to_breach(vehicle, map_.obstacle(one->obstacle), rules_);
        clearing.breaches.push_back({one->obstacle, at, time, cleared});
        time = cleared;
        add(at, time);
        if (time > most_breach_time) return std::nullopt;
    }
    return clearing;
}

}  // namespace waybreaker::clearing
