// Lengths, speeds, times and places of a mission as people give them: in cells, or in metres, seconds and degrees.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/map_file.hpp"
#include "option.hpp"
#include "site/named_places.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::apps {

// A number of cells, units of time, or cells per unit of time; or of metres, seconds, or metres per second.
struct Measure {
    std::string option;  // that gave it
    std::string text;    // as given
    double value = 0;
    bool metric = false;
};

// What may stand behind a number, and how many metres, seconds, or metres per second one of it is.
struct Unit {
    std::string_view name;
    double size;
};
using Units = std::vector<Unit>;

inline const Units length_units{{"m", 1}};
inline const Units time_units{{"s", 1}, {"min", 60}};
inline const Units speed_units{{"m/s", 1}, {"km/h", 1 / 3.6}};

// "0.8", which must be in the range, or with one of the units behind it: "0.8m".
CLI::Option* add_measure(CLI::App& app, const std::string& name, std::optional<Measure>& value, Range range,
                         const Units& units, const std::string& type, const std::string& text);

// A number of seconds above 0, also as 30s or 2min; or "none".
CLI::Option* add_time_limit(CLI::App& app, const std::string& name, const std::function<void(double)>& assign,
                            const std::string& text);

// A length or a speed in cells. Throws InputError, naming the option, if it is metric, and the map has no metres, or
// they are out of range.
double in_cells(const Measure& measure, const io::MapFile& map, Range range);

inline constexpr Range radii{0, 32};  // cells, the room between agents as well
inline constexpr Range speeds{least_speed, most_speed};
inline constexpr Range breach_times{0, most_breach_time};

// "12,20" or "13.3777,52.5163", or a name such as "Zenklova". What is no number is NaN: only the other options say what
// is asked for instead.
struct GivenPlace {
    std::string option;
    std::string text;
    std::array<double, 2> numbers{};
    bool is_name = false;
};

CLI::Option* add_place(CLI::App& app, const std::string& name, std::optional<GivenPlace>& value,
                       const std::string& text);
// Any number of them.
CLI::Option* add_places(CLI::App& app, const std::string& name, std::vector<GivenPlace>& values,
                        const std::string& text);

// The cell; or the one that longitude and latitude, or metres of the map's frame, lie in. Throw InputError, naming the
// option, if the numbers are no such place, or the place is not on the map.
Cell cell_of(const GivenPlace& place);
Cell cell_at_lon_lat(const GivenPlace& place, const io::MapFile& map);
Cell cell_at_metres(const GivenPlace& place, const io::MapFile& map);
// What the map calls so. Throws InputError, with what else could be meant, if nothing is called so or several things
// are.
site::NamedPlace place_called(const GivenPlace& place, const io::MapFile& map);
// Whether a text names a place and gives no numbers: "17. listopadu", "Berlin, Mitte".
bool is_name(std::string_view text);
// The same of what can be said before there is a map.
void validate_lon_lat(const GivenPlace& place);
void validate_metres(const GivenPlace& place);

}  // namespace waybreaker::apps
