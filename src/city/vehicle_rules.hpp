// What vehicles may and can do, by the tags that speak of them.
#pragma once

#include <initializer_list>
#include <string_view>
#include <vector>

#include "city/ground_rules.hpp"

namespace waybreaker::city {

struct Vehicle {
    double width;   // metres
    double height;  // metres
    double mass;    // tonnes
    // Keys that tell the vehicle what the general `access` does not. [Key:access]
    std::vector<std::string_view> modes;
    bool wheels;
};

const Vehicle& vehicle(Profile profile);

bool says_one_of(const TagSet& tags, std::string_view key, std::initializer_list<std::string_view> values);

bool is_closed(const TagSet& tags, std::string_view key);

// The vehicle's own key speaks before the general one.
bool may_enter(const TagSet& tags, Profile profile);

// Whether the vehicle's own key lets it in where others of its kind stay out.
bool is_invited(const TagSet& tags, Profile profile);

// Whether it is within what `maxwidth`, `maxheight` and `maxweight` allow.
bool is_within_limits(const TagSet& tags, Profile profile);

}  // namespace waybreaker::city
