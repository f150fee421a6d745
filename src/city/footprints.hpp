// Footprints: the buildings, walls, waters ... of a vector source inside a window, in the window's coordinates.
#pragma once

#include <ogr_geometry.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "city/obstacle_choice.hpp"
#include "city/vector_source.hpp"
#include "site/obstacle_kinds.hpp"
#include "waybreaker/map.hpp"

namespace waybreaker::city {

struct Footprint {
    std::unique_ptr<OGRGeometry> shape;  // in the window's system, not clipped; lines as strips
    double area = 0;                     // of its part inside the window, in square metres, > 0
    ObstacleAttributes attributes = {};  // of its source; quantities that go by area are not in here
    std::string name = {};               // what people call it, or its address; empty where unknown
    site::ObstacleKind kind = site::ObstacleKind::unknown;
    bool sheltered = false;              // not destructible because of what it is, though nobody said so
    std::vector<std::string> tags = {};  // those that maps keep, such as "building=church"
};

struct Footprints {
    std::vector<Footprint> list;  // in the source's order, areas before lines
    bool from_osm = false;        // the source is made of OpenStreetMap data
    OGREnvelope extent = {};      // what the source has data of, in the window's system; empty if it does not say
    // Obstacles anywhere in the source that are left out because they have no coordinates, or such as are no numbers;
    // not counted in sources with an index of places.
    std::size_t shapeless = 0;
};

// One scan of the source, and another for lines if they are wanted; `cell` is the least width of lines. Throws
// InputError if it cannot be read, holds nothing of that kind, or nothing in the window (the message says where its
// data lies), or if a filter matches nothing in the whole source.
Footprints read_footprints(const std::string& source, const Window& window, const ObstacleChoice& choice, double cell);

// Calls `visit` with the outline of each building that stands in the way, in degrees (WGS84), in one scan of the
// source. Gives the box of what the source says it has data of; empty if it does not say. Throws InputError if it
// cannot be read.
OGREnvelope visit_buildings(const std::string& source, const std::function<void(const OGRGeometry& outline)>& visit);

// Of a shape's part within a rectangle.
double area_inside(const OGRGeometry& shape, const OGREnvelope& bounds);

}  // namespace waybreaker::city
