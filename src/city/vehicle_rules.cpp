#include "city/vehicle_rules.hpp"

#include <algorithm>
#include <array>

#include "city/measures.hpp"

namespace waybreaker::city {

// The truck is the largest that Directive 96/53/EC lets drive everywhere: 2.55 m wide, 4 m high, 40 t. Nothing that is
// signposted is too low or too weak for the others.
const Vehicle& vehicle(Profile profile) {
    static const Vehicle rover{site::vehicle_width(Profile::rover), 0, 0, {"foot"}, true};
    static const Vehicle truck{site::vehicle_width(Profile::truck), 4, 40, {"hgv", "motor_vehicle", "vehicle"}, true};
    static const Vehicle walker{site::vehicle_width(Profile::walker), 0, 0, {"foot"}, false};
    return profile == Profile::truck ? truck : profile == Profile::walker ? walker : rover;
}

bool says_one_of(const TagSet& tags, std::string_view key, std::initializer_list<std::string_view> values) {
    return std::any_of(values.begin(), values.end(), [&](std::string_view value) { return tags.is(key, value); });
}

bool is_closed(const TagSet& tags, std::string_view key) {
    return says_one_of(tags, key, {"no", "private"});
}

bool may_enter(const TagSet& tags, Profile profile) {
    for (const std::string_view mode : vehicle(profile).modes) {
        if (tags.find(mode) != nullptr) return !is_closed(tags, mode);
    }
    return !is_closed(tags, "access");
}

bool is_invited(const TagSet& tags, Profile profile) {
    for (const std::string_view mode : vehicle(profile).modes) {
        if (tags.find(mode) != nullptr) return says_one_of(tags, mode, {"yes", "designated", "permissive", "official"});
    }
    return false;
}

// [Key:maxwidth], [Key:maxheight], [Key:maxweight], [Key:maxweightrating]: of vehicles, so that they do not concern who
// walks. What is physical holds whatever the sign says.
bool is_within_limits(const TagSet& tags, Profile profile) {
    const Vehicle& who = vehicle(profile);
    if (who.mass == 0) return true;
    const auto allows = [&](std::string_view key, double most, auto read) {
        const std::string* text = tags.find(key);
        return text == nullptr || read(*text).value_or(most) >= most;
    };
    constexpr std::array widths{"maxwidth", "maxwidth:physical"};
    constexpr std::array heights{"maxheight", "maxheight:physical"};
    constexpr std::array masses{"maxweight", "maxweight:hgv", "maxweightrating", "maxweightrating:hgv"};
    const auto all = [&](const auto& keys, double most, auto read) {
        return std::all_of(keys.begin(), keys.end(), [&](const char* key) { return allows(key, most, read); });
    };
    return all(widths, who.width, metres_of) && all(heights, who.height, metres_of) && all(masses, who.mass, tonnes_of);
}

}  // namespace waybreaker::city
