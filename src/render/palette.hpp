// The style of a picture: colours, those of the light page (Okabe, Ito 2008; studio/tests/map/viewport/theme.test.ts
// tests how far apart they are for colour-blind readers and in greyscale), and sizes. Sizes are in thousandths of the
// picture's width, so that a picture looks the same at 600 and at 2000 pixels.
#pragma once

#include <array>
#include <string_view>

namespace waybreaker::render {

namespace colour {
inline constexpr std::string_view paper = "#faf8f4";
inline constexpr std::string_view street = "#fffefb";
inline constexpr std::string_view road = "#f1e9da";  // beneath the rest, as what follows
inline constexpr std::string_view rail = "#cfc7ba";
inline constexpr std::string_view water = "#d6e6ee";
inline constexpr std::string_view green = "#e7f0dc";
inline constexpr std::string_view frame = "#cdc5b8";
inline constexpr std::string_view obstacle = "#dcd4c8";
inline constexpr std::string_view obstacle_edge = "#a89e8d";
inline constexpr std::string_view barrier = "#a8885f";  // a wall, fence or hedge
inline constexpr std::string_view barrier_edge = "#785a30";
inline constexpr std::string_view fixed_obstacle = "#a89f93";  // cannot be removed
inline constexpr std::string_view fixed_obstacle_edge = "#736a5e";
inline constexpr std::string_view deep_water = "#89b8d9";  // that nobody drives through
inline constexpr std::string_view shore = "#4c7f9f";
inline constexpr std::string_view cliff = "#776d62";  // a step of the ground
inline constexpr std::string_view cliff_edge = "#463f36";
inline constexpr std::string_view forbidden = "#d7beca";
inline constexpr std::string_view forbidden_edge = "#8d6f80";
inline constexpr std::string_view off_road = "#d0dfb8";  // beside the roads that a truck keeps to
inline constexpr std::string_view off_road_edge = "#7f8a66";
inline constexpr std::string_view unknown = "#efece6";  // nobody knows what is there
inline constexpr std::string_view unknown_edge = "#6a635a";
inline constexpr std::string_view removed = "#d55e00";       // vermilion
inline constexpr std::string_view removed_tint = "#ffe2cc";  // under the hatching
inline constexpr std::string_view breach = "#b84a00";        // vermilion, dark enough to carry white figures
inline constexpr std::string_view ground = "#0072b2";        // blue
inline constexpr std::string_view air = "#e69f00";           // orange
inline constexpr std::string_view air_edge = "#6b4300";      // gives orange its contrast on white
inline constexpr std::string_view no_fly = "#9c1f6e";        // of zones, over a tint
inline constexpr std::string_view keep_out = "#3d3a8c";
inline constexpr std::string_view ink = "#26231f";
inline constexpr std::string_view faded_ink = "#6a635a";
inline constexpr std::string_view halo = "#ffffff";
// Ground by when it is reached, soonest first; each lighter than the one before, so that they print in grey.
inline constexpr std::array<std::string_view, 6> bands{"#095d6c", "#208089", "#42a3a3",
                                                       "#74c4b9", "#a8decf", "#dbf4e8"};
// Of a team's vehicles; those after the last begin again with another pattern.
inline constexpr std::array<std::string_view, 10> vehicles{"#0072b2", "#d41972", "#065605", "#6c2787", "#816339",
                                                           "#8150ea", "#34080a", "#2c39ca", "#690a36", "#110d72"};
// Of its aircraft, dashed and with an edge; those after the last begin again.
inline constexpr std::array<std::string_view, 4> fleet{air, "#f6e27a", "#bd8748", "#f0c09a"};
}  // namespace colour

namespace size {
inline constexpr double margin = 30;
inline constexpr double text = 17.5;
inline constexpr double small_text = 14.5;
inline constexpr double headline = 20;
inline constexpr double title = 27;
inline constexpr double row = 29;       // from one line of the legend to the next
inline constexpr double note_row = 21;  // of notes
inline constexpr double ground_path = 7.5;
inline constexpr double team_path = 5;
inline constexpr double air_path = 4;  // narrower: where both run together, one sees both
inline constexpr double path_before = 2.4;
inline constexpr double edge = 0.7;  // of an obstacle
inline constexpr double removed_edge = 1.7;
inline constexpr double breach_label = 11;  // radius
inline constexpr double start = 9.5;        // radius
inline constexpr double start_at_goal = 22;
inline constexpr double base = 10;  // half the side of its plate
inline constexpr double goal = 15;  // radius of the star
inline constexpr double place = 9;  // radius of the one that counts for most
}  // namespace size

}  // namespace waybreaker::render
