#include "draw_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "measure.hpp"
#include "option.hpp"

namespace waybreaker::apps {
namespace {

// "exponential:2s"
Delay delay_from(const std::string& given) {
    const std::size_t colon = std::min(given.find(':'), given.size());
    std::string_view mean = std::string_view(given).substr(std::min(colon + 1, given.size()));
    double size = 1;
    for (const auto& [unit, seconds] : time_units) {
        if (!mean.ends_with(unit)) continue;
        mean.remove_suffix(unit.size());
        size = seconds;
        break;
    }
    const std::optional<double> number = number_from(mean);
    for (std::size_t i = 0; i < waybreaker::words_of<DelayKind>.size(); ++i) {
        if (waybreaker::words_of<DelayKind>[i] != given.substr(0, colon) || !number) continue;
        if (*number * size >= 0 && *number * size <= most_delay) return {DelayKind(i), *number * size};
    }
    throw CLI::ValidationError(
        "--delay", fmt::format("'{}' is not fixed, exponential or poisson with a mean from 0 to {} behind it, such as "
                               "poisson:2s",
                               shown(given), most_delay));
}

constexpr const char* delay_text =
    "How late each agent leaves for the next point of its path, each time that it moves on. fixed: always so much; "
    "exponential: an exponentially distributed time of that mean; poisson: a whole number of units of time, Poisson "
    "distributed with that mean. A second is one unit of the plan's time (default: none)";

std::string share_text(double share) {
    return share > 0 ? fmt::format("{:g}%", 100 * share) : "0";
}

}  // namespace

std::vector<CLI::Option*> add_draws(CLI::App& command, RehearsalOptions& options) {
    CLI::Option* fail = add_share(
        command, "--fail", options.fail,
        fmt::format("The chance that a breach leaves the obstacle standing, which is known when it ends. It is tried "
                    "again as often as the mission allows (default: {})",
                    share_text(options.fail)));
    CLI::Option* delay = command.add_option_function<std::string>(
        "--delay", [&options](const std::string& given) { options.delay = delay_from(given); }, delay_text);
    delay->type_name("KIND:MEAN");
    CLI::Option* blocked = add_share(
        command, "--blocked", options.blocked,
        "The chance that a vehicle meets a blocked street, once: when it has driven some share of the length of "
        "its first path, all shares equally likely, the place --sight ahead on its path turns out to be blocked, "
        "three cells wide. Not where its path ends before, nor on a vehicle or a goal (default: 0)");
    CLI::Option* sight = add_number(
        command, "--sight", [&options](double cells) { options.sight = cells; }, {least_sight, 1000}, "CELLS",
        "How far ahead a vehicle sees a blocked street (default: 10)");
    CLI::Option* lost = add_share(
        command, "--lost", options.lost,
        "The chance that an aircraft is lost: when it has flown some share of the length of its first flight, "
        "likewise (default: 0)");
    CLI::Option* runs = add_count(
        command, "--runs", [&options](auto n) { options.runs = int(n); }, 1, most_runs,
        fmt::format("How many missions are played (default: {})", options.runs));
    CLI::Option* seed = add_count(
        command, "--seed", [&options](auto n) { options.seed = std::uint64_t(n); }, 0, INT64_MAX,
        "What is drawn; run i is the same, however many there are (default: 1)");
    return {fail, delay, blocked, sight, lost, runs, seed};
}

Method method_of_revisions(Method method) {
    if (method.select != Selection::exact) method = Method{};
    method.bound = false;
    method.explain = false;
    return method;
}

}  // namespace waybreaker::apps
