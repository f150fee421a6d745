#include "option.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/range.hpp"
#include "io/excerpt.hpp"
#include "io/option_words.hpp"

namespace waybreaker::apps {
namespace {

template <class Number>
std::optional<Number> number(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

// Two numbers with a comma between them.
template <class Number>
std::optional<std::pair<Number, Number>> pair(std::string_view text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) return std::nullopt;
    const std::optional<Number> first = number<Number>(text.substr(0, comma));
    const std::optional<Number> second = number<Number>(text.substr(comma + 1));
    if (!first || !second) return std::nullopt;
    return std::pair(*first, *second);
}

// "-n,--removals" is called --removals in errors.
std::string long_name(const std::string& names) {
    return names.substr(names.rfind(',') + 1);
}

CLI::Option* add(CLI::App& app, const std::string& name, const std::function<void(const std::string&)>& read,
                 const std::string& type, const std::string& text) {
    return app.add_option_function<std::string>(name, read, text)->type_name(type);
}

}  // namespace

std::optional<double> number_from(std::string_view text) {
    return number<double>(text);
}

std::string shown(std::string_view given) {
    constexpr std::size_t most = 40;
    return io::excerpt(given, most);
}

CLI::Option* add_cell(CLI::App& app, const std::string& name, std::optional<Cell>& value, const std::string& text) {
    const auto read = [name, &value](const std::string& given) {
        const auto cell = pair<int>(given);
        if (!cell || std::min(cell->first, cell->second) < 0 || std::max(cell->first, cell->second) >= max_side) {
            throw CLI::ValidationError(
                name, fmt::format("'{}' is not a cell: X,Y are two whole numbers from 0 to {}, such as 12,20",
                                  shown(given), max_side - 1));
        }
        value = Cell{cell->first, cell->second};
    };
    return add(app, name, read, "X,Y", text);
}

CLI::Option* add_lon_lat(CLI::App& app, const std::string& name, double& lon, double& lat, const std::string& text) {
    const auto read = [name, &lon, &lat](const std::string& given) {
        const auto point = pair<double>(given);
        // Not "> 180", so that "nan" is refused.
        if (!point || !(std::abs(point->first) <= 180) || !(std::abs(point->second) <= 90)) {
            throw CLI::ValidationError(
                name, fmt::format("'{}' is not a place: LON,LAT are degrees east and north, such as 13.41,52.52",
                                  shown(given)));
        }
        lon = point->first;
        lat = point->second;
    };
    return add(app, name, read, "LON,LAT", text);
}

CLI::Option* add_box(CLI::App& app, const std::string& name, std::optional<std::array<double, 4>>& value,
                     const std::string& text) {
    const auto read = [name, &value](const std::string& given) {
        std::array<double, 4> box{};
        const std::vector<std::string> edges = CLI::detail::split(given + ",", ',');
        bool good = edges.size() == box.size();
        for (std::size_t i = 0; good && i < box.size(); ++i) {
            const auto edge = number<double>(edges[i]);
            good = edge && std::abs(*edge) <= 180;
            box[i] = edge.value_or(0);
        }
        if (!good) {
            throw CLI::ValidationError(
                name, fmt::format("'{}' is no box: W,S,E,N are its edges in degrees, such as 13.37,52.51,13.41,52.53",
                                  shown(given)));
        }
        value = box;
    };
    return add(app, name, read, "W,S,E,N", text);
}

CLI::Option* add_count(CLI::App& app, const std::string& name, const std::function<void(std::int64_t)>& assign,
                       std::int64_t least, std::int64_t most, const std::string& text) {
    const auto read = [name, assign, least, most](const std::string& given) {
        const auto count = number<std::int64_t>(given);
        if (!count || *count < least || *count > most) {
            throw CLI::ValidationError(
                long_name(name), fmt::format("'{}' is not a whole number from {} to {}", shown(given), least, most));
        }
        assign(*count);
    };
    return add(app, name, read, "N", text);
}

CLI::Option* add_number(CLI::App& app, const std::string& name, const std::function<void(double)>& assign, Range range,
                        const std::string& type, const std::string& text) {
    const auto read = [name, assign, range](const std::string& given) {
        const auto value = number<double>(given);
        // Not "< least", so that "nan" is refused.
        if (!value || !(*value >= range.least && *value <= range.most)) {
            throw CLI::ValidationError(long_name(name), fmt::format("'{}' is not a number from {} to {}", shown(given),
                                                                    number_text(range.least), number_text(range.most)));
        }
        assign(*value);
    };
    return add(app, name, read, type, text);
}

std::optional<double> share_from(std::string_view text) {
    const bool percent = text.ends_with('%');
    const auto value = number<double>(text.substr(0, text.size() - (percent ? 1 : 0)));
    if (!value) return std::nullopt;
    const double share = percent ? *value / 100 : *value;
    if (!(share >= 0 && share <= 1)) return std::nullopt;
    return share;
}

CLI::Option* add_share(CLI::App& app, const std::string& name, double& value, const std::string& text) {
    const auto read = [name, &value](const std::string& given) {
        const std::optional<double> share = share_from(given);
        if (!share) {
            throw CLI::ValidationError(
                name, fmt::format("'{}' is not a share from 0 to 1, such as 0.1 or 10%", shown(given)));
        }
        value = *share;
    };
    return add(app, name, read, "SHARE", text);
}

CLI::Option* add_length(CLI::App& app, const std::string& name, std::optional<double>& value, double most,
                        const std::string& text) {
    return add_number(
        app, name, [&value](double length) { value = length; }, {0, most}, "CELLS", text);
}

CLI::Option* add_obstacles(CLI::App& app, const std::string& name, std::vector<ObstacleId>& value,
                           const std::string& text) {
    const auto read = [name, &value](const std::string& given) {
        for (const std::string& word : CLI::detail::split(given + ",", ',')) {
            const auto id = number<std::uint32_t>(word);
            if (!id || *id == 0) {
                throw CLI::ValidationError(
                    name, fmt::format("'{}' is not a list of obstacles: ID,... are their numbers, such as 17,4",
                                      shown(given)));
            }
            value.push_back({*id});
        }
    };
    return add(app, name, read, "ID,...", text);
}

CLI::Option* add_file(CLI::App& app, const std::string& name, std::string& value, const std::string& text,
                      const std::string& type) {
    const auto read = [name, &value](const std::string& given) {
        if (given.empty()) throw CLI::ValidationError(long_name(name), "the name of a file is missing");
        value = given;
    };
    const bool positional = name.front() != '-';
    return add(app, name, read, positional ? "" : type, text);
}

CLI::Option* add_text(CLI::App& app, const std::string& name, std::string& value, const std::string& type,
                      const std::string& text) {
    const auto read = [name, type, &value](const std::string& given) {
        if (given.empty()) throw CLI::ValidationError(long_name(name), fmt::format("{} is missing", type));
        value = given;
    };
    return add(app, name, read, type, text);
}

CLI::Option* add_files(CLI::App& app, const std::string& name, std::vector<std::string>& value,
                       const std::string& text) {
    const auto read = [name, &value](const std::vector<std::string>& given) {
        if (std::ranges::find(given, "") != given.end()) {
            throw CLI::ValidationError(long_name(name), "the name of a file is missing");
        }
        value = given;
    };
    return app.add_option_function<std::vector<std::string>>(name, read, text)->type_name("")->required();
}

CLI::Option* add_word(CLI::App& app, const std::string& name, const std::vector<std::string>& words,
                      const std::function<void(std::size_t)>& assign, const std::string& text) {
    const auto read = [name, words, assign](const std::string& given) {
        const auto word = std::find(words.begin(), words.end(), given);
        if (word == words.end()) {
            throw CLI::ValidationError(name,
                                       fmt::format("'{}' is unknown; use {}", shown(given), fmt::join(words, ", ")));
        }
        assign(std::size_t(word - words.begin()));
    };
    return add(app, name, read, fmt::format("{}", fmt::join(words, "|")), text);
}

CLI::Option* add_connectivity(CLI::App& app, Connectivity& value) {
    const Choices<Connectivity> choices{{"4", Connectivity::four}, {"8", Connectivity::eight}};
    return add_choice(app, "--connectivity", choices, value,
                      "Blocked cells with a common side (4) or corner (8) are one obstacle; for maps without labels "
                      "(default: 4)");
}

void add_image_reading(CLI::App& app, io::ImageReading& value) {
    const auto read = [&value](const std::string& given) {
        const auto share = number<double>(given);
        if (!share || !(*share > 0 && *share <= 1)) {
            throw CLI::ValidationError("--threshold",
                                       fmt::format("'{}' is not a share above 0 and up to 1", shown(given)));
        }
        value.threshold = share;
    };
    add(app, "--threshold", read, "SHARE",
        "Of maps that are images: cells at least so dark, or of a ROS map so occupied, are blocked (default: 0.5 of "
        "images, 1 of ROS maps)");
    app.add_flag("--unknown-free", value.unknown_free, "Of ROS maps: cells of unknown occupancy are free");
    add_choice(app, "--nav2", io::nav2_words, value.nav2,
               "Of ROS maps: read the image as nav2 does since May 2025 (Jazzy and later), or as it did before "
               "(default: jazzy)");
}

std::vector<std::string> words_of(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    const bool placeholder = std::any_of(type.begin(), type.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
    return placeholder || type.empty() ? std::vector<std::string>() : CLI::detail::split(type, '|');
}

}  // namespace waybreaker::apps
