// Cuts lines and areas in two where they cross 180 degrees, as RFC 7946, section 3.1.9, asks.
#pragma once

#include <array>
#include <vector>

namespace waybreaker::io {

using LonLat = std::array<double, 2>;  // from -180 to 180, and from -90 to 90

// A line and, for each of its places, a time.
struct TimedLine {
    std::vector<LonLat> places;
    std::vector<double> times;
};

// The parts of a line. One ends at 180 degrees and the next begins at -180, or the other way round, at one time.
std::vector<TimedLine> cut_line(const TimedLine& line);

// An outer ring that runs counterclockwise, then its holes, clockwise. The last place of a ring is its first.
using LonLatPolygon = std::vector<std::vector<LonLat>>;

// The parts of an area; the area itself if it crosses nothing.
std::vector<LonLatPolygon> cut_polygon(const LonLatPolygon& polygon);

}  // namespace waybreaker::io
