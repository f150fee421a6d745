// A command of the MAVLink protocol with its parameters, as people write it: "DO_SET_RELAY:0,1" or "181:0,1".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace waybreaker::exports {

enum class MavCommand : int {
    nav_waypoint = 16,
    nav_loiter_time = 19,
    nav_land = 21,
    nav_takeoff = 22,
    nav_payload_place = 94,
    nav_last = 95,  // the numbers up to here fly to a place; those above act where the aircraft is
    do_change_speed = 178,
    do_set_relay = 181,
    do_repeat_relay = 182,
    do_set_servo = 183,
    do_repeat_servo = 184,
    do_set_actuator = 187,
    do_gripper = 211,
};

struct MavAction {
    int command = int(MavCommand::do_set_relay);
    std::vector<double> params{0, 1};  // up to seven; the rest is 0, or the place where the command flies
};

// Names that can stand for a number.
std::vector<std::string> mav_action_names();

// Empty if it is none.
std::optional<MavAction> parse_mav_action(std::string_view text);

}  // namespace waybreaker::exports
