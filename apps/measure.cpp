#include "measure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/range.hpp"
#include "geotiff/georeference.hpp"
#include "io/map_frame.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

std::optional<double> number(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

// The number before one of the units, in what they measure.
std::optional<double> with_unit(std::string_view text, const Units& units) {
    for (const auto& [name, size] : units) {
        if (!text.ends_with(name)) continue;
        if (const auto value = number(text.substr(0, text.size() - name.size()))) return *value * size;
    }
    return std::nullopt;
}

std::string names_of(const Units& units) {
    std::vector<std::string_view> names;
    for (const Unit& unit : units) names.push_back(unit.name);
    return fmt::format("{}", fmt::join(names, " or "));
}

InputError no_metres(const std::string& option, const std::string& text, const io::MapFile& map) {
    return InputError(fmt::format("{} {}: {} does not say how many metres a cell has; --cell-size METRES does", option,
                                  text, map.source));
}

std::string no_cell(const std::string& text) {
    const bool fraction = text.find('.') != std::string::npos;
    return fmt::format("'{}' is not a cell: X,Y are two whole numbers from 0 to {}, such as 12,20{}", shown(text),
                       max_side - 1, fraction ? "; --lonlat takes degrees, --map-metres metres" : "");
}

// "Zenklova (street), Zelená (street), ...": the first few.
std::string names_of(const std::vector<site::NamedPlace>& places) {
    constexpr std::size_t most = 8;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min(places.size(), most); ++i) {
        names.push_back(fmt::format("{} ({})", places[i].name, places[i].what));
    }
    if (places.size() > most) names.emplace_back("...");
    return fmt::format("{}", fmt::join(names, ", "));
}

// A cell given as two whole numbers, which may be any.
Cell cell_on(const io::MapFile& map, Point cell, const GivenPlace& place, const std::string& extent) {
    const bool inside = cell.x >= 0 && cell.y >= 0 && cell.x < map.map.width() && cell.y < map.map.height();
    if (!inside) {
        throw InputError(
            fmt::format("{} {} is not on {}, which reaches {}", place.option, place.text, map.source, extent));
    }
    return {int(cell.x), int(cell.y)};
}

GivenPlace given_place(const std::string& name, const std::string& given) {
    if (is_name(given)) return {.option = name, .text = given, .is_name = true};
    const std::size_t comma = given.find(',');
    if (comma == std::string::npos) {
        throw CLI::ValidationError(
            name, fmt::format("'{}' is not a place: two numbers are needed, with a comma and no blank between "
                              "them, such as 12,20",
                              shown(given)));
    }
    const auto x = number(std::string_view(given).substr(0, comma));
    const auto y = number(std::string_view(given).substr(comma + 1));
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {.option = name, .text = given, .numbers = {x.value_or(none), y.value_or(none)}};
}

}  // namespace

// Letters, without a comma or with a blank behind it.
bool is_name(std::string_view text) {
    const auto is_letter = [](char c) {
        const bool other_language = (static_cast<unsigned char>(c) & 0x80U) != 0;
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || other_language;
    };
    const std::size_t comma = text.find(',');
    const bool blank = comma != std::string_view::npos && text.substr(comma).starts_with(", ");
    return (comma == std::string_view::npos || blank) && std::ranges::any_of(text, is_letter);
}

CLI::Option* add_measure(CLI::App& app, const std::string& name, std::optional<Measure>& value, Range range,
                         const Units& units, const std::string& type, const std::string& text) {
    const auto read = [name, range, units, &value](const std::string& given) {
        if (const auto bare = number(given); bare && *bare >= range.least && *bare <= range.most) {
            value = Measure{name, given, *bare, false};
        } else if (const auto metric = with_unit(given, units); metric && *metric >= 0) {
            value = Measure{name, given, *metric, true};
        } else {
            throw CLI::ValidationError(
                name, fmt::format("'{}' is not a number from {} to {}, nor one with the unit {} behind it",
                                  shown(given), number_text(range.least), number_text(range.most), names_of(units)));
        }
    };
    return app.add_option_function<std::string>(name, read, text)->type_name(type);
}

CLI::Option* add_time_limit(CLI::App& app, const std::string& name, const std::function<void(double)>& assign,
                            const std::string& text) {
    const auto read = [name, assign](const std::string& given) {
        std::optional<double> limit = given == "none" ? std::numeric_limits<double>::infinity() : number(given);
        if (!limit) limit = with_unit(given, time_units);
        if (!limit || !(*limit > 0)) {
            throw CLI::ValidationError(
                name,
                fmt::format("'{}' is neither a number of seconds above 0, such as 30 or 2min, nor none", shown(given)));
        }
        assign(*limit);
    };
    return app.add_option_function<std::string>(name, read, text)->type_name("SECONDS|none");
}

double in_cells(const Measure& measure, const io::MapFile& map, Range range) {
    if (!measure.metric) return measure.value;
    if (!map.has_metres()) throw no_metres(measure.option, measure.text, map);
    const double cells = measure.value / map.cell_size;
    if (cells >= range.least && cells <= range.most) return cells;
    throw InputError(fmt::format("{} {} is {:.6g} in cells of {:.6g} m; from {} to {} is possible", measure.option,
                                 measure.text, cells, map.cell_size, number_text(range.least),
                                 number_text(range.most)));
}

CLI::Option* add_place(CLI::App& app, const std::string& name, std::optional<GivenPlace>& value,
                       const std::string& text) {
    const auto read = [name, &value](const std::string& given) { value = given_place(name, given); };
    return app.add_option_function<std::string>(name, read, text)->type_name("X,Y|NAME");
}

CLI::Option* add_places(CLI::App& app, const std::string& name, std::vector<GivenPlace>& values,
                        const std::string& text) {
    const auto read = [name, &values](const std::vector<std::string>& all) {
        for (const std::string& given : all) values.push_back(given_place(name, given));
    };
    return app.add_option_function<std::vector<std::string>>(name, read, text)->type_name("X,Y|NAME ...");
}

Cell cell_of(const GivenPlace& place) {
    const auto [x, y] = place.numbers;
    const auto good = [](double number) { return number >= 0 && number < max_side && number == std::floor(number); };
    const bool whole = place.text.find_first_not_of("0123456789,") == std::string::npos;
    if (!good(x) || !good(y) || !whole) {
        throw InputError(place.option + ": " + no_cell(place.text));
    }
    return {int(x), int(y)};
}

void validate_lon_lat(const GivenPlace& place) {
    const auto [lon, lat] = place.numbers;
    if (std::abs(lon) <= 180 && std::abs(lat) <= 90) return;
    throw InputError(fmt::format("{}: '{}' is not a place: LON,LAT are degrees east and north, such as 13.41,52.52",
                                 place.option, shown(place.text)));
}

void validate_metres(const GivenPlace& place) {
    if (std::isfinite(place.numbers[0]) && std::isfinite(place.numbers[1])) return;
    throw InputError(fmt::format("{}: '{}' is not a place: X,Y are metres of the map's frame, such as -1.5,0.25",
                                 place.option, shown(place.text)));
}

Cell cell_at_lon_lat(const GivenPlace& place, const io::MapFile& map) {
    validate_lon_lat(place);
    const auto [lon, lat] = place.numbers;
    if (!map.georeference) {
        throw InputError(fmt::format("--lonlat: {} does not say where on earth it lies", map.source));
    }
    const geotiff::ToLonLat to_lon_lat(*map.georeference);
    const auto [west, north] = to_lon_lat(-0.5, -0.5);
    const auto [east, south] = to_lon_lat(map.map.width() - 0.5, map.map.height() - 0.5);
    const std::string extent =
        fmt::format("from {:.6f},{:.6f} in the south-west to {:.6f},{:.6f}", west, south, east, north);
    const Point point = geotiff::FromLonLat(*map.georeference)({Point(lon, lat)}).front();
    return cell_on(map, {std::floor(point.x + 0.5), std::floor(point.y + 0.5)}, place, extent);
}

site::NamedPlace place_called(const GivenPlace& place, const io::MapFile& map) {
    using How = site::PlacesFound::How;
    const site::PlacesFound found = site::places_called(place.text, map.map, map.annotations);
    const std::string asked = fmt::format("{} '{}'", place.option, shown(place.text));
    if (found.places.empty()) {
        throw InputError(
            fmt::format("{}: nothing on {} is called so; X,Y takes a cell, --lonlat degrees", asked, map.source));
    }
    if (found.how == How::contains || found.places.size() > 1) {
        throw InputError(
            fmt::format("{}: {} on {}: {}", asked,
                        found.how == How::contains ? "no name begins so, but it is in these" : "several names begin so",
                        map.source, names_of(found.places)));
    }
    return found.places.front();
}

Cell cell_at_metres(const GivenPlace& place, const io::MapFile& map) {
    validate_metres(place);
    if (!map.has_metres()) throw no_metres("--map-metres with " + place.option, place.text, map);
    const io::MapFrame frame(map);
    const Point low = frame.origin();
    const std::string extent =
        fmt::format("from {:.10g},{:.10g} in its lower left to {:.10g},{:.10g}", low.x, low.y,
                    low.x + map.map.width() * map.cell_size, low.y + map.map.height() * map.cell_size);
    return cell_on(map, frame.cell({place.numbers[0], place.numbers[1]}), place, extent);
}

}  // namespace waybreaker::apps
