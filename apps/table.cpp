#include "table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace waybreaker::apps {
namespace {

bool begins_character(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
}

// In characters, which can be several bytes.
std::size_t width(const std::string& text) {
    return std::size_t(std::ranges::count_if(text, begins_character));
}

bool unit_speeds(const Mission& mission) {
    return std::ranges::all_of(
        mission.agents, [](double speed) { return speed == 1; }, &Agent::speed);
}

}  // namespace

std::string aligned(const std::vector<Row>& rows, bool bold, bool names) {
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
    }
    if (names) widths.back() = 0;
    std::string table;
    for (const Row& row : rows) {
        std::string line = row[0] + std::string(widths[0] - width(row[0]), ' ');
        for (std::size_t i = 1; i < row.size(); ++i) {
            const std::size_t blanks = widths[i] - std::min(width(row[i]), widths[i]);
            line += "  " + std::string(blanks, ' ') + row[i];
        }
        line.erase(line.find_last_not_of(' ') + 1);
        table += bold && &row == &rows.front() ? fmt::format("\033[1m{}\033[0m\n", line) : line + "\n";
    }
    return table;
}

std::string shortened(std::string_view name) {
    constexpr std::size_t most = 40;  // characters
    std::size_t characters = 0;
    std::string result;
    for (const char c : name) {
        if (begins_character(c) && ++characters > most) return result + "\u2026";
        const auto byte = static_cast<unsigned char>(c);
        result += byte < ' ' || byte == 0x7F ? '?' : c;
    }
    return result;
}

std::string text(std::optional<double> value, int digits) {
    if (!value) return nothing;
    std::string figure = fmt::format("{:.{}f}", *value, digits);
    const bool is_zero = figure.find_first_of("123456789ni") == std::string::npos;  // or inf, nan
    return is_zero && figure.front() == '-' ? figure.substr(1) : figure;
}

std::string text(Cell c) {
    return fmt::format("{},{}", c.x, c.y);
}

std::string change(std::optional<double> before, std::optional<double> after) {
    if (!before || !after) return "";
    if (*before == *after) return "same";
    if (*before <= 0) return "";
    return fmt::format("{:+.1f} %", 100 * (*after / *before - 1));
}

bool times_are_lengths(const io::PlanContext& context) {
    return !context.asked.in_seconds && unit_speeds(context.asked.mission);
}

const char* time_unit(const io::PlanContext& context) {
    return context.asked.in_seconds             ? "seconds"
           : unit_speeds(context.asked.mission) ? "cells at speed 1"
                                                : "units of time";
}

std::string timed(const char* what, const io::PlanContext& context) {
    return what + std::string(context.asked.in_seconds ? " (s)" : "");
}

}  // namespace waybreaker::apps
