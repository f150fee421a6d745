// Footprints: the buildings, walls, waters ... of a vector source inside a window, in the window's coordinates.
#pragma once

#include <ogr_geometry.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "city/features.hpp"
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
    std::unique_ptr<OGRGeometry> data = {};  // as features.hpp has it
    // Obstacles anywhere in the source that are left out because they have no coordinates, or such as are no numbers;
    // not counted in sources with an index of places.
    std::size_t shapeless = 0;
    std::vector<CutArea> cut = {};  // that would be obstacles if the source had their outlines whole
    osm::Defects defects = {};
};

// `cell` is the least width of lines. Throws InputError if the source cannot be read or can hold nothing of that kind,
// or if a filter matches nothing in all of it.
Footprints read_footprints(const std::string& source, const Window& window, const ObstacleChoice& choice, double cell);

// That there are no obstacles in the window, and where the source has some. Throws InputError if it cannot be read.
InputError nothing_in_window(const std::string& source, const ObstacleChoice& choice);

// Calls `visit` with the outline of each building that stands in the way, in degrees (WGS84), in one scan of the
// source. Gives the box of what the source says it has data of; empty if it does not say. Throws InputError if it
// cannot be read.
OGREnvelope visit_buildings(const std::string& source, const std::function<void(const OGRGeometry& outline)>& visit);

// Of a shape's part within a rectangle.
double area_inside(const OGRGeometry& shape, const OGREnvelope& bounds);

}  // namespace waybreaker::city
