// Overlays: what the day brings (a flood, debris, a closed street), laid over a map.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "site/described_map.hpp"

namespace waybreaker::site {

// What the things of an overlay are.
enum class OverlayUse : std::uint8_t {
    water,   // bars for ever, but leaves bridges open
    debris,  // lies on open ground and can be removed
    closed,  // bars for ever, bridges too
    wall,    // stands on open ground and can be destroyed
    free     // opens whatever stands there
};

// What people call them, in their order.
inline constexpr std::array<std::string_view, 5> overlay_use_words{"water", "debris", "closed", "wall", "free"};

// What is laid over a map: the things of a file, and what they are.
struct OverlaySource {
    std::string file;
    OverlayUse use = OverlayUse::water;
    double width = 0;  // of lines, and of points as discs, in metres, where they do not say a `width` of their own
    friend bool operator==(const OverlaySource&, const OverlaySource&) = default;
};

struct Overlay {
    std::string name = {};  // what titles call it
    OverlayUse use = OverlayUse::water;
    // Of the map's size: a label, a name, weight and breach time for each thing. The rest follows from the use.
    LabelLayer things = {};
};

// Each thing is an obstacle of its own, on the cells that it takes:
// - `water` and `closed` take free cells and those that can be destroyed: who destroys a house in the flood finds the
//   flood. What bars for ever stays what it was, and water leaves the map's bridges as they are.
// - `debris` and `wall` take free cells; what stands there stays.
// - `free` makes no obstacle.
// An obstacle that keeps a cell keeps its name, kind, tags, parts, weight and breach time. The title says what was laid
// over the map. Throws InputError if the overlay is not of the map's size.
DescribedMap laid_over(const Map& map, Annotations annotations, const Overlay& overlay);

// What the user should know before an overlay is laid over a map, a line; empty if nothing.
std::string doubt(const Annotations& annotations, const Overlay& overlay);

}  // namespace waybreaker::site
