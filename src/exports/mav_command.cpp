#include "exports/mav_command.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace waybreaker::exports {
namespace {

constexpr std::array<std::pair<std::string_view, MavCommand>, 7> actions{
    {{"DO_SET_RELAY", MavCommand::do_set_relay},
     {"DO_REPEAT_RELAY", MavCommand::do_repeat_relay},
     {"DO_SET_SERVO", MavCommand::do_set_servo},
     {"DO_REPEAT_SERVO", MavCommand::do_repeat_servo},
     {"DO_SET_ACTUATOR", MavCommand::do_set_actuator},
     {"DO_GRIPPER", MavCommand::do_gripper},
     {"NAV_PAYLOAD_PLACE", MavCommand::nav_payload_place}}};

constexpr int most_command = 65535;  // 16 bits in the protocol
constexpr std::size_t most_params = 7;

// The whole text as a number.
template <class Number>
std::optional<Number> number_of(std::string_view text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

std::optional<int> command_of(std::string_view name) {
    constexpr std::string_view prefix = "MAV_CMD_";
    if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
    const auto* const known = std::ranges::find(actions, name, &std::pair<std::string_view, MavCommand>::first);
    if (known != actions.end()) return int(known->second);
    const std::optional<int> number = number_of<int>(name);
    return number && *number >= 0 && *number <= most_command ? number : std::nullopt;
}

}  // namespace

std::vector<std::string> mav_action_names() {
    std::vector<std::string> names;
    for (const auto& action : actions) names.emplace_back(action.first);
    return names;
}

std::optional<MavAction> parse_mav_action(std::string_view text) {
    const std::size_t colon = text.find(':');
    const std::optional<int> command = command_of(text.substr(0, colon));
    if (!command) return std::nullopt;
    MavAction action{.command = *command, .params = {}};
    while (colon != std::string_view::npos) {
        if (action.params.empty()) text.remove_prefix(colon + 1);
        const std::size_t comma = text.find(',');
        const std::optional<double> param = number_of<double>(text.substr(0, comma));
        if (!param || !std::isfinite(*param) || action.params.size() == most_params) return std::nullopt;
        action.params.push_back(*param);
        if (comma == std::string_view::npos) break;
        text.remove_prefix(comma + 1);
    }
    return action;
}

}  // namespace waybreaker::exports
