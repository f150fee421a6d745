// Barriers that are points: who passes, and whom they bar the way that they stand in.
#include <algorithm>
#include <array>

#include "city/rule_tables.hpp"
#include "city/vehicle_rules.hpp"

namespace waybreaker::city {
namespace {

enum class Passage { opens, bars };
constexpr Passage opens = Passage::opens;
constexpr Passage bars = Passage::bars;

// A rover is 0.8 m wide and has small wheels, a truck is wide, and a walker steps over what is low.
struct PointBarrier {
    std::string_view barrier;
    Passage rover, truck, walker;
};

constexpr std::array point_barriers{
    // [Key:barrier]: what opens, or leaves the whole way free.
    PointBarrier{"gate", opens, opens, opens},            // [Tag:barrier=gate]
    PointBarrier{"lift_gate", opens, opens, opens},       // [Tag:barrier=lift_gate]
    PointBarrier{"swing_gate", opens, opens, opens},      // [Tag:barrier=swing_gate]
    PointBarrier{"sliding_gate", opens, opens, opens},    // [Tag:barrier=sliding_gate]
    PointBarrier{"hampshire_gate", opens, opens, opens},  // [Tag:barrier=hampshire_gate]
    PointBarrier{"bump_gate", opens, opens, opens},       // [Tag:barrier=bump_gate]
    PointBarrier{"sliding_beam", opens, opens, opens},    // [Tag:barrier=sliding_beam]
    PointBarrier{"entrance", opens, opens, opens},        // [Tag:barrier=entrance]
    PointBarrier{"coupure", opens, opens, opens},         // [Tag:barrier=coupure]: a gap in a flood wall
    PointBarrier{"toll_booth", opens, opens, opens},      // [Tag:barrier=toll_booth]
    PointBarrier{"border_control", opens, opens, opens},  // [Tag:barrier=border_control]
    PointBarrier{"sally_port", opens, opens, opens},      // [Tag:barrier=sally_port]
    PointBarrier{"sump_buster", opens, opens, opens},     // [Tag:barrier=sump_buster]: for low cars
    // For people on foot.
    PointBarrier{"wicket_gate", opens, bars, opens},           // [Tag:barrier=wicket_gate]: 1 m wide
    PointBarrier{"kissing_gate", bars, bars, opens},           // [Tag:barrier=kissing_gate]: no room for wheels
    PointBarrier{"stile", bars, bars, opens},                  // [Tag:barrier=stile]: steps
    PointBarrier{"horse_stile", bars, bars, opens},            // [Tag:barrier=horse_stile]: a beam to step over
    PointBarrier{"turnstile", bars, bars, opens},              // [Tag:barrier=turnstile]
    PointBarrier{"full-height_turnstile", bars, bars, opens},  // [Tag:barrier=full-height_turnstile]
    PointBarrier{"step", bars, bars, opens},                   // [Tag:barrier=step]
    // For who is narrow.
    PointBarrier{"bollard", opens, bars, opens},            // [Tag:barrier=bollard]
    PointBarrier{"block", opens, bars, opens},              // [Tag:barrier=block]: a vehicle does not fit past it
    PointBarrier{"planter", opens, bars, opens},            // [Tag:barrier=planter]
    PointBarrier{"jersey_barrier", opens, bars, opens},     // [Tag:barrier=jersey_barrier]: likewise
    PointBarrier{"tank_trap", opens, bars, opens},          // [Tag:barrier=tank_trap]
    PointBarrier{"cycle_barrier", opens, bars, opens},      // [Tag:barrier=cycle_barrier]: slows bicycles
    PointBarrier{"motorcycle_barrier", bars, bars, opens},  // [Tag:barrier=motorcycle_barrier]: lets no handlebar by
    // By the ground: bars with gaps for hooves, a pit between the wheels of a bus.
    PointBarrier{"cattle_grid", opens, opens, bars},  // [Tag:barrier=cattle_grid]
    PointBarrier{"bus_trap", bars, opens, opens},     // [Tag:barrier=bus_trap]
    // By height: a truck is 4 m high; see maxheight.
    PointBarrier{"height_restrictor", opens, bars, opens},  // [Tag:barrier=height_restrictor]
    // Across the way; legs step over.
    PointBarrier{"log", bars, bars, opens},     // [Tag:barrier=log]
    PointBarrier{"debris", bars, bars, opens},  // [Tag:barrier=debris]
    PointBarrier{"chain", bars, bars, opens},   // [Tag:barrier=chain]
    PointBarrier{"rope", bars, bars, opens},    // [Tag:barrier=rope]
};

Passage usual_passage(const PointBarrier& point, Profile profile) {
    return profile == Profile::truck ? point.truck : profile == Profile::walker ? point.walker : point.rover;
}

// What the tags say of one before what its kind says: locks, keys of vehicles, and limits.
Passage passage(const TagSet& tags, const PointBarrier& point, Profile profile) {
    if (tags.is("locked", "yes") || !may_enter(tags, profile) || !is_within_limits(tags, profile)) return bars;
    const bool high_enough = point.barrier == "height_restrictor" && tags.find("maxheight") != nullptr;
    return is_invited(tags, profile) || high_enough ? opens : usual_passage(point, profile);
}

}  // namespace

void add_point(const TagSet& tags, Profile profile, std::vector<GroundUse>& uses) {
    const std::string* const barrier = tags.find("barrier");
    const auto* const point = std::find_if(point_barriers.begin(), point_barriers.end(), [&](const PointBarrier& one) {
        return barrier != nullptr && one.barrier == *barrier;
    });
    if (point == point_barriers.end()) return;
    if (passage(tags, *point, profile) == opens) {
        uses.push_back({.layer = GroundLayer::gate, .width = vehicle(profile).width});
        return;
    }
    uses.push_back({GroundLayer::barrier, site::ObstacleKind::barrier});
    uses.push_back({.layer = GroundLayer::shut});
}

}  // namespace waybreaker::city
